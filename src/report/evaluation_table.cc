// SPDX-License-Identifier: Apache-2.0
#include "report/evaluation_table.h"

#include <algorithm>

#include "report/drawing.h"

namespace dorsum {

HtmlTable EvaluationTable(const std::vector<EvaluationRow>& rows) {
  HtmlTable table;
  table.header = {"Model", "RMSE (mm)", "NRMSE", "Points"};
  double largest = 1e-9;
  for (const EvaluationRow& row : rows) largest = std::max(largest, row.rmse_mm);
  for (const EvaluationRow& row : rows) {
    table.rows.push_back({row.model,
                          {FormatNumber(row.rmse_mm, 4), row.rmse_mm / largest},
                          FormatNumber(row.nrmse, 4),
                          std::to_string(row.points)});
  }
  return table;
}

void AddEvaluation(HtmlPage& page, const std::vector<EvaluationRow>& rows) {
  if (rows.empty()) return;
  page.Section(
      "Accuracy",
      "How far the points lie from the known shape. RMSE is the typical height error; NRMSE is the same "
      "error as a share of the range of heights, so a low object has a larger one at the same error.");
  page.Table(EvaluationTable(rows));
}

HtmlTable RowsTable(const std::vector<ReportRow>& rows) {
  HtmlTable table;
  table.first_number = 2;
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.name, row.unit.empty() ? row.value : row.value + " " + row.unit});
  }
  return table;
}

}  // namespace dorsum
