// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"
#include "surface/shape_fit.h"

namespace dorsum {

// What the points are held against; exactly one of the three.
struct EvaluateRequest {
  std::vector<std::filesystem::path>
      out_dirs;                           // what `dorsum reconstruct` wrote; the first, then repeats of it
  std::optional<double> plane_height_mm;  // a plane parallel to the backplane (h of 5.1)
  std::optional<Shape> fit;               // a shape fitted to all lasers' points
  std::optional<std::filesystem::path> against;  // a reference mesh in the same world frame
  double shrink_px = 3.0;                        // the mask is shrunk by this, px, 0 to 100
};

// Errors of one model: one laser's points, or all (document §5.1).
struct ModelErrors {
  std::string model;        // "laser 0", "merged"
  std::size_t points = 0;   // on the shrunk mask; none is thrown away
  std::size_t outside = 0;  // of them, those that the reference mesh does not cover
  double rmse_mm = 0.0;     // equation 5.1
  double nrmse = 0.0;       // RMSE over the range (max z - min z) of the points, as Table 5.1 has it
  double bias_mm = 0.0, median_abs_mm = 0.0, p95_abs_mm = 0.0;
  double range_mm = 0.0;  // max z - min z
};

struct CaptureErrors {
  std::string name;                 // of the folder
  std::vector<ModelErrors> models;  // each laser, then merged
  std::optional<ShapeFit> shape;
};

// Equation 5.2 for one pair of repeats.
struct RepeatDifference {
  std::string first, second, model;
  double diff_mm = 0.0;
};

struct Evaluation {
  std::vector<CaptureErrors> captures;
  std::vector<RepeatDifference> differences;
};

// The job behind `dorsum evaluate`.
Result<Evaluation> Evaluate(const EvaluateRequest& request, const Context& context);

Json EvaluationToJson(const Evaluation& evaluation);
// The same as a table for people.
std::string EvaluationToText(const Evaluation& evaluation);

}  // namespace dorsum
