// SPDX-License-Identifier: Apache-2.0
#include "base/toml.h"

#include <string>

#include "base/files.h"

namespace dorsum {

Result<toml::table> ReadTomlFile(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(path, std::size_t{1} << 20));
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& e) {
    return BadInput(path.string() + ", line " + std::to_string(e.source().begin.line) + ": " +
                    std::string(e.description()));
  }
}

}  // namespace dorsum
