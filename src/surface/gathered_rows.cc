// SPDX-License-Identifier: Apache-2.0
#include "surface/gathered_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dorsum {
namespace {

constexpr float kNextRow = 1.5F;  // px: more is a gap
constexpr float kAgree = 4.0F;    // standard deviations that rows of one sample may differ by

struct Height {
  float z, sigma;  // mm
};

Height Pooled(const SurfacePoint& p, float least_sigma) {
  return {static_cast<float>(p.position.z()), std::max(p.sigma, least_sigma)};
}

// That of the row alone; where rows were not pooled, there is no other.
Height OfRow(const SurfacePoint& p, float least_sigma) {
  if (p.row_sigma <= 0.0F) return Pooled(p, least_sigma);
  return {p.row_z, std::max(p.row_sigma, least_sigma)};
}

// A weighted mean in the making; sums are relative to the first row, where they lose no digits.
class Gathering {
 public:
  Gathering(const SurfacePoint& first, float least_sigma)
      : first_(first), last_(OfRow(first, least_sigma)), least_sigma_(least_sigma) {
    Add(first);
  }

  int rows() const { return rows_; }

  bool Takes(const SurfacePoint& last, const SurfacePoint& next) const {
    if (next.laser != first_.laser || next.segment != first_.segment) return false;
    if (std::abs(next.v - last.v) > kNextRow) return false;
    const Height row = OfRow(next, least_sigma_);
    return std::abs(row.z - last_.z) <= kAgree * std::hypot(row.sigma, last_.sigma);
  }

  void Add(const SurfacePoint& p) {
    const Height row = OfRow(p, least_sigma_), pooled = Pooled(p, least_sigma_);
    const float w = 1.0F / (row.sigma * row.sigma), pooled_w = 1.0F / (pooled.sigma * pooled.sigma);
    weight_ += w;
    u_ += w * (p.u - first_.u);
    v_ += w * (p.v - first_.v);
    z_ += w * (row.z - Start());
    pooled_weight_ += pooled_w;
    pooled_z_ += pooled_w * (pooled.z - Start());
    last_ = row;
    ++rows_;
  }

  PlateSample Sample() const {
    return {first_.u + u_ / weight_, first_.v + v_ / weight_, Start() + z_ / weight_, weight_};
  }
  PooledHeight AfterPooling() const {
    return {.change_mm = pooled_z_ / pooled_weight_ - z_ / weight_, .weight = pooled_weight_};
  }

 private:
  float Start() const { return static_cast<float>(first_.position.z()); }

  const SurfacePoint& first_;
  Height last_;
  float least_sigma_;
  int rows_ = 0;
  float weight_ = 0.0F, u_ = 0.0F, v_ = 0.0F, z_ = 0.0F;
  float pooled_weight_ = 0.0F, pooled_z_ = 0.0F;
};

}  // namespace

GatheredRows GatherRows(const SurfacePoints& points, const std::vector<bool>& left_out, int most,
                        float least_sigma) {
  GatheredRows out;
  const std::size_t expected = points.size() / static_cast<std::size_t>(most) + 1;
  out.samples.reserve(expected);
  out.pooled.reserve(expected);
  out.lasers.reserve(expected);
  for (std::size_t i = 0; i < points.size();) {
    Gathering rows(points[i], least_sigma);
    const bool alone = left_out[i];
    out.lasers.push_back(points[i].laser);
    for (++i; !alone && i < points.size() && rows.rows() < most; ++i) {
      if (left_out[i] || !rows.Takes(points[i - 1], points[i])) break;
      rows.Add(points[i]);
    }
    out.samples.push_back(rows.Sample());
    out.pooled.push_back(rows.AfterPooling());
    if (alone) out.samples.back().weight = out.pooled.back().weight = 0.0F;
  }
  return out;
}

}  // namespace dorsum
