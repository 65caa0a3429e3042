// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "base/heap.h"
#include "base/version.h"
#include "captures/picture_pool.h"
#include "cli/commands.h"

namespace {

// What is wrong with the command line, as one sentence with where to look it up.
std::string UsageSentence(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining();
  const std::vector<CLI::App*> commands = app.get_subcommands();
  std::string sentence = error.what();
  if (commands.empty() && !rest.empty() && rest.front()[0] != '-') {
    sentence = "there is no command " + rest.front();
  } else if (!sentence.empty()) {
    sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  }
  const std::string command = commands.empty() ? "" : commands.front()->get_name() + " ";
  return sentence + "; see dorsum " + command + "--help";
}

int RunProgram(int argc, char** argv) {
  dorsum::Session session;
  CLI::App app("Dorsum: scan the back of a hand with one camera and a few line lasers.");
  app.name("dorsum");
  app.set_version_flag("--version", dorsum::kVersion);
  app.require_subcommand(1);
  app.footer(
      "Each command has a --help with an example. Exit codes: 0 done, 1 the answer is no, 2 wrong usage, 3 "
      "bad "
      "input or\nnowhere to write, 4 device, 5 our fault, 130 interrupted.");
  dorsum::AddSimulate(&app, &session);
  dorsum::AddBoard(&app, &session);
  dorsum::AddCalibrate(&app, &session);
  dorsum::AddCapture(&app, &session);
  dorsum::AddDoctor(&app, &session);
  dorsum::AddStripes(&app, &session);
  dorsum::AddReconstruct(&app, &session);
  dorsum::AddEvaluate(&app, &session);
  dorsum::AddDesign(&app, &session);
  dorsum::AddCampaign(&app, &session);
  dorsum::AddStudio(&app, &session);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (asked) return app.exit(error);  // --help or --version
    session.Fail({dorsum::ErrorCode::kUsage, UsageSentence(app, error)});
  }
  return session.Finish();
}

}  // namespace

int main(int argc, char** argv) {
  dorsum::KeepFreedMemory();
  dorsum::KeepPictureMemory();
  dorsum::CatchInterrupts();
  // FFmpeg would put its own words on the standard error, beside our sentence; -8 is its "quiet".
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  try {
    return RunProgram(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("dorsum: error: there is not enough memory for this\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dorsum: error: this is our fault, please report it: %s\n", error.what());
  }
  return dorsum::ExitCode(dorsum::ErrorCode::kInternal);
}
