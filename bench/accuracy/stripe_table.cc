// SPDX-License-Identifier: Apache-2.0
#include "accuracy/stripe_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include <zlib.h>

namespace dorsum::accuracy {
namespace {

// gzread passes plain files through unchanged.
Result<std::string> ReadUnzipped(const std::filesystem::path& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) return BadInput(path.string() + " cannot be read");
  std::string text;
  std::array<char, 1 << 16> part{};
  int n = 0;
  while ((n = gzread(file, part.data(), part.size())) > 0)
    text.append(part.data(), static_cast<std::size_t>(n));
  gzclose(file);
  if (n < 0) return BadInput(path.string() + " is damaged");
  return text;
}

std::string_view TakeUntil(std::string_view* rest, char end) {
  const std::size_t at = std::min(rest->find(end), rest->size());
  const std::string_view head = rest->substr(0, at);
  rest->remove_prefix(std::min(at + 1, rest->size()));
  return head;
}

constexpr std::array<std::string_view, 6> kColumns = {"order", "v", "u", "z", "material", "irradiance"};

}  // namespace

Result<std::vector<TrueStripe>> ReadStripeTable(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadUnzipped(path));
  std::string_view rest = text;
  std::array<std::size_t, kColumns.size()> column{};
  column.fill(std::string::npos);
  std::string_view header = TakeUntil(&rest, '\n');
  if (header.ends_with('\r')) header.remove_suffix(1);
  std::size_t width = 0;
  for (; !header.empty(); ++width) {
    const auto* const known = std::find(kColumns.begin(), kColumns.end(), TakeUntil(&header, ','));
    if (known != kColumns.end()) column[static_cast<std::size_t>(known - kColumns.begin())] = width;
  }
  if (std::find(column.begin(), column.end(), std::string::npos) != column.end()) {
    return BadInput(path.string() + " lacks one of the columns order, v, u, z, material, irradiance");
  }
  std::vector<TrueStripe> stripes;
  std::vector<double> values(width);
  while (!rest.empty()) {
    std::string_view line = TakeUntil(&rest, '\n');
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) continue;
    for (double& value : values) {
      const std::string_view cell = TakeUntil(&line, ',');
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (error != std::errc() || end != cell.data() + cell.size()) {
        return BadInput(path.string() + " holds \"" + std::string(cell) + "\" where a number belongs");
      }
    }
    stripes.push_back({static_cast<int>(std::lround(values[column[0]])),
                       static_cast<int>(std::lround(values[column[1]])), values[column[2]], values[column[3]],
                       static_cast<int>(std::lround(values[column[4]])), values[column[5]]});
  }
  return stripes;
}

}  // namespace dorsum::accuracy
