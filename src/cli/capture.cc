// SPDX-License-Identifier: Apache-2.0
#include "jobs/capture.h"

#include <ctime>
#include <memory>

#include "cli/commands.h"
#include "device/virtual_bench.h"

namespace dorsum {
namespace {

struct Arguments {
  CaptureRequest request;
  std::string out, calibration, device, scene;
};

// What stands before a virtual device; a real one sees for itself.
Status Arrange(const Device& device, const std::string& scene) {
  constexpr const char* kHand = "hand:woman:right:anna";
  if (device.bench) return device.bench->PlaceNamed(scene.empty() ? kHand : scene);
  if (scene.empty()) return {};
  return UsageError("--scene is for a virtual device; before " + device.name + " lies what lies there");
}

// captures/20261122-185901, by the local clock.
std::string FolderOfNow() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[64];
  std::strftime(text, sizeof text, "captures/%Y%m%d-%H%M%S", &local);
  return text;
}

void Run(Arguments arguments, Session* session) {
  if (arguments.out.empty()) arguments.out = FolderOfNow();
  CaptureRequest request = arguments.request;
  request.out_dir = arguments.out;
  request.calibration_path = arguments.calibration;
  const Context context = session->MakeContext();
  Result<Device> device = OpenDevice(arguments.device, context);
  if (!device.ok()) return session->Fail(device.error());
  if (const Status placed = Arrange(*device, arguments.scene); !placed.ok()) {
    return session->Fail(placed.error());
  }
  const Result<CaptureSummary> summary = CaptureToFolder(*device, request, context);
  if (!summary.ok()) return session->Fail(summary.error());
  session->Warn(summary->warnings);
  std::string text;
  for (const std::string& file : summary->files) text += arguments.out + "/" + file + "\n";
  session->Print(text, {{"out", arguments.out},
                        {"files", summary->files},
                        {"retried", summary->retried},
                        {"warnings", summary->warnings}});
}

}  // namespace

void AddCapture(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("capture", "Capture a hand: one picture under the LEDs, one per laser");
  c->add_option("out_dir", arguments->out,
                "folder to write; it appears when the capture is whole (default: captures/DATE-TIME)");
  c->add_option("--device", arguments->device, "device description (TOML), or virtual[:SEED]")->required();
  c->add_option(
      "-c,--calibration", arguments->calibration,
      "calibration.json: also checks that a hand is there, not cut, and that each laser is its own");
  c->add_option("--lasers", arguments->request.lasers, "only these, such as 0,1,3")->delimiter(',');
  c->add_option("--average", arguments->request.average, "frames averaged for each picture")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  c->add_option("--retries", arguments->request.retries,
                "how often a picture is taken again that may get better")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  c->add_option("--scene", arguments->scene,
                "what lies before a virtual device, as in dorsum simulate (default: a hand)");
  AddCommonOptions(c, session);
  c->footer("Example: dorsum capture scan/anna --device device.toml -c calibration.json");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
