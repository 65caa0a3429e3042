// SPDX-License-Identifier: Apache-2.0
#include "base/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/files.h"
#include "base/toml.h"

namespace dorsum {
namespace {

std::string NumberText(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

Error Refused(const OptionSpec& spec, const std::string& value) {
  std::string allowed;
  if (!spec.choices.empty()) {
    for (const std::string& choice : spec.choices) allowed += (allowed.empty() ? "" : ", ") + choice;
    allowed = "one of: " + allowed;
  } else if (std::holds_alternative<bool*>(spec.target)) {
    allowed = "true or false";
  } else {
    allowed = std::string(std::holds_alternative<int*>(spec.target) ? "a whole number" : "a number") +
              " from " + NumberText(spec.min) + " to " + NumberText(spec.max);
  }
  return UsageError("--" + spec.name + " takes " + allowed + ", not '" + value + "'");
}

template <class T>
bool ParseNumber(const std::string& text, T* out) {
  const char* end = text.data() + text.size();
  const auto [rest, ec] = std::from_chars(text.data(), end, *out);
  return ec == std::errc() && rest == end;
}

Status Assign(const OptionSpec& spec, const std::string& value) {
  if (auto* const* target = std::get_if<double*>(&spec.target)) {
    double number = 0.0;
    if (!ParseNumber(value, &number) || !std::isfinite(number) || number < spec.min || number > spec.max) {
      return Refused(spec, value);
    }
    **target = number;
  } else if (auto* const* whole = std::get_if<int*>(&spec.target)) {
    int number = 0;
    if (!ParseNumber(value, &number) || number < spec.min || number > spec.max) return Refused(spec, value);
    **whole = number;
  } else if (auto* const* flag = std::get_if<bool*>(&spec.target)) {
    if (value != "true" && value != "false") return Refused(spec, value);
    **flag = value == "true";
  } else {
    if (std::find(spec.choices.begin(), spec.choices.end(), value) == spec.choices.end())
      return Refused(spec, value);
    *std::get<std::string*>(spec.target) = value;
  }
  return {};
}

}  // namespace

void OptionTable::Add(std::string name, double* target, double min, double max, std::string help) {
  specs_.push_back({std::move(name), std::move(help), target, min, max, {}});
}
void OptionTable::Add(std::string name, int* target, int min, int max, std::string help) {
  specs_.push_back(
      {std::move(name), std::move(help), target, static_cast<double>(min), static_cast<double>(max), {}});
}
void OptionTable::Add(std::string name, bool* target, std::string help) {
  specs_.push_back({std::move(name), std::move(help), target, 0.0, 1.0, {}});
}
void OptionTable::Add(std::string name, std::string* target, std::vector<std::string> choices,
                      std::string help) {
  specs_.push_back({std::move(name), std::move(help), target, 0.0, 0.0, std::move(choices)});
}

Status OptionTable::Set(const std::string& name, const std::string& value) {
  const auto it =
      std::find_if(specs_.begin(), specs_.end(), [&](const OptionSpec& s) { return s.name == name; });
  if (it == specs_.end()) return UsageError("there is no option '" + name + "'");
  return Assign(*it, value);
}

Status OptionTable::ReadToml(const std::filesystem::path& path, const std::string& section) {
  DORSUM_ASSIGN_OR_RETURN(const toml::table file, ReadTomlFile(path));
  const toml::node* node_of_section = file.get(section);
  if (node_of_section == nullptr) return {};
  const toml::table* table = node_of_section->as_table();
  if (table == nullptr)
    return BadInput(path.string() + ": '" + section + "' must be a table, [" + section + "]");
  for (const auto& [key, node] : *table) {
    std::ostringstream text;
    if (const auto* s = node.as_string()) {
      text << s->get();
    } else {
      node.visit([&](const auto& value) { text << value; });
    }
    if (const Status status = Set(std::string(key.str()), text.str()); !status.ok()) {
      return BadInput(path.string() + ", [" + section + "]: " + status.error().message);
    }
  }
  return {};
}

std::string OptionTable::ValueText(const OptionSpec& spec) {
  if (auto* const* number = std::get_if<double*>(&spec.target)) return NumberText(**number);
  if (auto* const* whole = std::get_if<int*>(&spec.target)) return std::to_string(**whole);
  if (auto* const* flag = std::get_if<bool*>(&spec.target)) return **flag ? "true" : "false";
  return *std::get<std::string*>(spec.target);
}

}  // namespace dorsum
