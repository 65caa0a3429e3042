// SPDX-License-Identifier: Apache-2.0
#include "jobs/doctor.h"

#include <memory>

#include "cli/commands.h"

namespace dorsum {
namespace {

struct Arguments {
  std::string device, calibration, data = ".";
};

void Run(const Arguments& arguments, Session* session) {
  DoctorRequest request;
  request.device = arguments.device;
  request.calibration_path = arguments.calibration;
  request.data_dir = arguments.data;
  const Result<DoctorReport> report = ExamineDevice(request, session->MakeContext());
  if (!report.ok()) return session->Fail(report.error());
  session->Print(DoctorReportToText(*report), DoctorReportToJson(*report));
  if (!report->healthy()) {
    session->Fail({ErrorCode::kAnswerIsNo, "something is broken; the findings above say what to do"});
  }
}

}  // namespace

void AddDoctor(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c =
      app->add_subcommand("doctor", "Look whether the device works, and say what to do where it does not");
  c->add_option("--device", arguments->device,
                "device description (TOML), or virtual[:SEED]; without it only what this machine has");
  c->add_option("-c,--calibration", arguments->calibration, "calibration.json: does it still fit?");
  c->add_option("--data", arguments->data, "folder where captures go")->capture_default_str();
  AddCommonOptions(c, session);
  c->footer(
      "Exit code 1 where something is broken.\nExample: dorsum doctor --device device.toml -c "
      "calibration.json");
  c->callback([arguments, session] { Run(*arguments, session); });
}

}  // namespace dorsum
