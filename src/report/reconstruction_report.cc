// SPDX-License-Identifier: Apache-2.0
#include "report/reconstruction_report.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/median.h"
#include "captures/png_image.h"
#include "report/drawing.h"
#include "report/height_picture.h"
#include "report/html.h"
#include "report/mesh_picture.h"
#include "report/overview.h"
#include "report/photo_pictures.h"

namespace dorsum {
namespace {

struct Pictures {
  cv::Mat photo, mask, heights, front, back;
  std::vector<cv::Mat> stripes;  // as data.stripes.lasers
};

cv::Mat StripePhoto(const ReconstructionReportData& data, int laser) {
  const auto k = static_cast<std::size_t>(laser);
  const bool has_own = laser >= 0 && k < data.stripe_photos.size() && !data.stripe_photos[k].empty();
  return has_own ? data.stripe_photos[k] : data.photo;
}

Pictures DrawAll(const ReconstructionReportData& data, const Context& context) {
  Pictures pictures;
  if (!data.photo.empty()) pictures.photo = DrawMask(data.photo, {});
  if (!data.mask.empty()) pictures.mask = DrawMask(data.photo, data.mask);
  for (const LaserStripes& stripes : data.stripes.lasers) {
    pictures.stripes.push_back(DrawIndexedStripes(StripePhoto(data, stripes.laser), stripes));
  }
  pictures.heights = DrawHeightMap(data.height_field);
  if (!data.mesh.faces.empty()) {
    const MeshPainter painter(data.mesh, {}, context);
    pictures.front = painter.Paint(kFrontView);
    pictures.back = painter.Paint(kBackView);
  }
  return pictures;
}

HtmlTable LaserTable(const ReconstructionReportData& data) {
  HtmlTable table;
  table.header = {"Laser",
                  "Stripe pieces",
                  "without an order",
                  "re-counted",
                  "Orders",
                  "Points",
                  "Typical uncertainty of z (mm)"};
  table.caption =
      "Pieces without an order give no surface. Re-counted ones got another order by comparison with "
      "their neighbours.";
  for (const LaserStripes& stripes : data.stripes.lasers) {
    std::set<int> orders;
    std::size_t without = 0, points = 0;
    for (const StripeSegment& segment : stripes.segments) {
      if (segment.order) orders.insert(*segment.order);
      without += segment.order ? 0 : 1;
    }
    std::vector<float> sigmas;
    for (const SurfacePoint& point : data.points) {
      if (point.laser != stripes.laser) continue;
      ++points;
      if (std::isfinite(point.sigma)) sigmas.push_back(point.sigma);
    }
    std::string corrections = "-";
    for (const IndexingDiagnostics& d : data.stripes.diagnostics) {
      if (d.laser == stripes.laser) corrections = std::to_string(d.corrections);
    }
    const std::string range =
        orders.empty() ? "-" : std::to_string(*orders.begin()) + " to " + std::to_string(*orders.rbegin());
    table.rows.push_back({std::to_string(stripes.laser), std::to_string(stripes.segments.size()),
                          std::to_string(without), corrections, range, std::to_string(points),
                          FormatNumber(sigmas.empty() ? std::nanf("") : Median(sigmas), 3)});
  }
  return table;
}

// The laser whose picture stands for all in the overview: the one that gave most stripe points.
std::size_t BusiestLaser(const IndexedStripes& stripes) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < stripes.lasers.size(); ++i) {
    if (stripes.lasers[i].points.size() > stripes.lasers[best].points.size()) best = i;
  }
  return best;
}

std::string FactLine(const std::vector<ReportRow>& facts) {
  std::string line;
  for (const ReportRow& fact : facts) {
    if (!line.empty()) line += "   |   ";
    line += fact.name + ": " + fact.value + (fact.unit.empty() ? "" : " " + fact.unit);
  }
  return line;
}

cv::Mat DrawOverview(const ReconstructionReportData& data, const Pictures& pictures) {
  std::vector<OverviewTile> tiles = {{pictures.photo, "1  Photo, brightened"},
                                     {pictures.mask, "2  What was taken as the object"}};
  if (data.stripes.lasers.empty()) {
    tiles.push_back({{}, "3  No stripes"});
  } else {
    const LaserStripes& stripes = data.stripes.lasers[BusiestLaser(data.stripes)];
    // Drawn anew with larger numbers, which stay readable in the small tile.
    tiles.push_back(
        {DrawIndexedStripes(StripePhoto(data, stripes.laser), stripes, {.width_px = 1000, .text_px = 16.0}),
         "3  Stripes of laser " + std::to_string(stripes.laser) + ", coloured by order"});
  }
  tiles.push_back({DrawHeightMap(data.height_field, {.width_px = 760, .height_px = 570}),
                   "4  Heights above the backplane"});
  tiles.push_back({pictures.front, "5  Surface, from one side"});
  tiles.push_back({pictures.back, "6  Surface, from the other side"});
  return OverviewPicture(data.title, FactLine(data.facts), tiles);
}

