// SPDX-License-Identifier: Apache-2.0
#include "calibration/dim_stripes.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dorsum {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Two pictures of the backplane; `peak` gives the brightness, 0 where a stripe is not found.
std::vector<SheetPoint> Points(const std::function<double(int order, double v)>& peak) {
  std::vector<SheetPoint> points;
  for (int source = 0; source < 2; ++source) {
    for (int order = -6; order <= 6; ++order) {
      for (int v = 5 + source; v < 1000; v += 24) {
        SheetPoint p;
        p.source = source;
        p.order = order;
        p.v = v;
        p.peak = peak(order, v);
        if (p.peak > 0.0) points.push_back(p);
      }
    }
  }
  return points;
}

double Usual(int order, double v) {
  return (order == 0 ? 200.0 : 110.0 - 10.0 * std::abs(order)) * (1.0 - 0.3 * std::pow(v / 500.0 - 1.0, 2));
}

TEST(DimStripes, AnOrdinaryLaserHasNone) { EXPECT_THAT(FindDimStripes(Points(Usual), 0, 1000), IsEmpty()); }

TEST(DimStripes, DirtOnTheGratingIsNamedByOrderAndRows) {
  const auto dirty = [](int order, double v) {
    return Usual(order, v) * (order == 3 && v > 300.0 && v < 500.0 ? 0.1 : 1.0);
  };
  EXPECT_THAT(FindDimStripes(Points(dirty), 0, 1000), ElementsAre(HasSubstr("order 3 is dim on rows 3")));
  const auto dark = [](int order, double v) {
    return order == 3 && v > 300.0 && v < 500.0 ? 0.0 : Usual(order, v);
  };
  EXPECT_THAT(FindDimStripes(Points(dark), 0, 1000), ElementsAre(HasSubstr("order 3 is missing on rows")));
}

TEST(DimStripes, AnOrderThatIsHardlyThereIsNamed) {
  const auto gone = [](int order, double v) { return order == -2 ? 0.0 : Usual(order, v); };
  EXPECT_THAT(FindDimStripes(Points(gone), 0, 1000), ElementsAre("order -2 is hardly seen on the backplane"));
  const auto weak = [](int order, double v) { return (order == -2 ? 0.15 : 1.0) * Usual(order, v); };
  EXPECT_THAT(FindDimStripes(Points(weak), 0, 1000), ElementsAre("order -2 is dim against its neighbours"));
}

}  // namespace
}  // namespace dorsum
