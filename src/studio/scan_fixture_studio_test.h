// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSignalSpy>
#include <QTest>
#include <optional>

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/hooked_device_test.h"
#include "device/virtual_bench.h"
#include "jobs/scan_fixture_test.h"
#include "studio/patience_test.h"
#include "studio/scan_model.h"

namespace dorsum {

// A workbench with the small virtual device of the scan fixture.
class ScanTest : public ::testing::Test {
 protected:
  ScanTest() {
    QObject::connect(&workbench_, &Workbench::Failed, [this](const Error& e) { error_ = e; });
  }
  std::string DeviceFile() {
    std::string text = ScanFixture::kDevice;
    text.insert(text.find("[camera]\n") + 9, "source = \"virtual:1\"\n");
    const std::filesystem::path path = dir_ / "device.toml";
    if (!WriteFile(path, text).ok()) throw std::runtime_error("cannot write the device");
    return path.string();
  }
  void Prepare(ScanModel* model) {
    model->SetFolder(dir_ / "kept");
    model->SetCache(dir_ / "cache");
  }
  void Calibrate() {
    QSignalSpy changed(&workbench_, &Workbench::CalibrationChanged);
    workbench_.LoadCalibration(ScanFixture::CalibrationJson());
    ASSERT_TRUE(changed.wait(kPatience_ms));
  }
  void OpenDeviceOf(ScanModel* model) {
    QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
    workbench_.device().Open(DeviceFile());
    ASSERT_TRUE(opened.wait(kPatience_ms));
    model->Activate();
  }
  static bool Reaches(const ScanModel& model, ScanState state) {
    return QTest::qWaitFor([&] { return model.state() == state; }, kPatience_ms);
  }
  // Puts hooks on the open device; `change` is called in the device's thread.
  void WithHooks(const std::function<void(DeviceHooks&)>& change) {
    bool done = false;
    workbench_.device().Run<bool>(
        "hook",
        [change](Device& device, const Context&) -> Result<bool> {
          change(*Hook(device));
          return true;
        },
        [&](const Result<bool>&) { done = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return done; }, kPatience_ms));
  }

  TempFolder dir_;
  Workbench workbench_;
  std::optional<Error> error_;
};

}  // namespace dorsum
