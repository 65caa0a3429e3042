// SPDX-License-Identifier: Apache-2.0
#include "accuracy/limits.h"

#include <cstdio>

#include "base/files.h"
#include "base/toml.h"

namespace dorsum::accuracy {
namespace {

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::string Limit::Text() const {
  if (min && max) return Number(*min) + "–" + Number(*max);
  if (max) return *max == 0.0 ? "0" : "≤ " + Number(*max);
  if (min) return "≥ " + Number(*min);
  return "";
}

Result<LimitTable> ReadLimits(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const toml::table file, ReadTomlFile(path));
  LimitTable limits;
  for (const auto& [group, node] : file) {
    const toml::table* figures = node.as_table();
    if (figures == nullptr) return BadInput(path.string() + ": " + std::string(group.str()) + " is no table");
    for (const auto& [figure, value] : *figures) {
      const toml::table* bounds = value.as_table();
      Limit limit;
      if (bounds != nullptr) {
        limit.min = (*bounds)["min"].value<double>();
        limit.max = (*bounds)["max"].value<double>();
      }
      const std::size_t known = (limit.min ? 1U : 0U) + (limit.max ? 1U : 0U);
      if (known == 0 || bounds->size() != known) {
        return BadInput(path.string() + ": " + std::string(group.str()) + ": " + std::string(figure.str()) +
                        " must be a table of min, max or both");
      }
      limits[std::string(group.str())][std::string(figure.str())] = limit;
    }
  }
  return limits;
}

Status WriteLimits(const std::filesystem::path& path, const std::string& comment, const LimitTable& limits) {
  std::string text = comment;
  for (const auto& [group, figures] : limits) {
    text += "\n[\"" + group + "\"]\n";
    for (const auto& [figure, limit] : figures) {
      std::string bounds;
      if (limit.min) bounds += "min = " + Number(*limit.min);
      if (limit.max) bounds += (bounds.empty() ? "max = " : ", max = ") + Number(*limit.max);
      text += figure + " = { " + bounds + " }\n";
    }
  }
  return WriteFile(path, text);
}

}  // namespace dorsum::accuracy
