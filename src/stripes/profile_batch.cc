// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "base/simd.h"
#include "stripes/profile_fit.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stripes/profile_batch.cc"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "stripes/profile_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dorsum::HWY_NAMESPACE {

// Fits as many profiles side by side as there are lanes. A lane that is done takes the next task, so that
// none waits for the slowest. Every lane computes what it would compute alone.
class ProfileBatch {
 public:
  ProfileBatch(std::span<const ProfileTask> tasks, const NoiseModel& noise, const ProfileFitOptions& options,
               std::span<ProfileFit> fits)
      : tasks_(tasks), options_(options), fits_(fits), lanes_(noise, options) {}

  void Run() {
    std::size_t busy = 0;
    for (std::size_t lane = 0; lane < Lanes::kLanes; ++lane) {
      lanes_.Clear(lane);
      busy += Feed(lane) ? 1 : 0;
    }
    while (busy > 0) {
      lanes_.Step();
      for (std::size_t lane = 0; lane < Lanes::kLanes; ++lane) {
        if (work_[lane].task == kIdle || lanes_.State(lane) == FitState::kRunning) continue;
        if (!Finish(lane) && !Feed(lane)) --busy;
      }
    }
  }

 private:
  static constexpr std::size_t kIdle = static_cast<std::size_t>(-1);
  enum class Attempt { kFree, kAgain, kHeld };
  struct Work {
    std::size_t task = kIdle;
    Attempt attempt = Attempt::kFree;
    ProfileFit fit{};  // as far as it is known before the end
  };

  // Gives the lane the next task that has pixels enough; false, and the lane idle, when there is none.
  bool Feed(std::size_t lane) {
    while (next_ < tasks_.size()) {
      constexpr std::size_t kAhead =
          8;  // tasks lie in one row each, so none brings the next one's pixels along
      if (next_ + kAhead < tasks_.size()) {
        const ProfileTask& later = tasks_[next_ + kAhead];
        hwy::Prefetch(later.row + static_cast<std::ptrdiff_t>(later.start.u));
      }
      const std::size_t task = next_++;
      const ProfileStart& start = tasks_[task].start;
      if (Begin(lane, task, start.hold_width ? Attempt::kHeld : Attempt::kFree, start)) return true;
    }
    work_[lane].task = kIdle;
    lanes_.Clear(lane);
    return false;
  }

  // A window with few pixels has too few whether or not the width is held.
  bool Begin(std::size_t lane, std::size_t task, Attempt attempt, const ProfileStart& start) {
    constexpr int kLeastPixels = 5;
    Work& work = work_[lane];
    work = {.task = task, .attempt = attempt};
    const std::uint8_t* row = tasks_[task].row;
    ProfileFit& fit = work.fit;
    const int seen = BeginFit(row, start, options_, &fit);
    fit.width_held = attempt == Attempt::kHeld;
    if (seen < kLeastPixels) {
      if (attempt != Attempt::kAgain) fits_[task] = fit;
      return false;
    }
    lanes_.Load(lane, row, start, fit);
    return true;
  }

  // Whether the lane goes on with another attempt at the same task.
  bool Finish(std::size_t lane) {
    Work& work = work_[lane];
    const std::size_t task = work.task;
    const ProfileStart& first = tasks_[task].start;
    lanes_.Store(lane, &work.fit);
    const ProfileFit& fit = work.fit;
    if (work.attempt == Attempt::kAgain) {
      if (fit.ok && std::abs(fit.u - first.u) < 1.5 * std::max(fit.width, first.width)) fits_[task] = fit;
      return false;
    }
    fits_[task] = fit;
    if (work.attempt == Attempt::kHeld) return false;
    if (!fit.ok) return Begin(lane, task, Attempt::kHeld, first);
    // A profile much wider or narrower than the start's asks for its own window.
    const double wanted = std::max(3.0, options_.half_window_sd * fit.width);
    const double had = std::max(3.0, options_.half_window_sd * first.width);
    if (wanted <= 1.25 * had && wanted >= 0.7 * had) return false;
    ProfileStart again = first;
    again.u = fit.u;
    again.width = fit.width;
    return Begin(lane, task, Attempt::kAgain, again);
  }

  std::span<const ProfileTask> tasks_;
  const ProfileFitOptions& options_;
  std::span<ProfileFit> fits_;
  Lanes lanes_;
  std::array<Work, Lanes::kLanes> work_;
  std::size_t next_ = 0;
};

void FitAll(std::span<const ProfileTask> tasks, const NoiseModel& noise, const ProfileFitOptions& options,
            std::span<ProfileFit> fits) {
  const auto batch = std::make_unique<ProfileBatch>(tasks, noise, options, fits);
  batch->Run();
}

}  // namespace dorsum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dorsum {

HWY_EXPORT(FitAll);

std::vector<ProfileFit> FitProfiles(std::span<const ProfileTask> tasks, const NoiseModel& noise,
                                    const ProfileFitOptions& options) {
  std::vector<ProfileFit> fits(tasks.size());
  HWY_DYNAMIC_DISPATCH(FitAll)(tasks, noise, options, fits);
  return fits;
}

ProfileFit FitProfile(const std::uint8_t* row, const ProfileStart& start, const NoiseModel& noise,
                      const ProfileFitOptions& options) {
  return FitProfiles(std::array{ProfileTask{row, start}}, noise, options).front();
}

}  // namespace dorsum
#endif
