// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"
#include "report/printed_page.h"

namespace dorsum {

struct BoardOptions {
  std::filesystem::path device_path;  // device.toml; empty: the built-in four-laser device
  Paper paper;
  std::vector<std::string> sheets;  // of "chessboard", "first-estimates" and "plan"; empty: all
  bool tile_chessboard = false;     // over several pages where it does not fit on one
};

struct BoardReport {
  struct Sheet {
    std::string name;
    int pages = 0;
    double width_mm = 0.0, height_mm = 0.0;  // of what is printed, without words and rulers
  };
  std::vector<Sheet> sheets;
  std::vector<std::string> files;     // written
  std::vector<std::string> warnings;  // one sentence each
};

// The job behind `dorsum board`: the targets of the calibration series (§3.2) of a device, for printing at
// true scale. `out` is one PDF when its name ends in .pdf, else a folder with a PDF for each sheet. The same
// description gives the same bytes. Nothing is written unless all is well.
Result<BoardReport> PrintBoards(const BoardOptions& options, const std::filesystem::path& out,
                                const Context& context);

Json BoardReportToJson(const BoardReport& report);

}  // namespace dorsum
