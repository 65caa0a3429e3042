// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/html.h"

namespace dorsum {

// One row of the document's Table 5.1.
struct EvaluationRow {
  std::string model;  // "Laser 0", "Merged"
  double rmse_mm = 0.0;
  double nrmse = 0.0;  // RMSE over the range of z; a share, not percent
  std::size_t points = 0;
};

HtmlTable EvaluationTable(const std::vector<EvaluationRow>& rows);

// A named value as text, for tables of results and of settings.
struct ReportRow {
  std::string name, value, unit;
};

// The section "Accuracy" with that table; nothing for no rows.
void AddEvaluation(HtmlPage& page, const std::vector<EvaluationRow>& rows);

// Names and values in two columns.
HtmlTable RowsTable(const std::vector<ReportRow>& rows);

}  // namespace dorsum
