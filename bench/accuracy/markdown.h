// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace dorsum::accuracy {

// "0.0423"; an en dash for what is not a number.
std::string Fixed(double value, int decimals = 4);

// A table in Markdown: its head, then its rows.
class MarkdownTable {
 public:
  explicit MarkdownTable(const std::vector<std::string>& head);
  void Row(const std::vector<std::string>& cells);
  const std::string& text() const { return text_; }

 private:
  std::size_t columns_;
  std::string text_;
};

}  // namespace dorsum::accuracy
