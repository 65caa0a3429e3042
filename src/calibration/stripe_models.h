// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "calibration/bundle_problem.h"
#include "calibration/stripe_model.h"

namespace dorsum {

// The models of one state's fans on its planes, for many points.
class StripeModels {
 public:
  explicit StripeModels(const BundleState& state) : planes_(state.planes.size()) {
    for (const FanParameters& fan : state.fans) {
      for (const auto& plane : state.planes)
        models_.emplace_back(state.lens, state.camera_from_world, fan, plane);
    }
  }
  const StripeModel& Of(int fan, int plane) const {
    return models_[static_cast<std::size_t>(fan) * planes_ + static_cast<std::size_t>(plane)];
  }

 private:
  std::size_t planes_;
  std::vector<StripeModel> models_;
};

}  // namespace dorsum
