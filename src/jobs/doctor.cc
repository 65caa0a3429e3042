// SPDX-License-Identifier: Apache-2.0
#include "jobs/doctor.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include <unistd.h>

#include "calibration/calibration_file.h"
#include "captures/names.h"
#include "device/camera_list.h"
#include "device/device.h"
#include "device/serial_port.h"
#include "device/virtual_bench.h"
#include "jobs/doctor_pictures.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using Health = DoctorFinding::Health;
using Findings = std::vector<DoctorFinding>;

std::string Number(double value, const char* format = "%.1f") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void LookAtCameras(Findings* findings) {
  const std::vector<CameraEntry> cameras = ListCameras();
  if (cameras.empty()) {
    findings->push_back({Health::kNote, "cameras", "this machine has no camera",
                         "plug one in; a network camera or virtual needs none"});
  }
  for (const CameraEntry& camera : cameras) {
    const std::string who = camera.device + (camera.name.empty() ? "" : " (" + camera.name + ")");
    findings->push_back(camera.usable ? DoctorFinding{Health::kFine, "cameras", who + " can be used", ""}
                                      : DoctorFinding{Health::kNote, "cameras", who, camera.problem});
  }
}

void LookAtPorts(Findings* findings) {
  const std::vector<std::string> ports = UsbSerialPorts();
  if (ports.empty()) {
    findings->push_back({Health::kNote, "serial ports", "no serial port of a USB device is there",
                         "plug the light controller in; virtual needs none"});
  }
  for (const std::string& port : ports) {
    if (access(port.c_str(), R_OK | W_OK) == 0) {
      findings->push_back({Health::kFine, "serial ports", port + " may be used", ""});
    } else {
      findings->push_back({Health::kNote, "serial ports", port + " may not be used by you",
                           "sudo usermod -aG dialout $USER, then log in again"});
    }
  }
}

void LookAtDisk(const DoctorRequest& request, Findings* findings) {
  std::error_code ec;
  const fs::space_info space = fs::space(request.data_dir, ec);
  if (ec || access(request.data_dir.c_str(), W_OK) != 0) {
    findings->push_back({Health::kBroken, "disk", request.data_dir.string() + " cannot be written to",
                         "choose another folder, or ask for the right to write there"});
    return;
  }
  const double free_gb = static_cast<double>(space.available) / 1e9;
  const std::string sentence = Number(free_gb) + " GB are free at " + request.data_dir.string();
  if (free_gb < request.min_free_gb) {
    findings->push_back({Health::kBroken, "disk", sentence, "make room: a capture takes some megabytes"});
  } else {
    findings->push_back({Health::kFine, "disk", sentence, ""});
  }
}

double AgeInDays(const fs::path& path) {
  std::error_code ec;
  const auto written = fs::last_write_time(path, ec);
  if (ec) return 0.0;
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count() / 86400.0;
}

std::optional<ReadyCalibration> LookAtCalibration(const DoctorRequest& request, Findings* findings) {
  const fs::path& path = request.calibration_path;
  Result<Calibration> calibration = ReadCalibration(path);
  if (!calibration.ok()) {
    findings->push_back(
        {Health::kBroken, "calibration", calibration.error().message, "calibrate the device"});
    return std::nullopt;
  }
  for (const PartReport& part : calibration->parts) {
    if (part.grade == Grade::kGood) continue;
    const bool bad = part.grade == Grade::kBad;
    findings->push_back({bad ? Health::kBroken : Health::kNote, "calibration",
                         part.part + ": " + part.verdict, "see the report beside " + path.string()});
  }
  const double days = AgeInDays(path);
  const bool old = days > request.old_days;
  findings->push_back({old ? Health::kNote : Health::kFine, "calibration",
                       path.string() + " is " + Number(days) + " days old, made by version " +
                           calibration->version + " with method " + calibration->method,
                       old ? "the check below says whether it still fits" : ""});
  Result<ReadyCalibration> ready = PrepareCalibration(std::move(calibration).value(), path.string());
  if (!ready.ok()) {
    findings->push_back({Health::kBroken, "calibration", ready.error().message, "calibrate the device"});
    return std::nullopt;
  }
  return std::move(ready).value();
}

