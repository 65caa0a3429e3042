// SPDX-License-Identifier: Apache-2.0
#include "stripes/joint_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace dorsum {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A straight line u(v) through some points, by least squares; its value at v.
float LineAt(const StripePoint* first, const StripePoint* last, float v) {
  double n = 0.0, sv = 0.0, su = 0.0, svv = 0.0, suv = 0.0;
  for (const StripePoint* p = first; p != last; ++p) {
    const double dv = p->v - v;
    n += 1.0;
    sv += dv;
    su += p->u;
    svv += dv * dv;
    suv += dv * p->u;
  }
  const double det = n * svv - sv * sv;
  return static_cast<float>(det > 1e-9 ? (svv * su - sv * suv) / det : su / n);
}

// Cuts of one segment, as indices of the points that begin a piece; `hard` where the stripe itself breaks.
struct Cut {
  std::int32_t at = 0;
  bool hard = true;
};

std::vector<Cut> FindCuts(const LaserStripes& stripes, const StripeSegment& segment,
                          const JointPieceOptions& options) {
  const StripePoint* points = stripes.points.data();
  const std::int32_t end = segment.first + segment.count, k = options.kink_rows;
  std::vector<Cut> cuts{{segment.first, true}};
  float worst = 0.0F;
  std::int32_t worst_at = -1;
  for (std::int32_t i = segment.first + 1; i < end; ++i) {
    const float dv = points[i].v - points[i - 1].v, du = points[i].u - points[i - 1].u;
    if (dv > static_cast<float>(options.max_gap_rows) + 0.5F ||
        std::abs(du) > options.max_jump_px * std::max(1.0F, dv)) {
      cuts.push_back({i, true});
      worst_at = -1;
      continue;
    }
    // Where two surfaces meet, the lines through the points above and below point elsewhere.
    float miss = 0.0F;
    if (i - cuts.back().at >= k && i + k <= end) {
      const float mid = 0.5F * (points[i].v + points[i - 1].v), reach = 0.5F * static_cast<float>(k);
      for (const float v : {mid - reach, mid + reach}) {
        miss = std::max(
            miss, std::abs(LineAt(points + i - k, points + i, v) - LineAt(points + i, points + i + k, v)));
      }
    }
    if (miss > options.kink_px && miss > worst) {
      worst = miss;
      worst_at = i;
    }
    if (worst_at >= 0 && (i - worst_at >= k / 2 || i + 1 == end)) {
      cuts.push_back({worst_at, true});
      worst = 0.0F;
      worst_at = -1;
    } else if (worst_at < 0 && i - cuts.back().at >= options.max_rows && end - i >= options.max_rows / 3) {
      cuts.push_back({i, false});
    }
  }
  cuts.push_back({end, true});
  return cuts;
}

// The order along a pixel's ray as a parabola in w = 1 / (H - z), H the camera's height.
class OrderAlongRay {
 public:
  OrderAlongRay(const Camera& camera, double camera_height, const LaserGeometry& laser, SheetModel model,
                double u, double v, const std::array<double, 3>& heights)
      : camera_height_(camera_height) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto order = OrderAtHeight(camera, laser, model, {u, v}, heights[i]);
      if (!order) return;
      order_[i] = *order;
      w_[i] = 1.0 / (camera_height - heights[i]);
    }
    slope_ = (order_[1] - order_[0]) / (w_[1] - w_[0]);
    curve_ = ((order_[2] - order_[1]) / (w_[2] - w_[1]) - slope_) / (w_[2] - w_[0]);
    valid_ = std::isfinite(slope_) && std::isfinite(curve_) && slope_ != 0.0;
  }

  bool valid() const { return valid_; }
  double Lowest() const { return order_[0]; }
  double Highest() const { return order_[2]; }

  double HeightOf(double order) const {
    double w = w_[0] + (order - order_[0]) / slope_;
    for (int i = 0; i < 3; ++i) {
      const double value = order_[0] + (w - w_[0]) * (slope_ + curve_ * (w - w_[1])) - order;
      w -= value / (slope_ + curve_ * (2.0 * w - w_[0] - w_[1]));
    }
    return camera_height_ - 1.0 / w;
  }

 private:
  double camera_height_ = 0.0, slope_ = 0.0, curve_ = 0.0;
  std::array<double, 3> order_{}, w_{};
  bool valid_ = false;
};

