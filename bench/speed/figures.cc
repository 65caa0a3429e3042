// SPDX-License-Identifier: Apache-2.0
#include "speed/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "accuracy/markdown.h"
#include "base/version.h"

namespace dorsum::speed {
namespace {

using accuracy::Fixed;
using accuracy::MarkdownTable;

constexpr const char* kSchema = "dorsum/speed";

double Get(const Measured& m, const std::string& name) {
  const auto it = m.find(name);
  return it == m.end() ? NAN : it->second;
}

double Ratio(const Measured& m, const std::string& a, const std::string& b) { return Get(m, a) / Get(m, b); }

SpeedFigure AtMost(const std::string& what, double limit, double reached) {
  char text[32];
  std::snprintf(text, sizeof text, "≤ %g", limit);
  return {what, text, reached, reached <= limit};
}

SpeedFigure AtLeast(const std::string& what, double limit, double reached) {
  char text[32];
  std::snprintf(text, sizeof text, "≥ %g", limit);
  return {what, text, reached, reached >= limit};
}

std::string Cell(double value) { return Fixed(value, std::abs(value) < 10.0 ? 2 : 0); }

}  // namespace

std::vector<SpeedFigure> FiguresOf(const Measured& m) {
  const double two = Get(m, "size/megapixels:2.0") / 2.0, eight = Get(m, "size/megapixels:8.0") / 8.0;
  return {
      AtMost("decoded images to the fused mesh, 2 threads, over the one-thread floor", 8.0,
             Ratio(m, "default/threads:2", "floor")),
      AtLeast("classic chain over the default one, 1 thread", 10.0,
              Ratio(m, "classic/threads:1", "default/threads:1")),
      AtLeast("classic chain over the default one, 2 threads", 10.0,
              Ratio(m, "classic/threads:2", "default/threads:2")),
      AtLeast("OpenCV Steger over our detector, 1 thread", 10.0,
              Ratio(m, "steger/threads:1", "detector/threads:1")),
      AtLeast("OpenCV Steger over our detector, 2 threads", 10.0,
              Ratio(m, "steger/threads:2", "detector/threads:2")),
      AtMost("our points' rms error over Steger's, the hand's stripes", 1.0,
             Ratio(m, "points/object/ours/rms_px", "points/object/theirs/rms_px")),
      AtMost("our points' rms error over Steger's, the backplane's stripes", 1.0,
             Ratio(m, "points/backplane/ours/rms_px", "points/backplane/theirs/rms_px")),
      AtLeast("points of the hand's stripes that ours finds over those that Steger finds", 1.0,
              Ratio(m, "points/object/ours/found", "points/object/theirs/found")),
      AtLeast("1 thread over 2, default chain", 1.6, Ratio(m, "default/threads:1", "default/threads:2")),
      AtMost("time per megapixel at 8 MP over that at 2 MP", 1.15, eight / two),
      AtMost("process of `reconstruct --no-report` over one that reads the images", 2.0,
             Ratio(m, "process/reconstruct", "process/imread")),
      AtMost("bundle calibration over finding its corners", 3.0,
             Ratio(m, "calibrate/bundle", "calibrate/corners")),
      AtLeast("one process for each capture over one batch of them", 1.5,
              Ratio(m, "batch/one_by_one", "batch/together")),
      AtMost("peak memory of one reconstruction process, MB", 250.0, Get(m, "process/peak_mb")),
      AtMost("heap allocations of images' size in a later scan", 0.0, Get(m, "allocations")),
  };
}

std::string FigureTable(const Measured& measured) {
  MarkdownTable table({"figure", "asked", "reached", ""});
  for (const SpeedFigure& f : FiguresOf(measured)) {
    table.Row({f.what, f.asked, Cell(f.reached),
               std::isnan(f.reached) ? "not measured"
               : f.met               ? "met"
                                     : "**missed**"});
  }
  return table.text();
}

std::string DetectorTable(const Measured& measured) {
  MarkdownTable table({"", "times the floor, 1 thread", "2 threads", "found on the hand", "rms / median, px",
                       "found on the backplane", "rms / median, px"});
  const auto row = [&](const std::string& what, const std::string& name, const std::string& whose) {
    std::vector<std::string> cells = {what};
    for (const char* threads : {"/threads:1", "/threads:2"})
      cells.push_back(Cell(Ratio(measured, name + threads, "floor")));
    if (whose.empty()) cells.resize(7, "–");
    if (whose.empty()) return table.Row(cells);
    for (const std::string place : {"points/object/", "points/backplane/"}) {
      const std::string points = place + whose;
      cells.push_back(Fixed(100.0 * Get(measured, points + "/found"), 1) + " %");
      cells.push_back(Fixed(Get(measured, points + "/rms_px"), 3) + " / " +
                      Fixed(Get(measured, points + "/median_px"), 3));
    }
    table.Row(cells);
  };
  row("OpenCV Steger", "steger", "theirs");
  row("our detector", "detector", "ours");
  row("all that we do to find stripes", "ridges", "");
  return table.text();
}

std::string StageTable(const Measured& measured) {
  MarkdownTable table({"chain", "threads", "stage", "times the floor", "share"});
  for (const std::string chain : {"classic", "default"}) {
    for (const std::string threads : {"1", "2"}) {
      const std::string whole = chain + "/threads:" + threads;
      for (const std::string stage : {"mask", "stripes", "indexing", "surface", "fusion"}) {
        const double ms = Get(measured, whole + "/" + stage);
        table.Row({chain, threads, stage, Cell(ms / Get(measured, "floor")),
                   Fixed(100.0 * ms / Get(measured, whole), 0) + " %"});
      }
      table.Row({chain, threads, "**all**", Cell(Ratio(measured, whole, "floor")), ""});
    }
  }
  return table.text();
}

std::string SizeTable(const Measured& measured) {
  const auto is_size = [](const auto& named) { return named.first.starts_with("size/"); };
  if (std::none_of(measured.begin(), measured.end(), is_size)) return "Not measured yet.\n";
  MarkdownTable table({"pictures", "default chain, 2 threads, times the floor of 1600×1200 and four lasers"});
  for (const auto& [name, ms] : measured) {
    for (const std::string kind : {"size/megapixels:", "size/lasers:"}) {
      if (!name.starts_with(kind)) continue;
      const std::string number = name.substr(kind.size());
      if (number.find('/') != std::string::npos) continue;  // a stage of it
      const std::string lasers = number + (number == "1" ? " laser" : " lasers");
      table.Row({kind.ends_with("lasers:") ? lasers + ", 1.9 megapixels" : number + " megapixels, 4 lasers",
                 Cell(ms / Get(measured, "floor"))});
    }
  }
  return table.text();
}

Json MeasuredToJson(const Measured& measured) {
  Json numbers = Json::object();
  for (const auto& [name, value] : measured) numbers[name] = value;
  return {{"schema", kSchema}, {"version", 1}, {"program", kVersion}, {"measured", numbers}};
}

Result<Measured> MeasuredFromJson(const Json& json, const std::string& where) {
  if (!json.is_object() || json.value("schema", "") != kSchema || !json.contains("measured") ||
      !json["measured"].is_object()) {
    return BadInput(where + " is no record of speed");
  }
  Measured out;
  for (const auto& [name, value] : json["measured"].items()) {
    if (!value.is_number()) return BadInput(where + ": " + name + " is no number");
    out[name] = value.get<double>();
  }
  return out;
}

}  // namespace dorsum::speed
