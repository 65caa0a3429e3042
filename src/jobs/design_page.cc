// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "report/design_pictures.h"
#include "report/drawing.h"
#include "report/html.h"
#include "report/overview.h"

namespace dorsum {
namespace {

constexpr int kStripePoints = 81;

DesignDrawing DrawingOf(const DesignedDevice& device) {
  DesignDrawing out;
  out.camera = device.camera;
  out.hand = device.hand;
  out.low_mm = device.description.working_heights_mm[0];
  out.high_mm = device.description.working_heights_mm[1];
  for (std::size_t k = 0; k < device.lasers.size(); ++k) {
    const DesignedLaser& laser = device.lasers[k];
    out.gratings.push_back(laser.fan.origin);
    for (int m = -laser.Orders(); m <= laser.Orders(); ++m) {
      DesignDrawing::Stripe stripe{static_cast<int>(k), m, {}};
      for (int i = 0; i < kStripePoints; ++i) {
        const double share = 2.0 * i / (kStripePoints - 1.0) - 1.0;
        const auto ray = DiffractedRay(laser.fan, m, std::sin(share * laser.half_angle));
        const auto t = ray ? Intersect(*ray, {Eigen::Vector3d::UnitZ(), 0.0}) : std::nullopt;
        if (t && ray->direction.z() < -0.05) stripe.points.push_back(ray->At(*t));
      }
      out.stripes.push_back(stripe);
    }
  }
  return out;
}

using Value = std::function<double(const FieldSample&)>;

// One line for each laser at the volume's middle.
std::vector<DesignCurve> OverX(const DesignReport& report, const Value& value) {
  const auto& [low, high] = report.device.description.working_heights_mm;
  std::vector<DesignCurve> curves;
  for (int k = 0; k < static_cast<int>(report.lasers.size()); ++k) {
    DesignCurve curve{"laser " + std::to_string(k), {}};
    for (const FieldSample& s : SampleField(report.device, k, 0.5 * (low + high), report.surface)) {
      curve.points.emplace_back(s.x_mm, s.used ? value(s) : std::numeric_limits<double>::quiet_NaN());
    }
    curves.push_back(curve);
  }
  return curves;
}

std::vector<DesignCurve> OverHeight(const DesignReport& report) {
  DesignCurve spacing{"one laser", {}}, gap{"largest gap", {}}, apart{"closest two", {}};
  for (const CombFigures& c : report.combs) {
    if (c.all_coverage == 0.0) continue;
    spacing.points.emplace_back(c.height_mm, c.spacing_mm);
    gap.points.emplace_back(c.height_mm, c.largest_gap_mm);
    if (report.lasers.size() > 1) apart.points.emplace_back(c.height_mm, c.closest * c.spacing_mm);
  }
  std::vector<DesignCurve> curves = {spacing, gap};
  if (!apart.points.empty()) curves.push_back(apart);
  return curves;
}

HtmlTable OrderTable(const DesignReport& report) {
  HtmlTable table;
  table.header = {"Order",       "Brightness as described", "By the slit (2.2)",
                  "Angle (deg)", "x on the backplane (mm)", "x at the volume's top (mm)"};
  table.caption = "Orders of laser 0, in the middle of the stripe. Brightness is over the central order's.";
  for (const OrderFigures& o : report.orders) {
    table.rows.push_back({std::to_string(o.order),
                          {FormatNumber(o.described, 3), o.described},
                          {FormatNumber(o.slit, 3), o.slit},
                          FormatNumber(o.angle_deg, 2),
                          FormatNumber(o.low_mm, 2) + (o.in_view ? "" : " (outside)"),
                          FormatNumber(o.high_mm, 2)});
  }
  return table;
}

HtmlTable LaserTable(const DesignReport& report) {
  HtmlTable table;
  table.header = {
      "Laser",         "Baseline (mm)",    "Angle (deg)",      "Spacing (mm)",        "Spacing (px)",
      "Depth (mm/px)", "Unambiguous (mm)", "Lit and seen (%)", "Error, one row (mm)", "Error, pooled (mm)"};
  table.caption =
      "Spacing on the backplane; depth per pixel at the volume's middle; errors are standard deviations "
      "expected of heights.";
  for (std::size_t k = 0; k < report.lasers.size(); ++k) {
    const LaserFigures& l = report.lasers[k];
    table.rows.push_back({std::to_string(k), FormatNumber(l.baseline_mm, 1),
                          FormatNumber(l.triangulation_deg, 1), FormatNumber(l.volume.spacing_low_mm, 2),
                          FormatNumber(l.volume.spacing_low_px, 1),
                          FormatNumber(l.volume.middle_depth_mm_per_px, 3), FormatNumber(l.unambiguous_mm, 1),
                          FormatNumber(100.0 * l.volume.used, 0), FormatNumber(l.volume.row_sigma_mm, 3),
                          FormatNumber(l.volume.pooled_sigma_mm, 3)});
  }
  return table;
}

HtmlTable SearchTable(const SearchResult& search) {
  HtmlTable table;
  table.header = {"Lines/mm",         "Orders",     "Baseline (mm)", "Pitch (mm)", "Slit (um)",
                  "Unambiguous (mm)", "Points/cm2", "Error (mm)",    "Merit"};
  table.caption = "Merit is points per square centimetre over the expected error in mm.";
  table.first_number = 0;
  const double most = std::max(1e-9, search.hits.front().merit);
  for (const SearchHit& h : search.hits) {
    table.rows.push_back({FormatNumber(h.description.grating.lines_per_mm, 0),
                          std::to_string(h.description.grating.orders),
                          FormatNumber(h.baseline_mm, 0),
                          FormatNumber(h.pitch_mm, 2),
                          FormatNumber(h.slit_um, 2),
                          FormatNumber(h.unambiguous_mm, 1),
                          FormatNumber(h.points_per_cm2, 0),
                          FormatNumber(h.pooled_sigma_mm, 4),
                          {FormatNumber(h.merit, 0), h.merit / most}});
  }
  return table;
}

std::vector<HtmlFact> Facts(const DesignReport& r) {
  return {
      {"Grating", FormatNumber(r.device.description.grating.lines_per_mm, 0), "lines/mm"},
      {"Points", FormatNumber(r.points_per_cm2, 0), "per cm2"},
      {"Expected error", FormatNumber(r.pooled_sigma_mm, 3), "mm"},
      {"Spacing of a laser's stripes", FormatNumber(r.lasers.front().volume.spacing_low_mm, 1), "mm"},
      {"Unambiguous alone",
       FormatNumber(*std::min_element(r.ambiguity.single_mm.begin(), r.ambiguity.single_mm.end()), 0), "mm"},
      {"View on the backplane",
       FormatNumber(r.seen_low_mm.x(), 0) + " x " + FormatNumber(r.seen_low_mm.y(), 0), "mm"}};
}

}  // namespace

DesignPictures DrawDesign(const DesignReport& report) {
  const DesignDrawing drawing = DrawingOf(report.device);
  const std::string x = "x across the stripes (mm), at the volume's middle";
  DesignPictures out;
  out.side = DrawDesignFromTheSide(drawing);
  out.seen = DrawDesignAsSeen(drawing);
  out.depth = DrawDesignCurves(OverX(report, [](const FieldSample& s) { return 1e3 * s.depth_mm_per_px; }), x,
                               "depth per pixel (um/px)");
  out.spacing = DrawDesignCurves(OverX(report, [](const FieldSample& s) { return s.spacing_mm; }), x,
                                 "stripe spacing (mm)");
  out.error = DrawDesignCurves(OverX(report, [](const FieldSample& s) { return 1e3 * s.pooled_sigma_mm; }), x,
                               "expected error (um)");
  out.gap = DrawDesignCurves(OverHeight(report), "height (mm)", "across the stripes (mm)");
  return out;
}

cv::Mat Overview(const DesignReport& report, const DesignPictures& pictures) {
  const std::string subtitle = FormatNumber(report.device.description.grating.lines_per_mm, 0) +
                               " lines/mm, " + FormatNumber(report.points_per_cm2, 0) +
                               " points per cm2, expected error " + FormatNumber(report.pooled_sigma_mm, 3) +
                               " mm";
  return OverviewPicture(report.device.description.name, subtitle,
                         {{pictures.side, "from the side"},
                          {pictures.seen, "the backplane as the camera sees it"},
                          {pictures.depth, "depth per pixel"},
                          {pictures.spacing, "spacing of one laser's stripes"},
                          {pictures.error, "expected error of a point"},
                          {pictures.gap, "how the lasers' combs lie between each other"}},
                         {.width_px = 1500, .columns = 2});
}

std::string DesignPage(const DesignSummary& summary, const DesignPictures& pictures) {
  const DesignReport& r = summary.report;
  HtmlPage page(
      "Design: " + r.device.description.name,
      "What this device will measure, by the grating equations (2.2 to 2.7), the cone of each order and "
      "the light budget. No mounting errors, no calibration errors.");
  page.Facts(Facts(r));
  std::vector<std::string> notes = r.explanations;
  notes.insert(notes.end(), r.warnings.begin(), r.warnings.end());
  page.Warnings(notes);
  if (summary.search) {
    page.Section("Search",
                 "The best design of each grating that meets the constraints; the page shows the first.");
    page.Table(SearchTable(*summary.search));
    for (const std::string& why : summary.search->refused) page.Paragraph(why + ".");
  }
  page.Section("Geometry",
               "Millimetres in the frame of the design: z up from the backplane, x across the stripes.");
  page.Figures(
      {{pictures.side, ImageKind::kDrawing, "From the side.",
        "Camera with its field of view; laser 0's light sheets in the colours of their orders, the other "
        "lasers' dimmer."},
       {pictures.seen, ImageKind::kDrawing, "The backplane as the camera sees it.",
        "Stripes of laser 0 in the colours of their orders, the other lasers' dimmer. Dashed: the hand area "
        "at the bottom and at the top of the working volume."}});
  page.Section("Lasers");
  page.Table(LaserTable(r));
  page.Figures(
      {{pictures.depth, ImageKind::kDrawing, "Depth per pixel.",
        "How much height one pixel of a stripe's shift means."},
       {pictures.error, ImageKind::kDrawing, "Expected error of a point.",
        "Stripe centre noise from photons, reading out, rounding and speckle, times depth per pixel."},
       {pictures.spacing, ImageKind::kDrawing, "Spacing of one laser's stripes.",
        "Gaps are where no light is."},
       {pictures.gap, ImageKind::kDrawing, "How the lasers' combs lie between each other.",
        "Spacing of one laser's stripes, the largest gap that all lasers leave, and the distance of the two "
        "stripes that "
        "lie closest: where it touches zero, two lasers measure the same lines."}});
  page.Section("Orders");
  page.Table(OrderTable(r));
  return page.Finish("dorsum design");
}

}  // namespace dorsum
