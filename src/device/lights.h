// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <string>

#include "base/result.h"

namespace dorsum {

// Channels of a light controller, as device.toml numbers them: bit n is channel n.
inline constexpr int kMaxChannels = 64;
using ChannelSet = std::bitset<kMaxChannels>;

struct ControllerInfo {
  std::string name;              // for people: "light controller on /dev/ttyUSB0"
  std::string firmware_version;  // "1.0.0"
  int channels = 0;              // 0 to channels - 1 can be switched
  double silence_limit_s = 0.0;  // everything goes off when the host says nothing for so long
  double on_limit_s = 0.0;       // a laser goes off after so long without a new command
};

// Switches lasers and LEDs. Whoever holds it keeps the lights alive; when it goes, everything goes off.
class Lights {
 public:
  virtual ~Lights() = default;

  // Exactly these channels on, all others off; returns once it is so. After an error everything is off or
  // will be within the controller's silence limit.
  virtual Status Set(const ChannelSet& on) = 0;
  // What is on now: the controller may have switched lights off on its own.
  virtual Result<ChannelSet> On() = 0;

  virtual ControllerInfo info() const = 0;
};

}  // namespace dorsum
