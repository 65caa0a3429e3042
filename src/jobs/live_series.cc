// SPDX-License-Identifier: Apache-2.0
#include "jobs/live_series.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/json.h"
#include "calibration/board_coverage.h"
#include "calibration/chessboard.h"
#include "captures/green_channel.h"
#include "captures/image_file.h"
#include "captures/names.h"
#include "captures/picture_file.h"
#include "captures/series_plan.h"
#include "captures/setup.h"
#include "device/take_picture.h"
#include "jobs/capture_checks.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using Light = SeriesPicture::Light;
using Thing = SeriesStep::Thing;

struct TakenPicture {
  std::string name;
  cv::Mat image;
};

bool HasBoard(const SeriesStep& step) {
  return step.thing == Thing::kBoard || step.thing == Thing::kBoardOnBackplane ||
         step.thing == Thing::kBoardOnObject;
}

class LiveSeries {
 public:
  LiveSeries(Device& device, Attendant& attendant, const LiveSeriesRequest& request, const Context& context)
      : device_(device),
        attendant_(attendant),
        request_(request),
        context_(context),
        coverage_(device.frames->size()) {
    still_.average = request.average;
  }

  Result<LiveSeriesSummary> Run() {
    DORSUM_RETURN_IF_ERROR(PrepareFolder());
    const std::vector<SeriesStep> plan = PlanCalibrationSeries(device_.description);
    summary_.steps = static_cast<int>(plan.size());
    summary_.warnings = device_.frames->warnings();
    for (std::size_t i = 0; i < plan.size(); ++i) {
      context_.Report("step " + std::to_string(i + 1) + " of " + std::to_string(plan.size()),
                      static_cast<double>(i) / static_cast<double>(plan.size()));
      if (Keep(plan[i])) {
        ++summary_.kept;
      } else {
        DORSUM_RETURN_IF_ERROR(DoStep(plan[i]));
      }
      attendant_.StepDone(plan[i]);
    }
    summary_.board_coverage = coverage_.Share();
    return summary_;
  }

 private:
  Status PrepareFolder() {
    std::error_code ec;
    fs::create_directories(request_.dir, ec);
    if (ec) return BadInput("cannot make the folder " + request_.dir.string() + ": " + ec.message());
    const fs::path path = request_.dir / kSetupName;
    const Json own = SetupToJson(SetupOf(device_.description));
    if (!fs::exists(path, ec)) return WriteJson(path, own);
    DORSUM_ASSIGN_OR_RETURN(const Json there, ReadJson(path));
    if (there == own) return {};
    return BadInput(path.string() + " is of another device or board than " + device_.name +
                    "; go on with that device, or name a new folder");
  }

  // Whether an earlier run has taken the step; learns what its boards covered.
  bool Keep(const SeriesStep& step) {
    std::optional<cv::Mat> first;
    for (const SeriesPicture& picture : step.pictures) {
      const auto path = FindImage(request_.dir, picture.name);
      if (!path) return false;
      Result<cv::Mat> image = ReadImage(*path, device_.frames->size());
      if (!image.ok()) return false;
      if (!first) first = *image;
    }
    if (!HasBoard(step)) return true;
    const auto corners = FindBoard(*first);
    if (!corners) return false;
    Remember(step, *corners);
    return true;
  }

  std::optional<std::vector<cv::Point2f>> FindBoard(const cv::Mat& image) const {
    const BoardDesign& board = device_.description.board;
    return FindChessboard(GreenChannel(image), {board.columns, board.rows});
  }

  void Remember(const SeriesStep& step, const std::vector<cv::Point2f>& corners) {
    if (step.thing != Thing::kBoard) return;
    coverage_.Add(corners);
    last_view_ = corners;
    attendant_.SawBoard(corners);
  }

  Status DoStep(const SeriesStep& step) {
    std::string words = InstructionOf(step, device_.description);
    for (int attempt = 1;; ++attempt) {
      DORSUM_RETURN_IF_ERROR(context_.CheckCancelled());
      const ChannelSet guide = GuideOf(step, device_.description);
      const auto keep_lit = [&] { return device_.lights->Set(guide); };
      DORSUM_RETURN_IF_ERROR(keep_lit());
      DORSUM_RETURN_IF_ERROR(attendant_.Arrange(step, words, keep_lit, context_));
      DORSUM_ASSIGN_OR_RETURN(const std::string wrong, TakeStep(step));
      if (wrong.empty()) return {};
      if (attempt >= request_.tries) return BadInput(wrong);
      words = "Again: " + wrong + ". " + InstructionOf(step, device_.description);
    }
  }

