// SPDX-License-Identifier: Apache-2.0
#include "captures/calibration_series.h"

#include <algorithm>
#include <set>
#include <utility>

#include "captures/green_channel.h"
#include "captures/image_file.h"
#include "captures/names.h"

namespace dorsum {
namespace {

std::vector<std::string> NamesOfLaser(int k) {
  return {LaserCalName(k, Distance::kFurther), LaserCalName(k, Distance::kCloser),
          LaserChessName(k, Distance::kFurther), LaserChessName(k, Distance::kCloser), StripesBgName(k)};
}

}  // namespace

Result<cv::Mat> CalibrationSeries::Read(const std::string& name, Channels channels) const {
  const auto in_channels = [channels](const cv::Mat& picture) {
    return channels == Channels::kGreen ? GreenChannel(picture) : picture;
  };
  const bool keep = kept != nullptr && kept->Wants(name);
  if (keep) {
    if (const auto picture = kept->Find(name)) return in_channels(*picture);
  }
  DORSUM_ASSIGN_OR_RETURN(const auto path, RequireImage(dir, name));
  const cv::Size size(setup.width, setup.height);
  if (!keep) return ReadImage(path, size, channels);
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat picture, ReadImage(path, size));
  kept->Put(name, picture);
  return in_channels(picture);
}

CalibrationSeries CalibrationSeries::KeepingPictures() const {
  std::set<std::string> names = {kBgNoHandName, kFirstEstimatesName, LaserBgName(Distance::kFurther),
                                 LaserBgName(Distance::kCloser)};
  for (const int k : lasers) {
    names.insert({LaserCalName(k, Distance::kFurther), LaserCalName(k, Distance::kCloser), StripesBgName(k)});
  }
  CalibrationSeries out = *this;
  out.kept = std::make_shared<KeptPictures>(std::move(names));
  return out;
}

std::filesystem::path CalibrationSeries::BoxDir(double height_mm) const {
  return dir / kHeightsFolder / HeightFolderName(height_mm);
}

std::vector<std::filesystem::path> CalibrationSeries::Files() const {
  std::vector<std::filesystem::path> files;
  std::error_code ec;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(dir, ec)) {
    if (entry.is_regular_file()) files.push_back(std::filesystem::relative(entry.path(), dir));
  }
  std::sort(files.begin(), files.end());
  return files;
}

Result<CalibrationSeries> LoadCalibrationSeries(const std::filesystem::path& dir) {
  std::error_code ec;
  if (!std::filesystem::is_directory(dir, ec))
    return BadInput("there is no calibration folder " + dir.string());
  CalibrationSeries series;
  series.dir = dir;
  DORSUM_ASSIGN_OR_RETURN(series.setup, ReadSetup(dir));
  for (int view = 0; view < 100; ++view) {
    const std::string name = ChessName(view);
    if (FindImage(dir, name)) {
      series.chess_views.push_back(name);
    } else if (view == 0) {
      return RequireImage(dir, name).error();  // the first view fixes the world: nothing can stand in for it
    } else if (view < kChessViews) {
      series.warnings.push_back("the chessboard view " + name + " is missing in " + dir.string());
    }
  }
  for (const char* name : {kBgNoHandName, kFirstEstimatesName}) {
    DORSUM_RETURN_IF_ERROR(RequireImage(dir, name));
  }
  for (const Distance d : {Distance::kFurther, Distance::kCloser}) {
    DORSUM_RETURN_IF_ERROR(RequireImage(dir, LaserBgName(d)));
  }
  for (int k = 0; k < kMaxLasers; ++k) {
    const std::vector<std::string> names = NamesOfLaser(k);
    std::vector<std::string> missing;
    for (const std::string& name : names) {
      if (!FindImage(dir, name)) missing.push_back(name);
    }
    if (missing.empty()) {
      series.lasers.push_back(k);
    } else if (missing.size() <
               names.size()) {  // begun but not whole: surely a mistake, so it is not skipped
      return RequireImage(dir, missing.front()).error();
    }
  }
  if (series.lasers.empty()) return RequireImage(dir, LaserCalName(0, Distance::kFurther)).error();
  for (const double height : series.setup.box_heights_mm) {
    if (std::filesystem::is_directory(series.BoxDir(height), ec)) {
      DORSUM_RETURN_IF_ERROR(RequireImage(series.BoxDir(height), kBgHandName));
      series.box_heights_mm.push_back(height);
    } else {
      series.warnings.push_back("setup.json names a box of " + std::to_string(height).substr(0, 5) +
                                " mm, but there is no folder " + series.BoxDir(height).string());
    }
  }
  return series;
}

}  // namespace dorsum