void FillHeights(const LaserStripes& stripes, const DeviceGeometry& device, const LaserGeometry& laser,
                 const JointPieceOptions& options, JointPiece* piece) {
  const SheetModel model = laser.fan ? SheetModel::kCone : SheetModel::kPlane;
  const Eigen::Vector3d centre = device.camera.Center();
  const double low = device.min_height_mm - options.slack_mm, high = device.max_height_mm + options.slack_mm;
  std::vector<const StripePoint*> at;
  std::vector<OrderAlongRay> rays;
  // Rows are those of a fixed comb, so that the pieces' samples meet; a shorter piece has its middle.
  for (std::int32_t i = piece->first; i < piece->first + piece->count; ++i) {
    const StripePoint& p = stripes.points[static_cast<std::size_t>(i)];
    const bool only = piece->count < options.sample_rows && i == piece->first + piece->count / 2;
    if (!only && (piece->count < options.sample_rows || std::lround(p.v) % options.sample_rows != 0)) {
      continue;
    }
    OrderAlongRay ray(device.camera, centre.z(), laser, model, p.u, p.v, {low, 0.5 * (low + high), high});
    if (!ray.valid()) continue;
    at.push_back(&p);
    rays.push_back(ray);
  }
  if (rays.empty()) return;
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  double direction = 0.0;
  for (const OrderAlongRay& ray : rays) {
    const double a = std::min(ray.Lowest(), ray.Highest()), b = std::max(ray.Lowest(), ray.Highest());
    first = std::min(first, static_cast<int>(std::ceil(a)));
    last = std::max(last, static_cast<int>(std::floor(b)));
    direction += ray.Highest() - ray.Lowest();
  }
  first = std::max(first, laser.min_order);
  last = std::min(last, laser.max_order);
  if (first > last) return;
  piece->step = direction > 0.0 ? 1 : -1;
  piece->lowest = direction > 0.0 ? first : last;
  piece->candidates = last - first + 1;
  piece->px_per_mm =
      static_cast<float>(device.camera.fx / (centre.z() - 0.25 * (low + 3.0 * device.min_height_mm + high)));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    JointSample sample{at[i]->u, at[i]->v,
                       std::vector<float>(static_cast<std::size_t>(piece->candidates), kNan)};
    for (int k = 0; k < piece->candidates; ++k) {
      const double z = rays[i].HeightOf(piece->Order(k));
      if (z >= low && z <= high) sample.z[static_cast<std::size_t>(k)] = static_cast<float>(z);
    }
    piece->samples.push_back(std::move(sample));
  }
}

}  // namespace

std::optional<int> JointPiece::Candidate(int order) const {
  const int k = (order - lowest) * step;
  if (k < 0 || k >= candidates) return std::nullopt;
  return k;
}

std::vector<JointPiece> CutPieces(const std::vector<LaserStripes>& stripes, const DeviceGeometry& device,
                                  const JointPieceOptions& options, const Context& context) {
  std::vector<JointPiece> pieces;
  for (std::size_t l = 0; l < stripes.size(); ++l) {
    const LaserGeometry* laser = device.FindLaser(stripes[l].laser);
    if (laser == nullptr) continue;
    for (std::size_t s = 0; s < stripes[l].segments.size(); ++s) {
      if (stripes[l].segments[s].count == 0) continue;
      const std::vector<Cut> cuts = FindCuts(stripes[l], stripes[l].segments[s], options);
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        JointPiece piece;
        piece.laser = static_cast<int>(l);
        piece.segment = static_cast<std::int32_t>(s);
        piece.first = cuts[c].at;
        piece.count = cuts[c + 1].at - cuts[c].at;
        piece.follows = !cuts[c].hard;
        pieces.push_back(std::move(piece));
      }
    }
  }
  ParallelFor(context, 0, static_cast<std::int64_t>(pieces.size()), [&](std::int64_t i) {
    JointPiece& piece = pieces[static_cast<std::size_t>(i)];
    const LaserStripes& own = stripes[static_cast<std::size_t>(piece.laser)];
    FillHeights(own, device, *device.FindLaser(own.laser), options, &piece);
  });
  return pieces;
}

}  // namespace dorsum
