// SPDX-License-Identifier: Apache-2.0
#include "simulator/calibration_writer.h"

#include <string>
#include <vector>

#include "base/json.h"
#include "captures/names.h"
#include "captures/series_plan.h"
#include "simulator/capture_writer.h"
#include "simulator/renderer.h"
#include "simulator/series_scenes.h"
#include "simulator/truth_files.h"

namespace dorsum {
namespace {

Result<cv::Mat> RenderSeriesPicture(const VirtualDevice& device, const Stage& stage,
                                    const SeriesPicture& picture, const Context& context) {
  const std::uint64_t seed = SeriesPictureSeed(device, picture.name);
  switch (picture.light) {
    case SeriesPicture::Light::kDark:
      return RenderDark(device, stage, seed, context);
    case SeriesPicture::Light::kLeds:
      return RenderLeds(device, stage, seed, context);
    case SeriesPicture::Light::kLaser:
      break;
  }
  return RenderLaser(device, stage, picture.laser, seed, context);
}

}  // namespace

Status WriteCalibrationSeries(const VirtualDevice& device, const std::filesystem::path& dir,
                              const Context& context) {
  const std::vector<SeriesStep> plan = PlanCalibrationSeries(device.description);
  double total = 0.0, done = 0.0;
  for (const SeriesStep& step : plan) total += static_cast<double>(step.pictures.size());
  DORSUM_RETURN_IF_ERROR(MakeFolder(dir));
  DORSUM_RETURN_IF_ERROR(WriteJson(dir / kSetupName, SetupToJson(SetupOf(device.description))));
  for (const SeriesStep& step : plan) {
    DORSUM_ASSIGN_OR_RETURN(Scene scene, BuildSeriesScene(device, step));
    DORSUM_ASSIGN_OR_RETURN(const Stage stage, SetStage(device, std::move(scene), context));
    for (const SeriesPicture& picture : step.pictures) {
      DORSUM_ASSIGN_OR_RETURN(const cv::Mat image, RenderSeriesPicture(device, stage, picture, context));
      const std::filesystem::path stem = dir / picture.name;
      DORSUM_RETURN_IF_ERROR(MakeFolder(stem.parent_path()));
      DORSUM_RETURN_IF_ERROR(WritePicture(device.description.camera, image, stem));
      context.Report("calibration series", ++done / total);
    }
  }
  return {};
}

}  // namespace dorsum
