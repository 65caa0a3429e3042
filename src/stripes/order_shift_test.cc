// SPDX-License-Identifier: Apache-2.0
#include "stripes/order_shift.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "base/random.h"
#include "stripes/append_segment.h"

namespace dorsum {
namespace {

// Efficiencies of a grating: the central order twice as bright as its neighbours, which fall off outwards.
double Efficiency(int order) {
  if (order == 0) return 1.0;
  return 0.5 - 0.036 * (std::abs(order) - 1);
}

DeviceGeometry Device(const std::function<double(int)>& efficiency) {
  DeviceGeometry device;
  for (int k = 0; k < 2; ++k) {
    LaserGeometry laser;
    laser.laser = k;
    for (int m = -9; m <= 9; ++m) {
      ReferenceStripe r;
      r.order = m;
      r.middle_v = 100.0;
      r.half_v = 100.0;
      r.peak = {200.0 * efficiency(m), 0.0, 0.0};
      laser.reference.push_back(r);
    }
    device.lasers.push_back(laser);
  }
  return device;
}

// Upright stripes whose orders are `shift` below the true ones, on a surface half as bright as the backplane
// and darker to the right, with speckle.
IndexedStripes Stripes(int shift, const std::function<double(int)>& efficiency) {
  Rng rng(5);
  IndexedStripes out;
  for (int k = 0; k < 2; ++k) {
    LaserStripes one;
    one.laser = k;
    for (int m = -6; m <= 6; ++m) {
      std::vector<StripePoint> points;
      for (int v = 20; v < 120; ++v) {
        StripePoint p;
        p.u = static_cast<float>(200 + 20 * m + 7 * k);
        p.v = static_cast<float>(v);
        p.peak = static_cast<float>(100.0 * efficiency(m) * std::exp(-0.02 * m + 0.15 * rng.Normal()));
        points.push_back(p);
      }
      AppendSegment(points, m - shift, &one);
    }
    out.lasers.push_back(std::move(one));
  }
  return out;
}

const cv::Mat kEvenLight(140, 420, CV_8UC1, cv::Scalar(80));

TEST(OrderShift, ANumberingThatIsOffAsAWholeIsFound) {
  for (const int shift : {-1, 0, 1, 2}) {
    const OrderShift found = FindOrderShift(Stripes(shift, Efficiency), kEvenLight, Device(Efficiency), {});
    EXPECT_EQ(found.lasers, 2);
    EXPECT_EQ(found.shift, shift);
    EXPECT_LT(found.left_shifted, 0.05);
  }
}

TEST(OrderShift, OrdersThatAreAllAlikeSayNothing) {
  const auto even = [](int) { return 0.4; };
  EXPECT_EQ(FindOrderShift(Stripes(1, even), kEvenLight, Device(even), {}).shift, 0);
}

TEST(OrderShift, WithoutReferencesOrStripesNothingIsKnown) {
  DeviceGeometry bare = Device(Efficiency);
  for (LaserGeometry& laser : bare.lasers) laser.reference.clear();
  EXPECT_EQ(FindOrderShift(Stripes(1, Efficiency), kEvenLight, bare, {}).lasers, 0);
  EXPECT_EQ(FindOrderShift({}, kEvenLight, Device(Efficiency), {}).lasers, 0);
  EXPECT_EQ(FindOrderShift(Stripes(1, Efficiency), cv::Mat(), Device(Efficiency), {}).lasers, 0);
}

}  // namespace
}  // namespace dorsum
