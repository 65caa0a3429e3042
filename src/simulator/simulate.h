// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"

namespace dorsum {

struct SimulateOptions {
  std::filesystem::path device_path;  // device.toml; empty: the built-in four-laser device
  std::string seed = "1";             // any text: names the true device, the scenes and the noise
  std::string people_seed;            // any text: names the people; empty: as seed
  bool calibration = true;            // also the calibration series
  std::vector<std::string> scenes;    // simulator/named_scene.h says which
  int population = 0;                 // people, both hands each, 0 to 10000; nine in ten are men, as in §5.3
  int sessions = 1;                   // captures of each hand, 1 to 100
  bool overwrite = false;             // replace what an earlier run wrote to the same folder
};

struct SimulateReport {
  int captures = 0;          // folders under captures/
  bool calibration = false;  // whether calibration/ was written
  std::vector<std::string> capture_names;
};

// Writes OUT/{calibration, captures/NAME, truth/NAME, truth/device.json} of one virtual device, and
// people.json with a population. The folder appears when all is done. Refuses a folder that is not empty
// unless told to overwrite.
Result<SimulateReport> Simulate(const SimulateOptions& options, const std::filesystem::path& out_dir,
                                const Context& context);

}  // namespace dorsum
