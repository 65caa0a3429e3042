// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/hand_population.h"

namespace dorsum {
namespace {

double Clamped(double z) { return std::clamp(z, -2.8, 2.8); }

// Loadings on the four common factors; the residual brings the variance to one. Chosen so that the products
// give the measured correlations (length-palm .79, length-breadth .58, palm-finger .6, finger-finger .85,
// breadth-breadth .75, length-breadth of one finger .42).
struct Loading {
  double size, broad, fingers, girth;
  double Residual() const {
    return std::sqrt(1.0 - size * size - broad * broad - fingers * fingers - girth * girth);
  }
};
constexpr Loading kHandLength = {0.80, -0.35, 0.30, 0.0};
constexpr Loading kPalmLength = {0.84, -0.34, 0.0, 0.0};
constexpr Loading kFingerLength = {0.64, -0.28, 0.60, 0.0};
constexpr Loading kHandBreadth = {0.86, 0.33, 0.0, 0.0};
constexpr Loading kWrist = {0.78, 0.30, 0.0, 0.0};
constexpr Loading kFingerBreadth = {0.75, 0.25, 0.0, 0.35};

struct Factors {
  double size, broad, fingers, girth;
  double Draw(const Loading& load, double residual) const {
    const double common = load.size * size + load.broad * broad + load.fingers * fingers + load.girth * girth;
    return Clamped(common + load.Residual() * residual);
  }
};

// Depth of the ellipse with this breadth and circumference (perimeter ~ pi times the mean diameter).
double EllipseDepth(double circumference, double breadth) {
  return 2.0 * circumference / std::numbers::pi - breadth;
}

double Depth(double mean_circumference, double mean_breadth, double breadth_z, Rng& rng) {
  const double z = Clamped(0.75 * breadth_z + 0.66 * rng.Normal());
  return EllipseDepth(mean_circumference, mean_breadth) * (1.0 + 0.07 * z);
}

FingerShape SampleFinger(const Population& population, int i, const Factors& factors, double palm_scale,
                         Rng& rng) {
  FingerShape finger;
  const MeanSd& breadth = population.finger_breadth[i];
  finger.length = population.finger_length[i].At(factors.Draw(kFingerLength, rng.Normal()));
  const double breadth_z = factors.Draw(kFingerBreadth, rng.Normal());
  finger.pip_breadth = breadth.At(breadth_z);
  finger.pip_depth = Depth(population.pip_circumference[i], breadth.mean, breadth_z, rng);
  finger.dip_breadth = kDipBreadthRatio * finger.pip_breadth * (1.0 + 0.022 * Clamped(rng.Normal()));
  const double dip_breadth_mean = kDipBreadthRatio * breadth.mean;
  finger.dip_depth = Depth(population.dip_circumference[i], dip_breadth_mean, breadth_z, rng);

  const double chain = finger.length + palm_scale * kMcpToBase[i] * (1.0 + 0.03 * Clamped(rng.Normal()));
  std::array<double, 3> share;
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += share[k] = kLinkShare[i][k] * (1.0 + 0.025 * Clamped(rng.Normal()));
  finger.proximal_link = chain * share[0] / sum;
  finger.middle_link = chain * share[1] / sum;
  finger.distal_link = chain * share[2] / sum;

  constexpr std::array<double, 4> kMeanBow = {-0.8, 0.0, 0.6,
                                              1.2};  // index and little lean to the middle finger
  finger.bow = kMeanBow[i] + 0.5 * Clamped(rng.Normal());
  finger.nail_breadth = finger.dip_breadth * (0.70 + 0.03 * Clamped(rng.Normal()));
  finger.nail_length = finger.nail_breadth * (1.02 + 0.08 * Clamped(rng.Normal()));
  return finger;
}

ThumbShape SampleThumb(const Population& population, const Factors& factors, double hand_length, Rng& rng) {
  ThumbShape thumb;
  thumb.length = population.thumb_length.At(factors.Draw(kFingerLength, rng.Normal()));
  const double breadth_z = factors.Draw(kFingerBreadth, rng.Normal());
  thumb.ip_breadth = population.thumb_breadth.At(breadth_z);
  thumb.ip_depth = Depth(population.thumb_circumference, population.thumb_breadth.mean, breadth_z, rng);
  const double share = 0.53 + 0.012 * Clamped(rng.Normal());
  thumb.proximal_link = share * thumb.length;
  thumb.distal_link = (1.0 - share) * thumb.length;
  thumb.metacarpal_link = 0.236 * hand_length * (1.0 + 0.03 * Clamped(rng.Normal()));
  thumb.nail_breadth = thumb.ip_breadth * (0.66 + 0.025 * Clamped(rng.Normal()));
  thumb.nail_length = thumb.nail_breadth * (0.98 + 0.07 * Clamped(rng.Normal()));
  return thumb;
}

HandDetail SampleDetail(Sex sex, Rng& rng) {
  HandDetail detail;
  detail.seed = rng.Next();
  const double bold = sex == Sex::kMan ? 1.0 : 0.75;  // softer relief of tendons, veins and knuckles
  constexpr std::array<double, 4> kKnuckle = {1.6, 2.2, 1.8, 1.6};
  const double knuckles = rng.Normal(), tendons = rng.Normal();
  for (int i = 0; i < 4; ++i) {
    detail.knuckle[i] = bold * kKnuckle[i] * std::exp(0.20 * knuckles + 0.15 * Clamped(rng.Normal()));
    detail.tendon[i] = bold * 0.62 * std::exp(0.25 * tendons + 0.20 * Clamped(rng.Normal()));
  }
  detail.vein = bold * 0.40 * std::exp(0.40 * Clamped(rng.Normal()));
  detail.crease = 0.32 * std::exp(0.25 * Clamped(rng.Normal()));
  detail.relief = rng.Uniform(0.02, 0.045);
  const double lightness = std::exp(0.10 * Clamped(rng.Normal()));
  const double redness = 1.0 + 0.04 * Clamped(rng.Normal());
  detail.skin = Eigen::Vector3d(0.55 * redness * lightness, 0.43 * lightness, 0.32 * lightness).cast<float>();
  return detail;
}

double Jitter(Rng& rng, double relative_sd) {
  return 1.0 + relative_sd * std::clamp(rng.Normal(), -2.5, 2.5);
}

}  // namespace

double HandShape::WristDepth() const {
  constexpr double kSquareness = 1.05;  // perimeter of a superellipse of exponent 2.5 over the ellipse's
  return EllipseDepth(wrist_circumference / kSquareness, wrist_breadth);
}

HandShape SampleHandShape(Sex sex, Rng& rng) {
  const Population& population = sex == Sex::kMan ? kMen : kWomen;
  const Factors factors = {rng.Normal(), rng.Normal(), rng.Normal(), rng.Normal()};
  HandShape shape;
  const double length_z = factors.Draw(kHandLength, rng.Normal());
  const double palm_z = factors.Draw(kPalmLength, rng.Normal());
  const double breadth_own = rng.Normal();
  const double breadth_z = factors.Draw(kHandBreadth, breadth_own);
  // Circumference and breadth share part of what the factors leave over: r = .92.
  const double circumference_z = factors.Draw(kHandBreadth, 0.44 * breadth_own + 0.898 * rng.Normal());
  shape.palm_length = population.palm_length.At(palm_z);
  shape.hand_breadth = population.hand_breadth.At(breadth_z);
  shape.hand_breadth_open = shape.hand_breadth * population.hand_breadth_open.mean /
                            population.hand_breadth.mean * (1.0 + 0.012 * Clamped(rng.Normal()));
  shape.hand_circumference = population.hand_circumference.At(circumference_z);
  shape.wrist_circumference = population.wrist_circumference.At(factors.Draw(kWrist, rng.Normal()));
  const double wrist_z =
      (shape.wrist_circumference - population.wrist_circumference.mean) / population.wrist_circumference.sd;
  shape.wrist_breadth = population.wrist_breadth.At(Clamped(0.90 * wrist_z + 0.43 * rng.Normal()));
  shape.palm_thickness = population.palm_thickness.At(Clamped(0.75 * circumference_z + 0.66 * rng.Normal()));

  const double palm_scale = shape.palm_length / kMen.palm_length.mean;
  for (int i = 0; i < 4; ++i) shape.fingers[i] = SampleFinger(population, i, factors, palm_scale, rng);
  const double hand_length = population.hand_length.At(length_z);
  shape.thumb = SampleThumb(population, factors, hand_length, rng);

  const double central = hand_length - shape.fingers[1].length;
  const double tilt = 0.3 + 0.7 * Clamped(rng.Normal());
  shape.hand_length = hand_length;
  shape.crotch_height = {population.crotch_thumb_ratio * central + 2.2 * Clamped(rng.Normal()),
                         central + tilt, central - tilt,
                         central - population.crotch_drop_little * palm_scale + 1.5 * Clamped(rng.Normal())};
  shape.detail = SampleDetail(sex, rng);
  return shape;
}

HandShape VaryForSession(const HandShape& shape, Rng& rng) {
  constexpr double kLengthSd = 0.003, kGirthSd = 0.0125, kFingerGirthSd = 0.005;
  HandShape varied = shape;
  const double palm = Jitter(rng, kLengthSd), girth = Jitter(rng, kGirthSd);
  varied.palm_length *= palm;
  for (double& height : varied.crotch_height) height *= palm;
  for (double* measure : {&varied.hand_breadth, &varied.hand_breadth_open, &varied.hand_circumference,
                          &varied.palm_thickness}) {
    *measure *= 1.0 + 0.6 * (girth - 1.0);  // more bone, less soft tissue than a finger
  }
  for (double* measure : {&varied.wrist_breadth, &varied.wrist_circumference}) *measure *= girth;
  for (FingerShape& finger : varied.fingers) {
    const double length = Jitter(rng, kLengthSd), own_girth = girth * Jitter(rng, kFingerGirthSd);
    for (double* measure :
         {&finger.length, &finger.proximal_link, &finger.middle_link, &finger.distal_link}) {
      *measure *= length;
    }
    for (double* measure : {&finger.pip_breadth, &finger.pip_depth, &finger.dip_breadth, &finger.dip_depth}) {
      *measure *= own_girth;
    }
  }
  ThumbShape& thumb = varied.thumb;
  const double length = Jitter(rng, kLengthSd), thumb_girth = girth * Jitter(rng, kFingerGirthSd);
  for (double* measure : {&thumb.length, &thumb.metacarpal_link, &thumb.proximal_link, &thumb.distal_link}) {
    *measure *= length;
  }
  for (double* measure : {&thumb.ip_breadth, &thumb.ip_depth}) *measure *= thumb_girth;
  varied.hand_length = 0.5 * (varied.crotch_height[1] + varied.crotch_height[2]) + varied.fingers[1].length;
  return varied;
}

}  // namespace dorsum
