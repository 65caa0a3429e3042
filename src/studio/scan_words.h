// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "studio/hand_advice.h"

namespace dorsum {

enum class ScanState {
  kNoDevice,
  kLost,           // the device failed while it was used
  kNoCalibration,  // live picture, but none that fits the device
  kPreview,        // live picture, the hand is not right yet
  kReady,          // it rests and is good
  kCapturing,
  kComputing,
  kShown,        // the surface is there, not kept yet
  kKept,         // it is on the disk
  kCalibrating,  // a virtual device, by itself
};

// What the person should do, or what is being done. `advice` counts where there is a live picture of a
// calibrated device, `calibrated` where no calibration fits (there is one, of another device), `again` while
// pictures are taken.
QString ScanSentence(ScanState state, Advice advice, bool calibrated, bool again);

}  // namespace dorsum
