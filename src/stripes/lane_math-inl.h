// SPDX-License-Identifier: Apache-2.0
// Included once for each instruction set (Highway), by profile_batch.cc.
#if defined(DORSUM_STRIPES_LANE_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DORSUM_STRIPES_LANE_MATH_INL_H_
#undef DORSUM_STRIPES_LANE_MATH_INL_H_
#else
#define DORSUM_STRIPES_LANE_MATH_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V Set(float value) { return hn::Set(D(), value); }

// exp to about 1e-7 of it, by its series around the nearest power of 2; without fused products, so that every
// machine finds the same.
HWY_INLINE V Exp(V x) {
  const hn::RebindToSigned<D> di;
  x = hn::Clamp(x, Set(-87.0F), Set(88.0F));
  const auto n = hn::NearestInt(x * Set(1.44269504F));
  const V whole = hn::ConvertTo(D(), n);
  const V r = (x - whole * Set(0.693359375F)) - whole * Set(-2.12194440e-4F);
  V y = Set(1.0F / 720.0F);
  for (const float c : {1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F}) y = y * r + Set(c);
  return y * hn::BitCast(D(), hn::ShiftLeft<23>(n + hn::Set(di, 127)));
}

// Natural logarithm of positive normal numbers, by the series of atanh.
HWY_INLINE V Log(V x) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, x);
  // The exponent that leaves a mantissa between sqrt(1/2) and sqrt(2).
  const auto exponent = hn::ShiftRight<23>(bits - hn::Set(di, 0x3f3504f3));
  const V m = hn::BitCast(D(), bits - hn::ShiftLeft<23>(exponent));
  const V s = (m - Set(1.0F)) / (m + Set(1.0F)), q = s * s;
  V y = Set(2.0F / 9.0F);
  for (const float c : {2.0F / 7.0F, 2.0F / 5.0F, 2.0F / 3.0F, 2.0F}) y = y * q + Set(c);
  return y * s + hn::ConvertTo(D(), exponent) * Set(0.69314718F);
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // DORSUM_STRIPES_LANE_MATH_INL_H_