void LookAtController(Device& device, Findings* findings) {
  const ControllerInfo info = device.lights->info();
  std::string sentence = info.name + ", firmware " + info.firmware_version;
  if (info.silence_limit_s > 0.0) {
    sentence += ": all off after " + Number(info.silence_limit_s) +
                " s without a word from here, a laser after " + Number(info.on_limit_s) + " s";
  }
  findings->push_back({Health::kFine, "light controller", sentence, ""});
}

Status LookAtDevice(Device& device, const ReadyCalibration* calibration, const Context& context,
                    Findings* findings) {
  LookAtController(device, findings);
  const cv::Size size = device.frames->size();
  findings->push_back({Health::kFine, "camera",
                       device.frames->name() + ", " + std::to_string(size.width) + " x " +
                           std::to_string(size.height) + " pixels",
                       ""});
  for (const std::string& warning : device.frames->warnings()) {
    findings->push_back(
        {Health::kNote, "camera", warning, "set it in device.toml to what the camera can do"});
  }
  return LookAtPictures(device, calibration, context, findings);
}

Status OpenAndLook(const DoctorRequest& request, const ReadyCalibration* calibration, const Context& context,
                   Findings* findings) {
  context.Report("device", 0.2);
  Result<Device> opened = OpenDevice(request.device, context);
  if (opened.ok()) return LookAtDevice(*opened, calibration, context, findings);
  const ErrorCode code = opened.error().code;
  if (code == ErrorCode::kCancelled || code == ErrorCode::kUsage) return opened.error();
  findings->push_back({Health::kBroken, "device", opened.error().message, ""});
  return {};
}

// `open`: the device, or none: the one that the request names is opened, if it names one.
Result<DoctorReport> Examine(Device* open, const DoctorRequest& request, const Context& context) {
  DoctorReport report;
  LookAtCameras(&report.findings);
  LookAtPorts(&report.findings);
  LookAtDisk(request, &report.findings);
  std::optional<ReadyCalibration> calibration;
  if (!request.calibration_path.empty()) calibration = LookAtCalibration(request, &report.findings);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  const ReadyCalibration* ready = calibration ? &*calibration : nullptr;
  if (open != nullptr) {
    DORSUM_RETURN_IF_ERROR(LookAtDevice(*open, ready, context, &report.findings));
  } else if (!request.device.empty()) {
    DORSUM_RETURN_IF_ERROR(OpenAndLook(request, ready, context, &report.findings));
  }
  return report;
}

}  // namespace

bool DoctorReport::healthy() const {
  return std::none_of(findings.begin(), findings.end(),
                      [](const DoctorFinding& f) { return f.health == Health::kBroken; });
}

Result<DoctorReport> ExamineDevice(const DoctorRequest& request, const Context& context) {
  return Examine(nullptr, request, context);
}

Result<DoctorReport> ExamineOpenDevice(Device& device, const DoctorRequest& request, const Context& context) {
  return Examine(&device, request, context);
}

namespace {

const char* HealthWord(Health health) {
  return health == Health::kFine ? "fine" : health == Health::kNote ? "note" : "broken";
}

}  // namespace

Json DoctorReportToJson(const DoctorReport& report) {
  Json json = {{"healthy", report.healthy()}, {"findings", Json::array()}};
  for (const DoctorFinding& f : report.findings) {
    json["findings"].push_back({{"grade", HealthWord(f.health)},
                                {"subject", f.subject},
                                {"finding", f.sentence},
                                {"remedy", f.remedy}});
  }
  return json;
}

std::string DoctorReportToText(const DoctorReport& report) {
  std::string text;
  for (const DoctorFinding& f : report.findings) {
    char head[64];
    std::snprintf(head, sizeof head, "%-7s %-17s ", HealthWord(f.health), f.subject.c_str());
    text += head + f.sentence + "\n";
    if (!f.remedy.empty()) text += std::string(26, ' ') + "-> " + f.remedy + "\n";
  }
  return text;
}

}  // namespace dorsum
