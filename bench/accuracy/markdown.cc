// SPDX-License-Identifier: Apache-2.0
#include "accuracy/markdown.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace dorsum::accuracy {

std::string Fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

MarkdownTable::MarkdownTable(const std::vector<std::string>& head) : columns_(head.size()) {
  Row(head);
  Row(std::vector<std::string>(columns_, "---"));
}

void MarkdownTable::Row(const std::vector<std::string>& cells) {
  if (cells.size() != columns_) throw std::logic_error("MarkdownTable: a row of another width");
  for (const std::string& cell : cells) text_ += "| " + cell + " ";
  text_ += "|\n";
}

}  // namespace dorsum::accuracy
