// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_indexing.h"

#include <gtest/gtest.h>

#include "stripes/joint_scene_test.h"

namespace dorsum {
namespace {

struct Outcome {
  int points = 0, right = 0, wrong = 0;
};

// Compares orders point by point, since segments may be parted.
Outcome Compare(const std::vector<TrueStripes>& truth, const IndexedStripes& indexed) {
  Outcome out;
  for (std::size_t l = 0; l < truth.size(); ++l) {
    std::vector<int> order(truth[l].stripes.points.size());
    for (std::size_t s = 0; s < truth[l].orders.size(); ++s) {
      const StripeSegment& segment = truth[l].stripes.segments[s];
      for (int i = 0; i < segment.count; ++i) {
        order[static_cast<std::size_t>(segment.first + i)] = truth[l].orders[s];
      }
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      const LaserStripes& own = indexed.lasers[l];
      const auto found = own.segments[static_cast<std::size_t>(own.points[i].segment)].order;
      ++out.points;
      if (found) ++(*found == order[i] ? out.right : out.wrong);
    }
  }
  return out;
}

std::vector<LaserStripes> Stripes(const std::vector<TrueStripes>& truth) {
  std::vector<LaserStripes> stripes;
  stripes.reserve(truth.size());
  for (const TrueStripes& t : truth) stripes.push_back(t.stripes);
  return stripes;
}

TEST(JointIndexing, TellsASurfaceHigherThanOneOrdersStepFromItsAliases) {
  const DeviceGeometry device = FanDevice(2);
  for (const double height : {12.0, 33.0, 66.0}) {
    const std::vector<TrueStripes> truth = {DrawTable(device, 0, {height}, true),
                                            DrawTable(device, 1, {height}, true)};
    const Outcome out = Compare(truth, IndexJointly(Stripes(truth), DeviceOrders(device), {}, {}));
    EXPECT_GT(out.points, 5000) << height;
    EXPECT_EQ(out.wrong, 0) << height;
    EXPECT_GT(out.right, 0.98 * out.points) << height;
  }
}

TEST(JointIndexing, NeedsNoBackplaneWhereTwoLasersInterleave) {
  const DeviceGeometry device = FanDevice(2);
  const std::vector<TrueStripes> truth = {DrawTable(device, 0, {40.0}, false),
                                          DrawTable(device, 1, {40.0}, false)};
  const Outcome out = Compare(truth, IndexJointly(Stripes(truth), DeviceOrders(device), {}, {}));
  EXPECT_EQ(out.wrong, 0);
  EXPECT_EQ(out.right, out.points);
}

TEST(JointIndexing, LeavesAPlateThatOneLaserCannotPlaceOut) {
  const DeviceGeometry device = FanDevice(1);
  const std::vector<TrueStripes> truth = {DrawTable(device, 0, {40.0}, false)};
  const IndexedStripes indexed = IndexJointly(Stripes(truth), DeviceOrders(device), {}, {});
  EXPECT_EQ(Compare(truth, indexed).wrong, 0);
  ASSERT_EQ(indexed.diagnostics.size(), 1U);
  EXPECT_EQ(indexed.diagnostics[0].left_out, indexed.diagnostics[0].segments);
  EXPECT_GT(indexed.diagnostics[0].left_out, 0);
}

TEST(JointIndexing, LeavesLasersOutThatTheDeviceDoesNotKnow) {
  const DeviceGeometry device = FanDevice(1);
  std::vector<LaserStripes> stripes(2);
  stripes[0].laser = 5;
  stripes[1].laser = 0;
  const IndexedStripes indexed = IndexJointly(stripes, DeviceOrders(device), {}, {});
  ASSERT_EQ(indexed.lasers.size(), 1U);
  EXPECT_EQ(indexed.lasers[0].laser, 0);
  EXPECT_TRUE(indexed.lasers[0].segments.empty());
}

TEST(JointIndexing, GivesTheSameAtAnyNumberOfThreads) {
  const DeviceGeometry device = FanDevice(2);
  const std::vector<TrueStripes> truth = {DrawTable(device, 0, {40.0}, true),
                                          DrawTable(device, 1, {40.0}, true)};
  Context one, four;
  one.threads = 1;
  four.threads = 4;
  const IndexedStripes a = IndexJointly(Stripes(truth), DeviceOrders(device), {}, one),
                       b = IndexJointly(Stripes(truth), DeviceOrders(device), {}, four);
  for (std::size_t l = 0; l < 2; ++l) {
    ASSERT_EQ(a.lasers[l].segments.size(), b.lasers[l].segments.size());
    for (std::size_t s = 0; s < a.lasers[l].segments.size(); ++s) {
      EXPECT_EQ(a.lasers[l].segments[s].order, b.lasers[l].segments[s].order);
      EXPECT_EQ(a.lasers[l].segments[s].first, b.lasers[l].segments[s].first);
    }
  }
}

}  // namespace
}  // namespace dorsum
