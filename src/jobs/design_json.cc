// SPDX-License-Identifier: Apache-2.0
#include "jobs/design.h"

namespace dorsum {
namespace {

Json LaserToJson(const LaserFigures& l) {
  const VolumeFigures& v = l.volume;
  return {{"x_mm", l.x_mm},
          {"baseline_mm", l.baseline_mm},
          {"triangulation_deg", l.triangulation_deg},
          {"stripes_over_hand", l.stripes_in_view},
          {"unambiguous_mm", l.unambiguous_mm},
          {"unambiguous_beyond_volume", l.beyond_volume},
          {"used_share", v.used},
          {"spacing_low_mm", v.spacing_low_mm},
          {"spacing_low_px", v.spacing_low_px},
          {"spacing_high_mm", v.spacing_high_mm},
          {"spacing_high_px", v.spacing_high_px},
          {"depth_mm_per_px", {v.least_depth_mm_per_px, v.middle_depth_mm_per_px, v.most_depth_mm_per_px}},
          {"dimmest_peak", v.dimmest_peak},
          {"brightest_peak", v.brightest_peak},
          {"saturated_share", v.saturated},
          {"spacing_over_width", v.narrowest},
          {"row_sigma_px", v.row_sigma_px},
          {"row_sigma_mm", v.row_sigma_mm},
          {"pooled_sigma_mm", v.pooled_sigma_mm},
          {"points_per_cm2", v.points_per_cm2}};
}

Json CombToJson(const CombFigures& c) {
  return {{"height_mm", c.height_mm},
          {"seen", c.seen},
          {"coverage", c.coverage},
          {"any_coverage", c.any_coverage},
          {"all_coverage", c.all_coverage},
          {"spacing_mm", c.spacing_mm},
          {"largest_gap_mm", c.largest_gap_mm},
          {"closest_share", c.closest},
          {"closest_lasers", {c.closest_a, c.closest_b}}};
}

Json HitToJson(const SearchHit& h) {
  return {{"lines_per_mm", h.description.grating.lines_per_mm},
          {"orders", h.description.grating.orders},
          {"baseline_mm", h.baseline_mm},
          {"pitch_mm", h.pitch_mm},
          {"slit_um", h.slit_um},
          {"spacing_mm", h.spacing_mm},
          {"unambiguous_mm", h.unambiguous_mm},
          {"coverage", h.coverage},
          {"central_efficiency", h.central_efficiency},
          {"camera_height_mm", h.description.camera.position_mm.z()},
          {"points_per_cm2", h.points_per_cm2},
          {"pooled_sigma_mm", h.pooled_sigma_mm},
          {"merit", h.merit}};
}

}  // namespace

Json DesignToJson(const DesignReport& r) {
  Json orders = Json::array(), lasers = Json::array(), combs = Json::array();
  for (const OrderFigures& o : r.orders) {
    orders.push_back({{"order", o.order},
                      {"described", o.described},
                      {"slit", o.slit},
                      {"angle_deg", o.angle_deg},
                      {"x_low_mm", o.low_mm},
                      {"x_high_mm", o.high_mm},
                      {"over_hand", o.in_view}});
  }
  for (const LaserFigures& l : r.lasers) lasers.push_back(LaserToJson(l));
  for (const CombFigures& c : r.combs) combs.push_back(CombToJson(c));
  const auto optional = [](const std::optional<double>& v) { return v ? Json(*v) : Json(nullptr); };
  const Eigen::AlignedBox2d& hand = r.device.hand;
  return {{"schema", "dorsum/design"},
          {"version", 1},
          {"name", r.device.description.name},
          {"step", r.device.description.grating.Step()},
          {"slit_um", r.slit_um},
          {"slit_brightest_um", r.slit_brightest_um},
          {"hand_area_mm", {hand.min().x(), hand.min().y(), hand.max().x(), hand.max().y()}},
          {"surface",
           {{"albedo", r.surface.albedo}, {"skin", r.surface.skin}, {"pooled_rows", r.surface.pooled_rows}}},
          {"seen_low_mm", {r.seen_low_mm.x(), r.seen_low_mm.y()}},
          {"seen_high_mm", {r.seen_high_mm.x(), r.seen_high_mm.y()}},
          {"px_per_mm", {r.px_per_mm_low, r.px_per_mm_high}},
          {"orders", orders},
          {"lasers", lasers},
          {"combs", combs},
          {"joint_unambiguous_mm", optional(r.ambiguity.joint_mm)},
          {"joint_margin_mm", optional(r.ambiguity.joint_margin_mm)},
          {"points_per_cm2", r.points_per_cm2},
          {"row_sigma_mm", r.row_sigma_mm},
          {"pooled_sigma_mm", r.pooled_sigma_mm},
          {"merit", r.merit},
          {"warnings", r.warnings},
          {"explanations", r.explanations}};
}

Json SummaryToJson(const DesignSummary& summary) {
  Json json = DesignToJson(summary.report);
  if (summary.search) {
    Json hits = Json::array();
    for (const SearchHit& h : summary.search->hits) hits.push_back(HitToJson(h));
    json["search"] = {{"designs", hits}, {"refused", summary.search->refused}};
  }
  json["files"] = summary.files;
  return json;
}

}  // namespace dorsum
