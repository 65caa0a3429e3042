// SPDX-License-Identifier: Apache-2.0
#include "jobs/picture_stripes.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "captures/green_channel.h"
#include "imaging/stage_sink.h"
#include "stripes/backplane_check.h"
#include "stripes/busy_part.h"
#include "stripes/ridge_survey.h"

namespace dorsum {
namespace {

constexpr double kUnchanged = 0.06;  // share of the light that noise and drift may change

// Lasers that are calibrated, wanted and in the capture.
std::vector<int> LasersToUse(const CaptureImages& capture, const DeviceGeometry& device,
                             const std::vector<int>& wanted) {
  std::vector<int> lasers;
  for (const LaserGeometry& laser : device.lasers) {
    const auto k = static_cast<std::size_t>(laser.laser);
    const bool asked = wanted.empty() || std::find(wanted.begin(), wanted.end(), laser.laser) != wanted.end();
    if (asked && k < capture.stripes.size() && capture.stripes[k]) lasers.push_back(laser.laser);
  }
  return lasers;
}

Status CheckDevice(const std::vector<LaserStripes>& stripes, const cv::Mat& unchanged,
                   const DeviceOrders& orders) {
  std::string moved;
  double shift = 0.0;
  for (const BackplaneCheck& check : CheckBackplane(stripes, orders, unchanged, {})) {
    if (!check.moved) continue;
    moved += (moved.empty() ? "" : ", ") + std::to_string(check.laser);
    shift = std::max(shift, check.shift_px);
  }
  if (moved.empty()) return {};
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", shift);
  return BadInput("the stripes of laser " + moved + " lie " + text +
                  " px beside their places on the backplane: camera, laser or backplane moved since the "
                  "calibration; calibrate again");
}

class PictureSearch {
 public:
  PictureSearch(const CaptureImages& capture, const cv::Mat& region, const DeviceOrders& orders,
                const ReconstructOptions& options, const Context& context)
      : capture_(capture),
        region_(region),
        orders_(orders),
        options_(options),
        context_(context),
        lasers_(LasersToUse(capture, orders.device(), options.lasers)) {
    if (context.sink != nullptr) context_.threads = 1;  // a sink is called from one thread
    out_.stripes.resize(lasers_.size());
    for (const int laser : lasers_) out_.pictures[laser];
    ForLasers([&](std::size_t, int laser) { PictureOf(laser).green = GreenChannel(ImageOf(laser)); });
  }

  Status FindClassic(const UnchangedPart* unchanged) {
    ForLasers([&](std::size_t i, int laser) {
      const cv::Mat mask = ExtractStripeMask(ImageOf(laser), region_, options_.stripe_mask,
                                             "stripes/" + std::to_string(laser), context_);
      out_.stripes[i] =
          SmoothSegments(ExtractClassicSegments(mask, PictureOf(laser).green, laser, options_.segments),
                         options_.segments.min_rows, options_.smoothing);
    });
    return unchanged == nullptr ? Status{}
                                : CheckDevice(out_.stripes, unchanged->Mask(kUnchanged, context_), orders_);
  }

  Status FindAllRidges(const UnchangedPart* unchanged) {
    std::vector<RidgeSurvey> surveys(lasers_.size());
    RidgeOptions ridge = options_.ridge;
    ridge.scale_deviations = false;  // MeasureStripes() pools
    ForLasers([&](std::size_t i, int laser) {
      LaserPicture& picture = PictureOf(laser);
      surveys[i] = SurveyRidges(picture.green, region_, ridge.width_px, ridge.detection, ridge.fit, context_);
      picture.noise = surveys[i].noise;
    });
    cv::Mat busy = region_;
    if (unchanged != nullptr) {
      const cv::Mat same = unchanged->Mask(kUnchanged, context_);
      std::vector<LaserStripes> surveyed(lasers_.size());
      for (std::size_t i = 0; i < lasers_.size(); ++i) {
        surveyed[i].laser = lasers_[i];
        surveyed[i].points = std::move(surveys[i].points);
      }
      const bool joint = options_.indexing == "joint";
      Status in_place;
      ParallelFor(context_, 0, joint ? 2 : 1, [&](std::int64_t task) {
        if (task == 0) in_place = CheckDevice(surveyed, same, orders_);
        if (task == 1) busy = FindBusyPart(surveyed, orders_, same, {}, context_);
      });
      if (!in_place.ok()) return in_place.error();
      if (joint) LeaveOutEmpty(std::move(surveyed), busy);
    }
    ForLasers([&](std::size_t i, int laser) {
      out_.stripes[i] = FindRidges(PictureOf(laser).green, busy, laser, surveys[i], ridge, context_);
    });
    return {};
  }

  PictureStripes Take() { return std::move(out_); }

 private:
  LaserPicture& PictureOf(int laser) { return out_.pictures.at(laser); }
  const cv::Mat& ImageOf(int laser) const { return *capture_.stripes[static_cast<std::size_t>(laser)]; }

  template <class Body>
  void ForLasers(const Body& body) {
    ParallelFor(context_, 0, static_cast<std::int64_t>(lasers_.size()), [&](std::int64_t i) {
      const auto k = static_cast<std::size_t>(i);
      body(k, lasers_[k]);
    });
  }

  // Of what was surveyed, only the empty backplane is of use later.
  void LeaveOutEmpty(std::vector<LaserStripes> surveyed, const cv::Mat& busy) {
    Sink(context_, "stripes/busy", busy);
    out_.empty = busy == 0;
    const cv::Rect picture({}, busy.size());
    for (LaserStripes& one : surveyed) {
      std::erase_if(one.points, [&](const StripePoint& p) {
        const cv::Point at(cvRound(p.u), cvRound(p.v));
        return !picture.contains(at) || out_.empty.at<std::uint8_t>(at) == 0;
      });
    }
    out_.backplane = std::move(surveyed);
  }

  const CaptureImages& capture_;
  const cv::Mat& region_;
  const DeviceOrders& orders_;
  const ReconstructOptions& options_;
  Context context_;
  std::vector<int> lasers_;
  PictureStripes out_;
};

}  // namespace

Result<PictureStripes> FindPictureStripes(const CaptureImages& capture, const cv::Mat& region,
                                          const UnchangedPart* unchanged, const DeviceOrders& orders,
                                          const ReconstructOptions& options, const Context& context) {
  PictureSearch search(capture, region, orders, options, context);
  DORSUM_RETURN_IF_ERROR(options.stripes == "ridge" ? search.FindAllRidges(unchanged)
                                                    : search.FindClassic(unchanged));
  return search.Take();
}

}  // namespace dorsum
