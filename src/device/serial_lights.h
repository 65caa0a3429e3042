// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "device/controller_link.h"
#include "device/lights.h"

namespace dorsum {

struct SerialLightsOptions {
  std::string port;              // "/dev/ttyUSB0"; empty: the first USB port on which a controller answers
  int baud = 115200;             // the firmware's
  ChannelSet needed;             // channels that the device uses; one that cannot be switched is an error
  std::optional<bool> inverted;  // what the firmware's logic must be, if the caller knows
  double keep_alive_s = 0.5;     // between signs of life while lights are on; far below the silence limit
  LinkOptions link;
};

// A light controller with our firmware (docs/protocol.md) on a serial port. While lights are on, a thread of
// its own keeps them alive; a controller that restarts, falls silent or goes away meanwhile makes the next
// On() a device error, so nobody takes a light for lit that is not. Set() then tries once to begin anew. A
// laser goes off when ControllerInfo::on_limit_s have passed since the last Set(): setting it again renews
// it.
Result<std::unique_ptr<Lights>> OpenSerialLights(const SerialLightsOptions& options, const Context& context);

// The first of these ports on which a controller answers; their errors in one where none does.
Result<std::unique_ptr<Lights>> OpenFirstSerialLights(const std::vector<std::string>& ports,
                                                      const SerialLightsOptions& options,
                                                      const Context& context);

}  // namespace dorsum
