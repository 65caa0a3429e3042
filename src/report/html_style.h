// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace dorsum {

// The style sheet of all reports: light and dark, narrow and wide screens, and paper.
std::string_view ReportStyle();

}  // namespace dorsum
