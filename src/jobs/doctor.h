// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"
#include "device/device.h"

namespace dorsum {

struct DoctorRequest {
  std::string device;                      // as OpenDevice takes it; empty: only what the machine has
  std::filesystem::path calibration_path;  // optional
  std::filesystem::path data_dir = ".";    // where captures go
  double old_days = 30.0;                  // a calibration older than this is worth another look
  double min_free_gb = 1.0;                // free disk space below which it is said
};

// One thing that was looked at.
struct DoctorFinding {
  enum class Health { kFine, kNote, kBroken };  // broken: capturing will not work, or is not to be trusted
  Health health = Health::kFine;
  std::string subject;  // "camera", "light controller", "laser 2", "calibration", "disk" ...
  std::string sentence;
  std::string remedy;  // what to do; empty where all is well
};

struct DoctorReport {
  std::vector<DoctorFinding> findings;
  bool healthy() const;  // nothing is broken
};

// Looks at cameras, serial ports and their permissions; opens the device and says what it is; takes a picture
// in the dark, under the LEDs and under each laser; compares the stripes on the empty part of the backplane
// with the calibration; at the calibration's age and device, and at the disk. Whatever is wrong is a finding
// and no error; only an interrupt and wrong arguments are errors. Lights are off afterwards.
Result<DoctorReport> ExamineDevice(const DoctorRequest& request, const Context& context);

// The same of a device that is open already; request.device is not looked at.
Result<DoctorReport> ExamineOpenDevice(Device& device, const DoctorRequest& request, const Context& context);

Json DoctorReportToJson(const DoctorReport& report);
std::string DoctorReportToText(const DoctorReport& report);

}  // namespace dorsum
