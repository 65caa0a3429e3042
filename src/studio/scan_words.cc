// SPDX-License-Identifier: Apache-2.0
#include "studio/scan_words.h"

#include "studio/scan_model.h"

namespace dorsum {
namespace {

QString AdviceSentence(Advice advice) {
  switch (advice) {
    case Advice::kPutHandDown:
      return ScanModel::tr("Put your hand down");
    case Advice::kLightChanged:
      return ScanModel::tr("The light has changed: calibrate again");
    case Advice::kMoveLeft:
      return ScanModel::tr("Move the hand to the left");
    case Advice::kMoveRight:
      return ScanModel::tr("Move the hand to the right");
    case Advice::kMoveUp:
      return ScanModel::tr("Move the hand up");
    case Advice::kMoveDown:
      return ScanModel::tr("Move the hand down");
    case Advice::kSpreadFingers:
      return ScanModel::tr("Spread the fingers");
    case Advice::kHoldStill:
      return ScanModel::tr("Hold still");
    case Advice::kGood:
      break;
  }
  return ScanModel::tr("Good: hold still");
}

}  // namespace

QString ScanSentence(ScanState state, Advice advice, bool calibrated, bool again) {
  switch (state) {
    case ScanState::kNoDevice:
      return ScanModel::tr("No device is open");
    case ScanState::kLost:
      return ScanModel::tr("The device does not answer: look at its cables");
    case ScanState::kNoCalibration:
      return calibrated ? ScanModel::tr("The calibration is of another device")
                        : ScanModel::tr("This device needs its calibration first");
    case ScanState::kCalibrating:
      return ScanModel::tr("The virtual device calibrates itself");
    case ScanState::kCapturing:
      return again ? ScanModel::tr("Once more: hold still") : ScanModel::tr("Hold still");
    case ScanState::kComputing:
      return ScanModel::tr("Thank you: you may take the hand away");
    case ScanState::kShown:
      return ScanModel::tr("Is it good?");
    case ScanState::kKept:
      return ScanModel::tr("Kept");
    case ScanState::kPreview:
    case ScanState::kReady:
      break;
  }
  return AdviceSentence(advice);
}

}  // namespace dorsum