  // Takes and writes a step's pictures; a sentence where they show something else.
  Result<std::string> TakeStep(const SeriesStep& step) {
    std::vector<TakenPicture> pictures;
    cv::Mat dark;
    const auto needs_dark = [](const SeriesPicture& p) { return p.light == Light::kLaser; };
    if (std::any_of(step.pictures.begin(), step.pictures.end(), needs_dark)) {
      DORSUM_ASSIGN_OR_RETURN(dark, Take({"dark", Light::kDark}, {}));
      if (const CaptureFinding finding = CheckDark(dark, checks_); !finding.ok()) return finding.sentence;
    }
    for (const SeriesPicture& wanted : step.pictures) {
      DORSUM_ASSIGN_OR_RETURN(const cv::Mat image, Take(wanted, dark));
      const std::string wrong = Judge(step, wanted, image, dark);
      if (!wrong.empty()) return wrong;
      pictures.push_back({wanted.name, image});
    }
    DORSUM_RETURN_IF_ERROR(device_.lights->Set({}));
    for (const TakenPicture& picture : pictures) {
      const fs::path stem = request_.dir / picture.name;
      std::error_code ec;
      fs::create_directories(stem.parent_path(), ec);
      if (ec) return BadInput("cannot make the folder " + stem.parent_path().string() + ": " + ec.message());
      DORSUM_RETURN_IF_ERROR(WritePictureFile(device_.description.camera, picture.image, stem));
    }
    return std::string();
  }

  Result<cv::Mat> Take(const SeriesPicture& wanted, const cv::Mat& dark) {
    const DeviceDescription& description = device_.description;
    switch (wanted.light) {
      case Light::kDark:
        if (!dark.empty()) return dark;
        return TakePicture(device_, {}, FrameLight::kLaser, still_, context_);
      case Light::kLeds:
        return TakePicture(device_, LedChannels(description), FrameLight::kLeds, still_, context_);
      case Light::kLaser:
        break;
    }
    return TakePicture(device_, LaserChannel(description, wanted.laser), FrameLight::kLaser, still_,
                       context_);
  }

  std::string Judge(const SeriesStep& step, const SeriesPicture& wanted, const cv::Mat& image,
                    const cv::Mat& dark) {
    if (wanted.light == Light::kLaser) return CheckLaser(image, dark, wanted.laser, checks_).sentence;
    if (wanted.light == Light::kDark) return {};
    const cv::Mat black = dark.empty() ? cv::Mat::zeros(image.size(), image.type()) : dark;
    if (const CaptureFinding finding = CheckLeds(image, black, checks_); !finding.ok()) {
      return finding.sentence;
    }
    return HasBoard(step) ? JudgeBoard(step, image) : std::string();
  }

  std::string JudgeBoard(const SeriesStep& step, const cv::Mat& image) {
    const auto corners = FindBoard(image);
    const BoardDesign& board = device_.description.board;
    if (!corners) {
      return "the chessboard of " + std::to_string(board.columns) + " x " + std::to_string(board.rows) +
             " inner corners is not seen whole";
    }
    if (step.thing != Thing::kBoard) return {};
    if (SameView(last_view_, *corners, 0.01 * image.cols)) return "the chessboard lies as it did before";
    Remember(step, *corners);
    const std::string missing = coverage_.Missing();
    attendant_.Tell("Chessboard " + std::to_string(step.number + 1) + " of " + std::to_string(kChessViews) +
                    ": the boards cover " + std::to_string(std::lround(100.0 * coverage_.Share())) +
                    " % of the picture" + (missing.empty() ? "." : "; least at the " + missing + "."));
    return {};
  }

  Device& device_;
  Attendant& attendant_;
  const LiveSeriesRequest& request_;
  const Context& context_;
  StillOptions still_;
  CaptureCheckOptions checks_;
  BoardCoverage coverage_;
  std::vector<cv::Point2f> last_view_;
  LiveSeriesSummary summary_;
};

}  // namespace

ChannelSet GuideOf(const SeriesStep& step, const DeviceDescription& description) {
  const int world_laser = description.lasers.size() > 1 ? 1 : 0;
  switch (step.thing) {
    case Thing::kBoard:
      return step.number == 0 ? LaserChannel(description, world_laser) : ChannelSet();
    case Thing::kBoardOnBackplane:
    case Thing::kBoardOnObject:
      return LaserChannel(description, step.number);
    case Thing::kLines: {
      ChannelSet all;
      for (std::size_t k = 0; k < description.lasers.size(); ++k) {
        all |= LaserChannel(description, static_cast<int>(k));
      }
      return all;
    }
    default:
      return {};
  }
}

Result<LiveSeriesSummary> TakeCalibrationSeries(Device& device, Attendant& attendant,
                                                const LiveSeriesRequest& request, const Context& context) {
  if (request.average < 1 || request.average > 64) return UsageError("average must be 1 to 64 frames");
  if (request.tries < 1 || request.tries > 100) return UsageError("tries must be 1 to 100");
  LiveSeries series(device, attendant, request, context);
  Result<LiveSeriesSummary> summary = series.Run();
  const Status off = device.lights->Set({});
  if (summary.ok() && !off.ok()) return off.error();
  return summary;
}

}  // namespace dorsum
