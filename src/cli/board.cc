// SPDX-License-Identifier: Apache-2.0
#include "jobs/board.h"

#include <memory>

#include "cli/commands.h"

namespace dorsum {
namespace {

struct Arguments {
  BoardOptions options;
  std::string out, device, paper = "A4";
};

void Run(const Arguments& arguments, Session* session) {
  BoardOptions options = arguments.options;
  options.device_path = arguments.device;
  const Result<Paper> paper = ParsePaper(arguments.paper);
  if (!paper.ok()) return session->Fail(paper.error());
  options.paper = *paper;
  const Result<BoardReport> report = PrintBoards(options, arguments.out, session->MakeContext());
  if (!report.ok()) return session->Fail(report.error());
  session->Warn(report->warnings);
  std::string text;
  for (const std::string& file : report->files) text += file + "\n";
  session->Print(text, BoardReportToJson(*report));
}

}  // namespace

void AddBoard(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand(
      "board", "Make the calibration targets (§3.2) of a device as PDF, to be printed at true scale");
  c->add_option("-o,--out", arguments->out,
                "a file NAME.pdf with all sheets, or a folder for one PDF per sheet")
      ->required();
  c->add_option("--device", arguments->device,
                "device description (TOML); the built-in four-laser device without it");
  c->add_option("--paper", arguments->paper, "A4, A3, A2, Letter, Legal or WIDTHxHEIGHT in mm")
      ->capture_default_str();
  c->add_option("--sheets", arguments->options.sheets,
                "which ones; all without it: the chessboard, the plane with a line per laser, the plan of "
                "the backplane")
      ->delimiter(',')
      ->check(CLI::IsMember({"chessboard", "first-estimates", "plan"}));
  c->add_flag("--tile-chessboard", arguments->options.tile_chessboard,
              "put a chessboard that is too large for the paper on several pages, to be glued");
  AddCommonOptions(c, session);
  c->footer(
      "Print at 100 %, with no fit to page, and measure the rulers.\n"
      "Example: dorsum board --device device.toml --paper A4 -o targets.pdf");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
