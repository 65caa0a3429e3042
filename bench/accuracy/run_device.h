// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "accuracy/rendered_device.h"
#include "accuracy/results.h"
#include "accuracy/rungs.h"

namespace dorsum::accuracy {

struct RunOptions {
  std::vector<std::string> budget_of;            // rungs of which to say where the errors come from
  std::function<void(const std::string&)> said;  // a line of progress for each capture
};

// Calibrates a device, reconstructs its captures the way of each rung, and scores them; one result for each
// rung. What is made is written below the device's out_dir, so that it can be looked at. What the product
// refuses is a result too; an error means that the bench itself could not go on.
Result<std::vector<DeviceResult>> RunDevice(const DeviceData& data, const std::vector<Rung>& rungs,
                                            const RunOptions& options, const Context& context);

}  // namespace dorsum::accuracy
