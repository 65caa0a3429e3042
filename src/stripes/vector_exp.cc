// SPDX-License-Identifier: Apache-2.0
#include "stripes/vector_exp.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stripes/vector_exp.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "stripes/lane_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

void RaiseToExp(std::span<float> values) {
  constexpr std::size_t kLanes = hn::MaxLanes(D());
  std::size_t i = 0;
  for (; i + kLanes <= values.size(); i += kLanes)
    hn::StoreU(Exp(hn::LoadU(D(), &values[i])), D(), &values[i]);
  if (i == values.size()) return;
  std::array<float, kLanes> rest{};
  std::copy(values.begin() + static_cast<std::ptrdiff_t>(i), values.end(), rest.begin());
  hn::StoreU(Exp(hn::LoadU(D(), rest.data())), D(), rest.data());
  std::copy_n(rest.begin(), values.size() - i, &values[i]);
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(RaiseToExp);

void RaiseToExp(std::span<float> values) { HWY_DYNAMIC_DISPATCH(RaiseToExp)(values); }

}  // namespace dorsum
#endif
