// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include <unistd.h>

#include "cli/commands.h"

namespace dorsum {
namespace {

struct Arguments {
  std::string path, device, calibration;
};

// Ends this process unless it fails.
void Run(const Arguments& arguments, Session* session) {
  std::error_code ec;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ec);
  const std::string program = ec ? "dorsum-studio" : (self.parent_path() / "dorsum-studio").string();
  std::vector<std::string> words = {program};
  if (!arguments.device.empty()) words.insert(words.end(), {"--device", arguments.device});
  if (!arguments.calibration.empty()) words.insert(words.end(), {"--calibration", arguments.calibration});
  if (!arguments.path.empty()) words.push_back(arguments.path);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execvp(program.c_str(), argv.data());
  session->Fail(BadInput("cannot start " + program + ": " + std::strerror(errno) +
                         "; it is installed beside dorsum where Qt 6 was there at the build"));
}

}  // namespace

void AddStudio(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("studio", "Open the window, Dorsum Studio");
  c->add_option("path", arguments->path, "capture folder or PLY file to open");
  c->add_option("--device", arguments->device, "device description (TOML), or virtual[:SEED]");
  c->add_option("-c,--calibration", arguments->calibration, "calibration.json of the device");
  AddCommonOptions(c, session);
  c->footer("Example: dorsum studio --device virtual");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
