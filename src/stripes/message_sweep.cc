// SPDX-License-Identifier: Apache-2.0
#include "stripes/message_sweep.h"

#include <algorithm>
#include <limits>

#include "base/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stripes/message_sweep.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using MessageD = hn::CappedTag<float, kMessageLanes>;

// Minima and sums of few numbers each, in the same order whatever the number of lanes.
class Sweeper {
 public:
  explicit Sweeper(MessageTable* table)
      : t_(*table), belief_(table->wide), base_(table->wide), fresh_(table->wide) {}

  float SendFrom(std::size_t i, bool ahead) {
    const MessageD d;
    Gather(i);
    auto change = hn::Zero(d);
    for (const MessageEnd& e : t_.ends[i]) {
      if ((e.other > i) != ahead) continue;
      const float *in = &t_.messages[e.in], *cost = &t_.costs[e.cost];
      float* out = &t_.messages[e.out];
      ForLanes(
          [&](std::size_t a) { hn::StoreU(hn::LoadU(d, &belief_[a]) - hn::LoadU(d, in + a), d, &base_[a]); });
      auto least = hn::Set(d, std::numeric_limits<float>::max());
      ForLanes([&](std::size_t b) {
        auto fresh = hn::Set(d, std::numeric_limits<float>::max());
        for (std::size_t a = 0; a < t_.candidates[i]; ++a)
          fresh = hn::Min(fresh, hn::Set(d, base_[a]) + hn::LoadU(d, cost + a * t_.wide + b));
        hn::StoreU(fresh, d, &fresh_[b]);
        least = hn::Min(least, fresh);
      });
      least = hn::MinOfLanes(d, least);
      ForLanes([&](std::size_t b) {
        const auto now = hn::LoadU(d, &fresh_[b]) - least;
        change = hn::Max(change, hn::Abs(now - hn::LoadU(d, out + b)));
        hn::StoreU(now, d, out + b);
      });
    }
    return hn::GetLane(hn::MaxOfLanes(d, change));
  }

 private:
  template <class Body>
  HWY_INLINE void ForLanes(const Body& body) const {
    for (std::size_t a = 0; a < t_.wide; a += hn::Lanes(MessageD())) body(a);
  }

  // The piece's belief, shared among the messages that it sends.
  void Gather(std::size_t i) {
    const MessageD d;
    int before = 0, behind = 0;
    for (const MessageEnd& e : t_.ends[i]) ++(e.other < i ? before : behind);
    const auto share = hn::Set(d, 1.0F / static_cast<float>(std::max({before, behind, 1})));
    ForLanes([&](std::size_t a) {
      auto belief = hn::LoadU(d, &t_.unary[i * t_.wide + a]);
      for (const MessageEnd& e : t_.ends[i]) belief = belief + hn::LoadU(d, &t_.messages[e.in + a]);
      hn::StoreU(belief * share, d, &belief_[a]);
    });
  }

  MessageTable& t_;
  std::vector<float> belief_, base_, fresh_;  // of the piece and the message at work
};

float Sweep(bool ahead, std::size_t first, std::size_t end, MessageTable* table) {
  Sweeper sweeper(table);
  float change = 0.0F;
  for (std::size_t k = 0; k < end - first; ++k)
    change = std::max(change, sweeper.SendFrom(ahead ? first + k : end - 1 - k, ahead));
  return change;
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(Sweep);

float SweepMessages(bool ahead, std::size_t first, std::size_t end, MessageTable* table) {
  return HWY_DYNAMIC_DISPATCH(Sweep)(ahead, first, end, table);
}

}  // namespace dorsum
#endif
