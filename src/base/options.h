// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"

namespace dorsum {

// One adjustable value of a job: bound to its field, so that the field's initialiser is the default.
struct OptionSpec {
  std::string name;  // "mask-open-px": on the command line with --, in TOML as it is
  std::string help;  // one line, with the unit
  std::variant<double*, int*, bool*, std::string*> target;
  double min = 0.0, max = 0.0;       // for numbers
  std::vector<std::string> choices;  // for texts
};

// The one table that feeds defaults, --help, TOML and the window's rows (DESIGN §7.4).
class OptionTable {
 public:
  void Add(std::string name, double* target, double min, double max, std::string help);
  void Add(std::string name, int* target, int min, int max, std::string help);
  void Add(std::string name, bool* target, std::string help);
  void Add(std::string name, std::string* target, std::vector<std::string> choices, std::string help);

  const std::vector<OptionSpec>& specs() const { return specs_; }
  // Sets one option from text; a usage error names the option, the value and what is allowed.
  Status Set(const std::string& name, const std::string& value);
  // Sets all options found in the table `section` of a TOML file; unknown names are errors.
  Status ReadToml(const std::filesystem::path& path, const std::string& section);
  // Current value as text.
  static std::string ValueText(const OptionSpec& spec);

 private:
  std::vector<OptionSpec> specs_;
};

}  // namespace dorsum
