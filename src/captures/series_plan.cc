// SPDX-License-Identifier: Apache-2.0
#include "captures/series_plan.h"

#include <cstdio>

#include "captures/names.h"

namespace dorsum {
namespace {

using Light = SeriesPicture::Light;
using Thing = SeriesStep::Thing;

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

SeriesStep PlanChessboard(int view) {
  return {.thing = Thing::kBoard, .number = view, .pictures = {{ChessName(view), Light::kLeds, -1}}};
}

// The empty plane at one of the two distances, in the dark and under each laser.
SeriesStep PlanPlane(Distance distance, int lasers, double object_height_mm) {
  SeriesStep step;
  const bool further = distance == Distance::kFurther;
  step.thing = further ? Thing::kBackplane : Thing::kObject;
  step.height_mm = further ? 0.0 : object_height_mm;
  step.pictures.push_back({LaserBgName(distance), Light::kDark, -1});
  if (further) step.pictures.push_back({kBgNoHandName, Light::kLeds, -1});
  for (int k = 0; k < lasers; ++k) {
    step.pictures.push_back({LaserCalName(k, distance), Light::kLaser, k});
    if (further) step.pictures.push_back({StripesBgName(k), Light::kLaser, k});
  }
  return step;
}

SeriesStep PlanBoardOnStripe(Distance distance, int laser, double object_height_mm) {
  const bool further = distance == Distance::kFurther;
  return {.thing = further ? Thing::kBoardOnBackplane : Thing::kBoardOnObject,
          .number = laser,
          .height_mm = further ? 0.0 : object_height_mm,
          .pictures = {{LaserChessName(laser, distance), Light::kLeds, -1}}};
}

SeriesStep PlanBox(double height_mm, int lasers) {
  const std::string folder = std::string(kHeightsFolder) + "/" + HeightFolderName(height_mm) + "/";
  SeriesStep step;
  step.thing = Thing::kBox;
  step.height_mm = height_mm;
  step.pictures.push_back({folder + kBgHandName, Light::kLeds, -1});
  for (int k = 0; k < lasers; ++k) {
    step.pictures.push_back({folder + StripesHandName(k), Light::kLaser, k});
  }
  return step;
}

}  // namespace

std::vector<SeriesStep> PlanCalibrationSeries(const DeviceDescription& device) {
  const int lasers = static_cast<int>(device.lasers.size());
  std::vector<SeriesStep> plan;
  plan.reserve(kChessViews);
  for (int view = 0; view < kChessViews; ++view) plan.push_back(PlanChessboard(view));
  for (const Distance distance : {Distance::kFurther, Distance::kCloser}) {
    plan.push_back(PlanPlane(distance, lasers, device.calibration_object_height_mm));
    for (int k = 0; k < lasers; ++k) {
      plan.push_back(PlanBoardOnStripe(distance, k, device.calibration_object_height_mm));
    }
    if (distance == Distance::kFurther) {
      plan.push_back({.thing = Thing::kLines, .pictures = {{kFirstEstimatesName, Light::kLeds, -1}}});
    }
  }
  for (const double height : device.box_heights_mm) plan.push_back(PlanBox(height, lasers));
  return plan;
}

std::string InstructionOf(const SeriesStep& step, const DeviceDescription& device) {
  const std::string laser = std::to_string(step.number), height = Number(step.height_mm) + " mm";
  switch (step.thing) {
    case Thing::kBoard:
      if (step.number == 0) {
        return "Lay the chessboard flat on the backplane, its middle on the central stripe of laser " +
               std::string(device.lasers.size() > 1 ? "1" : "0") + " and its rows across the stripes.";
      }
      return "Hold the chessboard raised and tilted by 10 to 25 degrees, another way than before, all of it "
             "in the picture.";
    case Thing::kBackplane:
      return "Clear the backplane.";
    case Thing::kBoardOnBackplane:
      return "Lay the chessboard flat on the backplane, its middle on the central stripe of laser " + laser +
             ", which is on now.";
    case Thing::kLines:
      return "Lay the sheet with one line for each laser on the backplane, the lines on the central stripes.";
    case Thing::kObject:
      return "Put the calibration object of " + height + " on the backplane; it must fill the picture.";
    case Thing::kBoardOnObject:
      return "Lay the chessboard flat on the calibration object, its middle on the central stripe of laser " +
             laser + ", which is on now.";
    case Thing::kBox:
      return "Put the box of " + height + " on the empty backplane, in the middle of the picture.";
  }
  return {};
}

Setup SetupOf(const DeviceDescription& device) {
  Setup setup;
  setup.board_columns = device.board.columns;
  setup.board_rows = device.board.rows;
  setup.square_mm = device.board.square_mm;
  setup.calibration_object_height_mm = device.calibration_object_height_mm;
  setup.box_heights_mm = device.box_heights_mm;
  setup.grating_lines_per_mm = device.grating.lines_per_mm;
  setup.wavelength_nm = device.grating.wavelength_nm;
  setup.width = device.camera.width;
  setup.height = device.camera.height;
  return setup;
}

}  // namespace dorsum
