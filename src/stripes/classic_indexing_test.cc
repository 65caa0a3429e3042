// SPDX-License-Identifier: Apache-2.0
#include "stripes/classic_indexing.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "geometry/plane_device_test.h"
#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

struct Box {
  double height = 0.0, min_x = -120.0, max_x = 120.0;
};

// The stripes of one laser on a flat box, and the order of each.
struct Seen {
  LaserStripes stripes;
  std::vector<int> orders;
};

Seen SeeBox(const DeviceGeometry& device, const LaserGeometry& laser, const Box& box,
            const std::set<int>& missing = {}, double central_peak = 200.0) {
  Seen seen;
  seen.stripes.laser = laser.laser;
  const double px_per_mm = device.camera.fx / (kTestCameraHeight - box.height);
  const auto point = [&](const PlaneSheet& sheet, int row) {
    return OnSheet(sheet, (device.camera.cy - row) / px_per_mm, box.height);
  };
  for (const PlaneSheet& sheet : laser.planes) {
    const double x = point(sheet, 240).x();
    if (x < box.min_x || x > box.max_x || missing.contains(sheet.order)) continue;
    AddStripe(
        &seen.stripes, 180, 300,
        [&](int row) { return device.camera.cx + px_per_mm * point(sheet, row).x(); },
        sheet.order == 0 ? central_peak : 100.0 - std::abs(sheet.order));
    seen.orders.push_back(sheet.order);
  }
  return seen;
}

void ExpectOrders(const DeviceGeometry& device, const std::vector<Seen>& seen, const std::string& what) {
  std::vector<LaserStripes> stripes;
  stripes.reserve(seen.size());
  for (const Seen& s : seen) stripes.push_back(s.stripes);
  const IndexedStripes indexed = IndexClassic(stripes, device, SheetModel::kPlane, {});
  ASSERT_EQ(indexed.lasers.size(), seen.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    EXPECT_EQ(indexed.diagnostics[k].segments, static_cast<int>(seen[k].orders.size()));
    EXPECT_EQ(indexed.diagnostics[k].left_out, 0);
    for (std::size_t s = 0; s < seen[k].orders.size(); ++s) {
      EXPECT_EQ(indexed.lasers[k].segments[s].order, seen[k].orders[s])
          << what << ", laser " << indexed.lasers[k].laser;
    }
  }
}

TEST(ClassicIndexing, AFlatBoxOfAnyHeightGivesEveryOrder) {
  const DeviceGeometry device = TestDevice();
  for (const double height : {0.0, 7.0, 25.0, 79.0}) {
    const Box box{.height = height};
    ExpectOrders(device, {SeeBox(device, device.lasers[0], box), SeeBox(device, device.lasers[1], box)},
                 "height " + std::to_string(height));
  }
}

TEST(ClassicIndexing, AMissingStripeShiftsNoOther) {
  const DeviceGeometry device = TestDevice();
  const Seen seen = SeeBox(device, device.lasers[1], {.height = 20.0}, {-4, 2, 3});
  ExpectOrders(device, {seen}, "missing");
}

TEST(ClassicIndexing, ABoxBesideTheCentralStripeIsPutAtItsLowestHeight) {
  // Laser 1's central stripe is at x = 60. At 1 mm above the backplane no lower height fits.
  const DeviceGeometry device = TestDevice();
  ExpectOrders(device, {SeeBox(device, device.lasers[1], {.height = 1.0, .min_x = -100.0, .max_x = 20.0})},
               "beside");
}

TEST(ClassicIndexing, LasersThatTheDeviceDoesNotKnowAreLeftOut) {
  const DeviceGeometry device = TestDevice();
  Seen known = SeeBox(device, device.lasers[1], {.height = 10.0}), unknown = known;
  unknown.stripes.laser = 6;
  const IndexedStripes indexed =
      IndexClassic({unknown.stripes, known.stripes}, device, SheetModel::kPlane, {});
  ASSERT_EQ(indexed.lasers.size(), 1U);
  EXPECT_EQ(indexed.lasers[0].laser, 1);
  EXPECT_EQ(indexed.diagnostics.size(), 1U);
}

TEST(ClassicIndexing, NoStripesAreNoTrouble) {
  const DeviceGeometry device = TestDevice();
  LaserStripes empty;
  empty.laser = 0;
  const IndexedStripes indexed = IndexClassic({empty}, device, SheetModel::kPlane, {});
  EXPECT_EQ(indexed.lasers.size(), 1U);
  EXPECT_TRUE(IndexClassic({}, device, SheetModel::kPlane, {}).lasers.empty());
}

}  // namespace
}  // namespace dorsum
