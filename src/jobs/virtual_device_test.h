// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/device.h"
#include "device/virtual_bench.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {

// The device of the scan fixture, live: its calibration fits.
inline Device OpenFixtureDevice(const TempFolder& folder) {
  std::string text = ScanFixture::kDevice;
  const std::string camera = "[camera]\n";
  text.insert(text.find(camera) + camera.size(),
              "source = \"virtual:" + std::string(ScanFixture::kSeed) + "\"\n");
  const std::filesystem::path path = folder.path() / "device.toml";
  if (!WriteFile(path, text).ok()) throw std::runtime_error("cannot write " + path.string());
  Result<Device> device = OpenDevice(path.string(), Context{});
  if (!device.ok()) throw std::runtime_error(device.error().message);
  return std::move(device).value();
}

}  // namespace dorsum
