// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_model.h"

#include <gtest/gtest.h>

#include "calibration/bundle_device_test.h"
#include "calibration/bundle_functions.h"

namespace dorsum {
namespace {

constexpr int kAll = kLensSize + kPoseSize + kPlaneSize + kFanSize;

// The whole way from a pixel to an order, over all parameters in one list.
template <class T>
T OrderOf(const T* p, const PoseParameters& pose, const FanParameters& fan, const Eigen::Vector2d& pixel) {
  const auto world = bundle::PointOnPlane<T>(p, pose.start, p + kLensSize, p + kLensSize + kPoseSize, pixel);
  return bundle::OrderAt<T>(fan.start, p + kLensSize + kPoseSize + kPlaneSize, world);
}

TEST(BundleModel, AgreesWithTheGeometryLayer) {
  const BundleFixture device;
  for (std::size_t k = 0; k < device.fans.size(); ++k) {
    LaserGeometry laser;
    laser.fan = device.fans[k];
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(20, 30), {400, 300}, {780, 590}}) {
      for (const double z : {0.0, 40.0}) {
        const double plane[3] = {z, 0.0, 0.0};
        const auto world =
            bundle::PointOnPlane<double>(device.truth.lens.value.data(), device.truth.camera_from_world.start,
                                         device.truth.camera_from_world.value.data(), plane, pixel);
        const auto order =
            bundle::OrderAt<double>(device.truth.fans[k].start, device.truth.fans[k].value.data(), world);
        const auto expected = OrderAtHeight(device.camera, laser, SheetModel::kCone, pixel, z);
        ASSERT_TRUE(expected.has_value());
        EXPECT_NEAR(order, expected.value_or(1e9), 1e-9);
      }
    }
  }
}

TEST(BundleModel, DerivativesAreThoseOfFiniteDifferences) {
  const BundleFixture device;
  FanParameters fan = device.truth.fans[0];
  fan.value[kFanTurn] = 0.01;
  fan.value[kFanTurn + 1] = -0.02;
  fan.value[kFanSkew] = 0.01;
  std::array<double, kAll> p{};
  std::copy(device.truth.lens.value.begin(), device.truth.lens.value.end(), p.begin());
  std::copy_n(device.truth.camera_from_world.value.begin(), kPoseSize, p.begin() + kLensSize);
  p[kLensSize] = 0.003;
  p[kLensSize + kPoseSize] = 30.0;
  p[kLensSize + kPoseSize + 1] = 0.01;
  std::copy(fan.value.begin(), fan.value.end(), p.begin() + kLensSize + kPoseSize + kPlaneSize);
  using Jet = ceres::Jet<double, kAll>;
  std::array<Jet, kAll> jets;
  for (std::size_t i = 0; i < jets.size(); ++i) jets[i] = Jet(p[i], static_cast<int>(i));
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(60, 40), {390, 310}, {750, 560}}) {
    const Jet order = OrderOf<Jet>(jets.data(), device.truth.camera_from_world, fan, pixel);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double step = 1e-5 * std::max(1.0, std::abs(p[i]));
      auto high = p, low = p;
      high[i] += step;
      low[i] -= step;
      const double numeric = (OrderOf<double>(high.data(), device.truth.camera_from_world, fan, pixel) -
                              OrderOf<double>(low.data(), device.truth.camera_from_world, fan, pixel)) /
                             (2.0 * step);
      EXPECT_NEAR(order.v[static_cast<int>(i)], numeric, 1e-5 * std::max(1.0, std::abs(numeric))) << i;
    }
  }
}

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
