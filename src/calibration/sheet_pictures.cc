// SPDX-License-Identifier: Apache-2.0
#include "calibration/sheet_pictures.h"

#include "base/parallel.h"
#include "captures/green_channel.h"
#include "captures/image_file.h"
#include "captures/names.h"

namespace dorsum {
namespace {

std::string Millimetres(double value) {
  std::string text = HeightFolderName(value).substr(1);
  return text + " mm";
}

}  // namespace

std::vector<HeightPlane> PlanesOfSeries(const CalibrationSeries& series) {
  // How well people measure what they put under a laser; a plane is then free to be that much wrong.
  constexpr double kObjectSd = 0.01, kBoxSd = 0.02;
  std::vector<HeightPlane> planes = {{"the backplane", 0.0, 0.0}};
  const double h = series.setup.calibration_object_height_mm;
  planes.push_back({"the calibration object", h, kObjectSd});
  for (const double box : series.box_heights_mm)
    planes.push_back({"the box of " + Millimetres(box), box, kBoxSd});
  return planes;
}

Result<std::vector<SheetPicture>> FindSheetPictures(const CalibrationSeries& series,
                                                    const SheetPictureOptions& options,
                                                    const Context& context) {
  std::vector<SheetPicture> pictures;
  for (std::size_t i = 0; i < series.lasers.size(); ++i) {
    const int k = series.lasers[i], index = static_cast<int>(i);
    pictures.push_back({StripesBgName(k), "backplane", index, {0}, {}});
    pictures.push_back({LaserCalName(k, Distance::kFurther), "Further", index, {0}, {}});
    pictures.push_back({LaserCalName(k, Distance::kCloser), "Closer", index, {1, 0}, {}});
    for (std::size_t b = 0; b < series.box_heights_mm.size(); ++b) {
      const double height = series.box_heights_mm[b];
      const std::string folder = std::string(kHeightsFolder) + "/" + HeightFolderName(height) + "/";
      // A laser that is missing in a box's folder is a smaller calibration, not a failure.
      if (!FindImage(series.BoxDir(height), StripesHandName(k))) continue;
      pictures.push_back({folder + StripesHandName(k),
                          "box " + Millimetres(height),
                          index,
                          {kFirstBoxPlane + static_cast<int>(b), 0},
                          {}});
    }
  }
  std::vector<Status> status(pictures.size());
  ParallelFor(context, 0, static_cast<std::int64_t>(pictures.size()), [&](std::int64_t i) {
    SheetPicture& picture = pictures[static_cast<std::size_t>(i)];
    if (context.IsCancelled()) return;
    const Result<cv::Mat> image = series.Read(picture.name, Channels::kGreen);
    if (!image.ok()) {
      status[static_cast<std::size_t>(i)] = image.error();
      return;
    }
    if (picture.planes.front() >= kFirstBoxPlane) {
      Status& exposed = status[static_cast<std::size_t>(i)];
      exposed = CheckExposure(*image, (series.dir / picture.name).string());
      if (!exposed.ok()) return;
    }
    Context quiet = context;
    quiet.progress = nullptr;
    quiet.sink = nullptr;
    quiet.threads = 1;
    const int laser = series.lasers[static_cast<std::size_t>(picture.laser)];
    RidgeOptions ridge = options.ridge;
    ridge.scale_deviations = false;
    picture.stripes = PoolAlongStripes(FindRidges(*image, {}, laser, ridge, quiet), options.pooling, quiet);
  });
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  for (const Status& s : status) DORSUM_RETURN_IF_ERROR(s);
  for (const SheetPicture& picture : pictures) {
    const bool box = picture.planes.front() >= kFirstBoxPlane;
    if (box || !picture.stripes.segments.empty()) continue;
    return BadInput("no stripes are seen in " + picture.name + "; is laser " +
                    std::to_string(series.lasers[static_cast<std::size_t>(picture.laser)]) +
                    " on and the exposure right? Capture it again");
  }
  return pictures;
}

}  // namespace dorsum
