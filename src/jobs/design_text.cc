// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "jobs/design.h"

namespace dorsum {
namespace {

template <class... Values>
std::string Format(const char* format, Values... values) {
  char text[512];
  const int length = std::snprintf(text, sizeof text, format, values...);
  return {text, static_cast<std::size_t>(std::clamp<int>(length, 0, sizeof text - 1))};
}

std::string DeviceLines(const DesignReport& r) {
  const DeviceDescription& d = r.device.description;
  const GratingDesign& g = d.grating;
  const auto& [low, high] = d.working_heights_mm;
  std::string out = d.name + "\n";
  out += Format("  grating    %g lines/mm, %g nm, turned %g deg: step %.5f, %d orders on each side\n",
                g.lines_per_mm, g.wavelength_nm, g.turn_deg, g.Step(), g.orders);
  out += Format(
      "  slit       %.2f um leave the outermost order as bright as described; %.2f um send most light "
      "there\n",
      r.slit_um, r.slit_brightest_um);
  out += Format("  camera     %d x %d px, focal length %g px, at (%g, %g, %g) mm\n", d.camera.width,
                d.camera.height, d.camera.focal_length_px, d.camera.position_mm.x(), d.camera.position_mm.y(),
                d.camera.position_mm.z());
  out += Format("  view       %.0f x %.0f mm at height %g (%.2f px/mm), %.0f x %.0f mm at %g (%.2f px/mm)\n",
                r.seen_low_mm.x(), r.seen_low_mm.y(), low, r.px_per_mm_low, r.seen_high_mm.x(),
                r.seen_high_mm.y(), high, r.px_per_mm_high);
  out += Format("  hand area  x %.0f to %.0f, y %.0f to %.0f mm; judged on %s of albedo %g\n",
                r.device.hand.min().x(), r.device.hand.max().x(), r.device.hand.min().y(),
                r.device.hand.max().y(), r.surface.skin ? "skin" : "a matt surface", r.surface.albedo);
  return out;
}

std::string OrderLines(const DesignReport& r) {
  const double high = r.device.description.working_heights_mm[1];
  std::string out = Format(
      "\norders of laser 0 (2.2, 2.6): brightness over the central one's, middle of the stripe\n"
      "  %6s %10s %10s %10s %12s %12s\n",
      "order", "described", "by slit", "angle deg", "x mm, z = 0", Format("z = %g", high).c_str());
  for (const OrderFigures& o : r.orders) {
    out += Format("  %6d %10.3f %10.3f %10.2f %12.2f %12.2f%s\n", o.order, o.described, o.slit, o.angle_deg,
                  o.low_mm, o.high_mm, o.in_view ? "" : "  outside the hand area");
  }
  return out;
}

std::string LaserLines(const DesignReport& r) {
  const auto& [low, high] = r.device.description.working_heights_mm;
  std::string out = "\n" + Format("%-40s", "lasers");
  for (std::size_t k = 0; k < r.lasers.size(); ++k) out += Format(" %9d", static_cast<int>(k));
  const auto row = [&](const char* name, int decimals, const auto& value) {
    out += Format("\n  %-38s", name);
    for (const LaserFigures& l : r.lasers) out += Format(" %9.*f", decimals, static_cast<double>(value(l)));
  };
  row("x, mm", 2, [](const LaserFigures& l) { return l.x_mm; });
  row("baseline, mm", 1, [](const LaserFigures& l) { return l.baseline_mm; });
  row("triangulation angle, deg", 1, [](const LaserFigures& l) { return l.triangulation_deg; });
  row("stripes over the hand area", 0, [](const LaserFigures& l) { return l.stripes_in_view; });
  row("spacing on the backplane, mm", 2, [](const LaserFigures& l) { return l.volume.spacing_low_mm; });
  row("spacing on the backplane, px", 1, [](const LaserFigures& l) { return l.volume.spacing_low_px; });
  row("spacing at the volume's top, mm", 2, [](const LaserFigures& l) { return l.volume.spacing_high_mm; });
  row("spacing at the volume's top, px", 1, [](const LaserFigures& l) { return l.volume.spacing_high_px; });
  row("depth per pixel, least, mm/px", 3,
      [](const LaserFigures& l) { return l.volume.least_depth_mm_per_px; });
  row("depth per pixel, middle, mm/px", 3,
      [](const LaserFigures& l) { return l.volume.middle_depth_mm_per_px; });
  row("depth per pixel, most, mm/px", 3, [](const LaserFigures& l) { return l.volume.most_depth_mm_per_px; });
  row("unambiguous height alone, mm", 1, [](const LaserFigures& l) { return l.unambiguous_mm; });
  row("lit and seen of the volume, %", 1, [](const LaserFigures& l) { return 100.0 * l.volume.used; });
  row("dimmest stripe, % of full scale", 1,
      [](const LaserFigures& l) { return 100.0 * l.volume.dimmest_peak; });
  row("brightest stripe, % of full scale", 1,
      [](const LaserFigures& l) { return 100.0 * l.volume.brightest_peak; });
  row("centre noise of one row, px", 3, [](const LaserFigures& l) { return l.volume.row_sigma_px; });
  row("expected error of one row, mm", 4, [](const LaserFigures& l) { return l.volume.row_sigma_mm; });
  const std::string pooled = Format("expected error of %d rows, mm", r.surface.pooled_rows);
  row(pooled.c_str(), 4, [](const LaserFigures& l) { return l.volume.pooled_sigma_mm; });
  out += "\n";
  for (std::size_t k = 0; k < r.lasers.size(); ++k) {
    if (r.lasers[k].beyond_volume)
      out += Format("  (laser %d: no pixel sees two of its orders within %g to %g mm)\n", static_cast<int>(k),
                    low, high);
  }
  return out;
}

std::string TogetherLines(const DesignReport& r) {
  std::string out = "\nall lasers together\n";
  const HeightAmbiguity& a = r.ambiguity;
  if (a.joint_mm) {
    out += Format("  unambiguous height %.1f mm: from there on all agree on a false one\n", *a.joint_mm);
  } else if (a.joint_margin_mm) {
    out += Format(
        "  unambiguous over the whole working volume: at the most tempting false height the lasers "
        "disagree by %.1f mm\n",
        *a.joint_margin_mm);
  } else {
    out += "  unambiguous over the whole working volume: no pixel sees two orders of laser 0\n";
  }
  out += Format("  %.0f points per cm2, expected error %.4f mm (one row %.4f mm), merit %.0f\n",
                r.points_per_cm2, r.pooled_sigma_mm, r.row_sigma_mm, r.merit);
  out += Format("  %8s %10s %10s %10s %12s %16s\n", "height", "one laser", "all lasers", "spacing",
                "largest gap", "closest stripes");
  for (std::size_t i = 0; i < r.combs.size(); i += std::max<std::size_t>(1, (r.combs.size() - 1) / 4)) {
    const CombFigures& c = r.combs[i];
    out += Format("  %5.0f mm %8.1f %% %8.1f %% %7.2f mm %9.2f mm", c.height_mm, 100.0 * c.any_coverage,
                  100.0 * c.all_coverage, c.spacing_mm, c.largest_gap_mm);
    if (r.lasers.size() > 1) out += Format("   %.2f (%d and %d)", c.closest, c.closest_a, c.closest_b);
    out += "\n";
  }
  return out;
}

std::string SearchLines(const SearchResult& search) {
  std::string out = Format(
      "best designs: points per cm2 over the expected error in mm\n  %9s %7s %9s %8s %8s %9s %9s "
      "%10s %9s %7s\n",
      "lines/mm", "orders", "baseline", "pitch", "slit um", "spacing", "unambig.", "points/cm2", "error mm",
      "merit");
  for (const SearchHit& h : search.hits) {
    out += Format("  %9g %7d %9.0f %8.2f %8.2f %9.2f %9.1f %10.0f %9.4f %7.0f\n",
                  h.description.grating.lines_per_mm, h.description.grating.orders, h.baseline_mm, h.pitch_mm,
                  h.slit_um, h.spacing_mm, h.unambiguous_mm, h.points_per_cm2, h.pooled_sigma_mm, h.merit);
  }
  for (const std::string& why : search.refused) out += "  " + why + "\n";
  return out + "\nthe first of them: ";
}

}  // namespace

std::string DesignToText(const DesignReport& r) {
  std::string out = DeviceLines(r) + OrderLines(r) + LaserLines(r) + TogetherLines(r);
  for (const std::string& text : r.warnings) out += "\nnote: " + text;
  for (const std::string& text : r.explanations) out += "\nwhy so few stripes: " + text;
  if (!r.warnings.empty() || !r.explanations.empty()) out += "\n";
  return out;
}

std::string SummaryToText(const DesignSummary& summary) {
  std::string out = summary.search ? SearchLines(*summary.search) : "";
  out += DesignToText(summary.report);
  if (!summary.files.empty()) out += "\nwritten:";
  for (const std::string& file : summary.files) out += " " + file;
  return summary.files.empty() ? out : out + "\n";
}

}  // namespace dorsum
