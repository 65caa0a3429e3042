// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_model.h"

#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"

namespace dorsum {
namespace {

TEST(BundleModel, ParametersAndGeometryTurnIntoEachOther) {
  for (const FanForm form : {FanForm::kFlat, FanForm::kConical, FanForm::kGeneral}) {
    DiffractedFan fan = BundleFan(3.0, 0.07, form);
    fan.bow = 0.01;
    fan.turn = -0.02;
    const DiffractedFan back = GeometryFromFan(FanFromGeometry(fan));
    for (const double beta : {-0.3, 0.0, 0.2}) {
      EXPECT_NEAR(IncomingAlpha(back, beta), IncomingAlpha(fan, beta), 1e-14);
    }
    EXPECT_LT((back.origin - fan.origin).norm(), 1e-12);
    EXPECT_EQ(back.step, fan.step);
  }
}

}  // namespace
}  // namespace dorsum
