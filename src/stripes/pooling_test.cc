// SPDX-License-Identifier: Apache-2.0
#include "stripes/pooling.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "base/random.h"
#include "stripes/stripe_layout_test.h"

namespace dorsum {
namespace {

Context Threads(int n) {
  Context context;
  context.threads = n;
  return context;
}

struct Errors {
  double rmse = 0.0, sigma_ratio = 0.0, largest = 0.0;
};

Errors ErrorsOf(const LaserStripes& stripes, const std::function<double(int, int)>& truth) {
  Errors e;
  for (const StripePoint& p : stripes.points) {
    const double miss = static_cast<double>(p.u) - truth(p.segment, static_cast<int>(p.v));
    const auto n = static_cast<double>(stripes.points.size());
    e.rmse += miss * miss / n;
    e.sigma_ratio += std::pow(miss / static_cast<double>(p.sd_px), 2.0) / n;
    e.largest = std::max(e.largest, std::abs(miss));
  }
  e.rmse = std::sqrt(e.rmse);
  e.sigma_ratio = std::sqrt(e.sigma_ratio);
  return e;
}

// Twelve stripes whose rows err by `sd` with an autocorrelation like speckle's, while they claim `claimed`.
LaserStripes Noisy(const std::function<double(int, int)>& truth, int rows, double sd, double grain,
                   double claimed) {
  Rng rng(NamedSeed("pooling"));
  LaserStripes stripes;
  for (int s = 0; s < 12; ++s) {
    std::vector<double> white;
    white.reserve(static_cast<std::size_t>(rows) + 20);
    for (int i = 0; i < rows + 20; ++i) white.push_back(rng.Normal());
    AddStripe(&stripes, 0, rows, [&](int v) {
      double sum = 0.0, norm = 0.0;
      for (int k = -8; k <= 8; ++k) {
        const double w = grain > 0.0 ? std::exp(-0.5 * k * k / (grain * grain)) : (k == 0 ? 1.0 : 0.0);
        sum += w * white[static_cast<std::size_t>(v + k + 9)];
        norm += w * w;
      }
      return truth(s, v) + sd * sum / std::sqrt(norm);
    });
  }
  for (StripePoint& p : stripes.points) p.sd_px = static_cast<float>(claimed);
  return stripes;
}

TEST(Pooling, GainsOnStraightStripesAndKnowsHowMuch) {
  const auto truth = [](int s, int v) { return 100.0 * s + 0.1 * v; };
  const Errors e = ErrorsOf(PoolAlongStripes(Noisy(truth, 300, 0.2, 0.0, 0.2), {}, {}), truth);
  EXPECT_LT(e.rmse, 0.08);
  EXPECT_GT(e.sigma_ratio, 0.8);
  EXPECT_LT(e.sigma_ratio, 1.25);
}

TEST(Pooling, NeighboursThatErrAlikeDoNotMakeItOverconfident) {
  const auto truth = [](int s, int v) { return 100.0 * s + 0.1 * v; };
  const Errors e = ErrorsOf(PoolAlongStripes(Noisy(truth, 300, 0.2, 1.2, 0.06), {}, {}), truth);
  EXPECT_LT(e.rmse, 0.12);
  EXPECT_GT(e.sigma_ratio, 0.6);
  EXPECT_LT(e.sigma_ratio, 1.3);
}

TEST(Pooling, KeepsTheRowAndWhatItIsWorthAlone) {
  const auto truth = [](int s, int v) { return 100.0 * s + 0.1 * v; };
  const LaserStripes rows = Noisy(truth, 300, 0.2, 1.2, 0.2), pooled = PoolAlongStripes(rows, {}, {});
  // Rows that err alike over some rows: a mean of n of them is no better than that of n independent rows with
  // the larger deviation.
  double deviation = 0.0, spread = 0.0;
  for (int s = 0; s < 12; ++s) {
    double mean = 0.0;
    for (int v = 0; v < 300; ++v) {
      const auto i = static_cast<std::size_t>(300 * s + v);
      ASSERT_EQ(pooled.points[i].row_u, rows.points[i].u);
      mean += (static_cast<double>(rows.points[i].u) - truth(s, v)) / 300.0;
      deviation += static_cast<double>(pooled.points[i].row_sd_px) / 3600.0;
    }
    spread += mean * mean / 12.0;
  }
  EXPECT_GT(deviation / std::sqrt(300.0), 0.5 * std::sqrt(spread));
  EXPECT_LT(deviation / std::sqrt(300.0), 2.0 * std::sqrt(spread));
  EXPECT_GT(deviation, 0.25);
}

TEST(Pooling, DoesNotFlattenBumps) {
  const auto truth = [](int s, int v) {
    return 100.0 * s + 3.0 * std::exp(-0.5 * std::pow((v - 150) / 9.0, 2.0));
  };
  const Errors e = ErrorsOf(PoolAlongStripes(Noisy(truth, 300, 0.1, 0.0, 0.1), {}, {}), truth);
  EXPECT_LT(e.rmse, 0.06);
  EXPECT_LT(e.largest, 0.4);
}

TEST(Pooling, FollowsTheRoundEdgeOfAFingerToItsLastRow) {
  const auto truth = [](int s, int v) {
    return 100.0 * s + 12.0 * std::sqrt(1.0 - std::pow((v - 39.5) / 40.5, 2.0));
  };
  const LaserStripes pooled = PoolAlongStripes(Noisy(truth, 80, 0.1, 0.0, 0.1), {}, {});
  double end = 0.0;
  for (const StripeSegment& s : pooled.segments) {
    const StripePoint& p = pooled.points[static_cast<std::size_t>(s.first)];
    end += std::pow(static_cast<double>(p.u) - truth(p.segment, 0), 2.0) / 12.0;
  }
  EXPECT_LT(std::sqrt(end), 0.25);
}

TEST(Pooling, OneWildRowDoesNotBendTheRest) {
  const auto truth = [](int s, int) { return 100.0 * s; };
  LaserStripes stripes = Noisy(truth, 200, 0.05, 0.0, 0.05);
  stripes.points[100].u += 3.0F;
  EXPECT_LT(ErrorsOf(PoolAlongStripes(stripes, {}, {}), truth).largest, 0.15);
}

TEST(Pooling, SameBytesAtAnyNumberOfThreads) {
  const auto truth = [](int s, int v) { return 100.0 * s + 0.1 * v; };
  const LaserStripes noisy = Noisy(truth, 100, 0.2, 1.0, 0.1);
  const LaserStripes one = PoolAlongStripes(noisy, {}, Threads(1));
  const LaserStripes four = PoolAlongStripes(noisy, {}, Threads(4));
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    ASSERT_EQ(one.points[i].u, four.points[i].u);
    ASSERT_EQ(one.points[i].sd_px, four.points[i].sd_px);
  }
}

TEST(Pooling, WhoReadsOnlySomeRowsGetsThemAsIfAllWerePooled) {
  const auto truth = [](int s, int v) { return 40.0 * s + 0.1 * v; };
  const LaserStripes stripes = Noisy(truth, 200, 0.2, 1.5, 0.1);
  PoolingOptions options;
  const LaserStripes all = PoolAlongStripes(stripes, options, Threads(1));
  options.every_rows = 24;
  options.first_row = 8;
  const LaserStripes some = PoolAlongStripes(stripes, options, Threads(1));
  ASSERT_EQ(some.points.size(), all.points.size());
  for (const StripeSegment& segment : some.segments) {
    for (std::int32_t i = 0; i < segment.count; ++i) {
      const auto k = static_cast<std::size_t>(segment.first + i);
      const bool pooled = i >= 8 && (i - 8) % 24 == 0;
      EXPECT_EQ(some.points[k].u, pooled ? all.points[k].u : stripes.points[k].u) << i;
      EXPECT_EQ(some.points[k].sd_px, pooled ? all.points[k].sd_px : stripes.points[k].sd_px) << i;
    }
  }
}

TEST(Pooling, NothingComesOfNothing) {
  EXPECT_TRUE(PoolAlongStripes({}, {}, {}).points.empty());
  LaserStripes few;
  AddStripe(&few, 0, 2, 10.0);
  EXPECT_FLOAT_EQ(PoolAlongStripes(few, {}, {}).points[1].u, 10.0F);
}

}  // namespace
}  // namespace dorsum
