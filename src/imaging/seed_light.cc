// SPDX-License-Identifier: Apache-2.0
#include "imaging/seed_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "imaging/seed_map.h"
#include "imaging/sharp_step.h"

namespace dorsum {
namespace {

constexpr int kEvery = 2;        // px between those whose texture counts
constexpr int kCell = 8;         // px: statistics are kept for squares of this side
constexpr double kReach = 2.0;   // cells: one standard deviation of the distance over which they count
constexpr double kTrust = 20.0;  // px: known pixels nearby that weigh as much as all of the image

// Number, sum and sum of squares of a quantity over some pixels of each cell.
struct CellSums {
  explicit CellSums(cv::Size cells) : n(cv::Mat::zeros(cells, CV_32F)), sum(n.clone()), squares(n.clone()) {}
  cv::Mat n, sum, squares;
};

// Those of one row of cells.
struct RowSums {
  RowSums(CellSums* sums, int row)
      : n(sums->n.ptr<float>(row)), sum(sums->sum.ptr<float>(row)), squares(sums->squares.ptr<float>(row)) {}
  void Add(int cell, float value) const {
    n[cell] += 1.0F;
    sum[cell] += value;
    squares[cell] += value * value;
  }
  float *n, *sum, *squares;
};

// Mean and mean square in cells around each cell.
struct LocalMoments {
  cv::Mat mean, square;
};

LocalMoments MomentsNear(CellSums sums) {
  const double count = cv::sum(sums.n)[0];
  const double mean = count > 0.0 ? cv::sum(sums.sum)[0] / count : 1.0;
  const double square = count > 0.0 ? cv::sum(sums.squares)[0] / count : 1.0;
  for (cv::Mat* m : {&sums.n, &sums.sum, &sums.squares})
    cv::GaussianBlur(*m, *m, {}, kReach, kReach, cv::BORDER_CONSTANT);
  sums.n += kTrust / (kCell * kCell);
  sums.sum += mean * kTrust / (kCell * kCell);
  sums.squares += square * kTrust / (kCell * kCell);
  return {sums.sum / sums.n, sums.squares / sums.n};
}

// Pixels of a row away from the outline, whose blur and own shade are not theirs: kNoKind for the others.
class InnerRow {
 public:
  static constexpr std::uint8_t kNoKind = 0, kObject = 1, kBackplane = 2;

  explicit InnerRow(const cv::Mat& known)
      : known_(known), column_(static_cast<std::size_t>(known.cols) + 2, kObject | kBackplane) {
    inner_.resize(static_cast<std::size_t>(known.cols));
  }

  const std::uint8_t* Find(int row) {
    constexpr int kAbove = 2;
    const auto count = inner_.size();
    std::fill(column_.begin() + 1, column_.end() - 1, kObject | kBackplane);
    for (int v = std::max(0, row - kAbove); v <= std::min(known_.rows - 1, row + kAbove); ++v) {
      const auto* known = known_.ptr<std::uint8_t>(v);
      for (std::size_t i = 0; i < count; ++i) {
        const int object = known[i] == kObjectPixel ? kObject : 0;
        const int backplane = known[i] == kBackplanePixel ? kBackplane : 0;
        column_[i + 1] = static_cast<std::uint8_t>(column_[i + 1] & (object | backplane));
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      inner_[i] = static_cast<std::uint8_t>(column_[i] & column_[i + 1] & column_[i + 2]);
    return inner_.data();
  }

 private:
  const cv::Mat& known_;
  std::vector<std::uint8_t> column_, inner_;
};

void AddTexture(const cv::Mat& light, const std::uint8_t* inner, int v, const RowSums& sums) {
  const auto stride = static_cast<std::ptrdiff_t>(light.step1());
  const auto* row = light.ptr<float>(v);
  for (int u = 0; u + 1 < light.cols; u += kEvery) {
    if (inner[u] == InnerRow::kNoKind) continue;
    const bool slopes = HasSlopes(light.size(), {u, v});
    const float across = slopes ? SharpStep(row + u, 1) : SharpStep(light, {u, v}, {1, 0});
    const float down = slopes ? SharpStep(row + u, stride) : SharpStep(light, {u, v}, {0, 1});
    sums.Add(u / kCell, std::sqrt(across * across + down * down));
  }
}

}  // namespace

SeedLight::SeedLight(const cv::Mat& light, const cv::Mat& known, const Context& context) {
  constexpr double kLeast = 0.002;
  const cv::Size cells((light.cols + kCell - 1) / kCell, (light.rows + kCell - 1) / kCell);
  CellSums object(cells), backplane(cells), steps(cells);
  ParallelFor(context, 0, cells.height, [&](std::int64_t cell_row) {
    const int cell = static_cast<int>(cell_row);
    const RowSums of_object(&object, cell), of_backplane(&backplane, cell), of_steps(&steps, cell);
    InnerRow inner_row(known);
    for (int v = cell * kCell; v < std::min(light.rows, (cell + 1) * kCell); ++v) {
      const auto* inner = inner_row.Find(v);
      const auto* there = light.ptr<float>(v);
      for (int u = 0; u < light.cols; ++u) {
        if (inner[u] == InnerRow::kObject) of_object.Add(u / kCell, there[u]);
        if (inner[u] == InnerRow::kBackplane) of_backplane.Add(u / kCell, there[u]);
      }
      if (v % kEvery == 0 && v + 1 < light.rows) AddTexture(light, inner, v, of_steps);
    }
  });
  cv::Mat texture;
  cv::sqrt(MomentsNear(std::move(steps)).square * 0.5, texture);
  texture_ = {cv::max(texture, kLeast), kCell};
  const LocalMoments like_object = MomentsNear(std::move(object)),
                     like_backplane = MomentsNear(std::move(backplane));
  object_ = {{like_object.mean, kCell}, {like_object.square, kCell}};
  backplane_ = {{like_backplane.mean, kCell}, {like_backplane.square, kCell}};
}

float SeedLight::Density(const Kind& kind, int u, int v, float light) {
  constexpr float kSpread = 0.03F;  // least standard deviation of either kind's light
  const float mean = kind.mean.At(u, v);
  const float variance = std::max(0.0F, kind.square.At(u, v) - mean * mean) + kSpread * kSpread;
  const float off = light - mean;
  return std::exp(-0.5F * off * off / variance) / std::sqrt(variance);
}

float SeedLight::LikeObject(int u, int v, float light) const {
  constexpr float kNeither = 0.5F;  // density of light that tells nothing
  constexpr float kStrange = 0.3F;  // what light unlike both says for the object: shadow has no sharp edge
  const float as_object = Density(object_, u, v, light), as_backplane = Density(backplane_, u, v, light);
  return (as_object - as_backplane + kStrange * kNeither) / (as_object + as_backplane + kNeither);
}

}  // namespace dorsum
