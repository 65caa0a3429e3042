// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "base/context.h"
#include "calibration/bundle_problem.h"
#include "calibration/stripe_model.h"

namespace dorsum {

// Where a bundle's parameters stand in one list: lens, camera pose, fans, planes, the boards' bow, boards.
struct BundleLayout {
  static int Fan(int fan) { return kLensSize + kPoseSize + kFanSize * fan; }
  int Plane(int plane) const { return Fan(fans) + kPlaneSize * plane; }
  int Bow() const { return Plane(planes); }
  int Board(int board) const { return Bow() + kBoardBowSize + kPoseSize * board; }
  int Size() const { return Board(boards); }

  int fans = 0, planes = 0, boards = 0;
};

// A least-squares problem where it stands: half the weighted sum of squares, and with g its gradient and N
// its normal matrix, N step = -g leads to its end as far as it is linear.
struct NormalEquations {
  double cost = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd normal;
};

// The residuals of BundleProblemOptions over one set of data, of which there may be many states. Points of
// one fan on one plane are worked out together, in pieces that are the same for any number of threads.
class BundleEquations {
 public:
  BundleEquations(const BundleData& data, const BundleProblemOptions& options, const BundleState& state);
  ~BundleEquations();

  // Gradient and matrix hold all parameters, also those that do not move. The cost is not finite where the
  // state means nothing.
  NormalEquations At(const BundleState& state, const Context& context);
  // Lets the next search for points begin anew, after a state that led astray.
  void Forget();

  const std::vector<int>& Free() const { return free_; }  // places in the list of those that move
  const BundleLayout& Layout() const { return layout_; }
  int Residuals() const { return residuals_; }

 private:
  struct Piece;  // of the points or of the boards
  struct Sum;

  void FindFree();
  void SortPoints();
  void AddPoints(const BundleState& state, const Piece& piece, Sum* sum);
  void AddCorners(const BundleState& state, const Piece& piece, Sum* sum) const;
  void AddLying(const BundleState& state, NormalEquations* out) const;
  void AddPriors(const BundleState& state, NormalEquations* out) const;

  const BundleData& data_;
  const BundleProblemOptions& options_;
  BundleLayout layout_;
  std::vector<int> free_;
  int residuals_ = 0;
  std::vector<std::size_t> sorted_;  // indices of the points
  std::vector<StripeSearch> searches_;
  std::vector<Piece> pieces_;
};

}  // namespace dorsum
