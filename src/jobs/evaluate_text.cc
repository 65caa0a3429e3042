// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "jobs/evaluate.h"

namespace dorsum {
namespace {

std::string Format(const char* format, auto... values) {
  char buffer[256];
  const int length = std::snprintf(buffer, sizeof buffer, format, values...);
  return {buffer, static_cast<std::size_t>(std::min<int>(length, sizeof buffer - 1))};
}

const char* ShapeName(Shape shape) {
  return shape == Shape::kPlane ? "plane" : shape == Shape::kSphere ? "sphere" : "cylinder";
}

}  // namespace

Json EvaluationToJson(const Evaluation& evaluation) {
  Json captures = Json::array(), differences = Json::array();
  for (const CaptureErrors& c : evaluation.captures) {
    Json models = Json::array();
    for (const ModelErrors& m : c.models) {
      models.push_back({{"model", m.model},
                        {"points", m.points},
                        {"outside_reference", m.outside},
                        {"rmse_mm", m.rmse_mm},
                        {"nrmse", m.nrmse},
                        {"bias_mm", m.bias_mm},
                        {"median_abs_mm", m.median_abs_mm},
                        {"p95_abs_mm", m.p95_abs_mm},
                        {"range_mm", m.range_mm}});
    }
    Json capture = {{"capture", c.name}, {"models", models}};
    if (c.shape) {
      capture["shape"] = {{"kind", ShapeName(c.shape->shape)},
                          {"center_mm", {c.shape->center.x(), c.shape->center.y(), c.shape->center.z()}},
                          {"axis", {c.shape->axis.x(), c.shape->axis.y(), c.shape->axis.z()}},
                          {"radius_mm", c.shape->radius_mm}};
    }
    captures.push_back(capture);
  }
  for (const RepeatDifference& d : evaluation.differences) {
    differences.push_back(
        {{"first", d.first}, {"second", d.second}, {"model", d.model}, {"diff_mm", d.diff_mm}});
  }
  return {
      {"schema", "dorsum/evaluation"}, {"version", 1}, {"captures", captures}, {"differences", differences}};
}

std::string EvaluationToText(const Evaluation& evaluation) {
  std::string out;
  for (const CaptureErrors& c : evaluation.captures) {
    out += c.name + "\n";
    if (c.shape && c.shape->shape != Shape::kPlane) {
      out += Format("  fitted %s of radius %.3f mm\n", ShapeName(c.shape->shape), c.shape->radius_mm);
    }
    out += Format("  %-9s %9s %9s %9s %9s %9s %9s\n", "model", "RMSE mm", "NRMSE", "bias mm", "median mm",
                  "95 % mm", "points");
    for (const ModelErrors& m : c.models) {
      out += Format("  %-9s %9.4f %9.4f %9.4f %9.4f %9.4f %9zu\n", m.model.c_str(), m.rmse_mm, m.nrmse,
                    m.bias_mm, m.median_abs_mm, m.p95_abs_mm, m.points);
      if (m.outside > 0) out += Format("            %zu of them lie beside the reference\n", m.outside);
    }
  }
  if (!evaluation.differences.empty()) {
    out += "differences of RMSE between repeats (5.2)\n";
    for (const RepeatDifference& d : evaluation.differences) {
      out += "  " + d.first + " and " + d.second + Format(": %-9s %8.4f mm\n", d.model.c_str(), d.diff_mm);
    }
  }
  return out;
}

}  // namespace dorsum
