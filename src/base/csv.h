// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace dorsum {

// A field of a CSV file (RFC 4180): quoted where it holds a comma, a quote or the end of a line.
std::string CsvField(const std::string& text);

}  // namespace dorsum