void AddStripes(HtmlPage& page, const ReconstructionReportData& data, const Pictures& pictures) {
  if (pictures.stripes.empty()) return;
  page.Section(
      "Stripes and their orders",
      "A grating splits each laser into many stripes. Each one must get its right number, the order, since a "
      "stripe with a wrong number puts its part of the surface at a wrong height. Order 0, the brightest, is "
      "white; numbers grow to the right; colours repeat every six orders. Going along a stripe the number "
      "must not change, and from one stripe to the next it must grow by one. Grey pieces were left without "
      "an "
      "order and give no surface.");
  std::vector<HtmlFigure> figures;
  for (std::size_t i = 0; i < pictures.stripes.size(); ++i) {
    const LaserStripes& stripes = data.stripes.lasers[i];
    figures.push_back({pictures.stripes[i], ImageKind::kPhoto, "Laser " + std::to_string(stripes.laser) + ".",
                       std::to_string(stripes.segments.size()) + " pieces of stripes."});
  }
  page.Figures(figures);
  page.Table(LaserTable(data));
}

void AddSurface(HtmlPage& page, const ReconstructionReportData& data, const Pictures& pictures) {
  page.Section("Surface", "The points of all lasers, merged into one surface.");
  std::vector<HtmlFigure> figures;
  figures.push_back(
      {pictures.heights, ImageKind::kDrawing, "Heights above the backplane.",
       "Seen from the camera. Lines join places of the same height, every 5 mm. Look for steps that run "
       "along the stripes: there one stripe got a wrong order. White places were not seen by any laser.",
       true});
  const std::string sides =
      "Lit from above left; the grid on the backplane has squares of 10 mm. The surface ends "
      "where the lasers or the camera did not reach.";
  if (data.mesh.faces.empty()) {
    figures.push_back(
        {{}, ImageKind::kPhoto, "No surface.", "The points lie too far apart for a mesh.", true});
  } else {
    figures.push_back({pictures.front, ImageKind::kPhoto, "The surface from one side.", sides});
    figures.push_back({pictures.back, ImageKind::kPhoto, "The surface from the other side.",
                       "Ridges that no hand has are errors of height between neighbouring stripes."});
  }
  page.Figures(figures);
}

std::string MakeHtml(const ReconstructionReportData& data, const Pictures& pictures) {
  HtmlPage page(data.title.empty() ? "Reconstruction" : data.title, "A surface from laser stripes");
  page.Warnings(data.warnings);
  std::vector<HtmlFact> facts;
  facts.reserve(data.facts.size());
  for (const ReportRow& fact : data.facts) facts.push_back({fact.name, fact.value, fact.unit});
  page.Facts(facts);
  AddSurface(page, data, pictures);
  AddEvaluation(page, data.evaluation);
  if (!pictures.photo.empty() || !pictures.mask.empty()) {
    page.Section("Photo and mask", "Only what lies inside the mask is measured.");
    page.Figures(
        {{pictures.photo, ImageKind::kPhoto, "The photo, brightened.",
          pictures.photo.empty() ? "" : "It should be sharp, evenly lit, and show the whole hand or object."},
         {pictures.mask, ImageKind::kPhoto, "The mask.",
          pictures.mask.empty() ? ""
                                : "The outline should follow the edge of the object, without its shadow "
                                  "and without bites."}});
  }
  AddStripes(page, data, pictures);
  if (!data.calibration.empty()) {
    page.Section("The calibration behind it", "A surface is only as good as the calibration of the device.");
    page.Verdicts(data.calibration);
  }
  if (!data.settings.empty()) {
    page.Section("How it was made");
    page.Table(RowsTable(data.settings));
  }
  return page.Finish(data.version.empty() ? "Dorsum" : "Dorsum " + data.version);
}

}  // namespace

ReportPages MakeReconstructionReport(const ReconstructionReportData& data, const Context& context) {
  const Pictures pictures = DrawAll(data, context);
  ReportPages pages;
  pages.html = MakeHtml(data, pictures);
  pages.overview_png = EncodePng(DrawOverview(data, pictures), 6);
  return pages;
}

}  // namespace dorsum
