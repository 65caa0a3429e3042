// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_thumbnails.h"

#include <algorithm>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "captures/image_file.h"
#include "captures/names.h"
#include "report/photo_pictures.h"
#include "studio/fitted_picture.h"

namespace dorsum {
namespace {

constexpr std::size_t kOpenWishes = 256;  // more than a window shows

Result<QImage> MakeThumbnail(const std::filesystem::path& capture, int side) {
  DORSUM_ASSIGN_OR_RETURN(const std::filesystem::path path, RequireImage(capture, kBgHandName));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat photo, ReadImage(path));
  const double scale = std::min(1.0, side / static_cast<double>(std::max(photo.cols, photo.rows)));
  const cv::Size size(std::max(1, cvRound(scale * photo.cols)), std::max(1, cvRound(scale * photo.rows)));
  cv::Mat small;
  cv::resize(photo, small, size, 0.0, 0.0, cv::INTER_AREA);
  return FittedPicture::ImageOf(BrightenPhoto(small));
}

}  // namespace

CampaignThumbnails::CampaignThumbnails(int side, std::size_t kept, QObject* parent)
    : QObject(parent), side_(side), kept_(std::max<std::size_t>(1, kept)) {}

QImage CampaignThumbnails::Want(const std::filesystem::path& capture, const std::string& stamp) {
  const auto it = known_.find(capture);
  if (it != known_.end() && it->second.stamp == stamp) return it->second.picture;
  if (now_ == capture) return {};
  std::erase_if(wishes_, [&](const Wish& wish) { return wish.capture == capture; });
  wishes_.push_front({capture, stamp});
  if (wishes_.size() > kOpenWishes) wishes_.pop_back();
  Next();
  return {};
}

void CampaignThumbnails::Next() {
  if (runner_.busy() || wishes_.empty()) return;
  Wish wish = std::move(wishes_.front());
  wishes_.pop_front();
  now_ = wish.capture;
  runner_.Run<QImage>(
      {}, [capture = wish.capture, side = side_](const Context&) { return MakeThumbnail(capture, side); },
      [this, wish](Result<QImage> picture) {
        now_.clear();
        Keep(wish, picture.ok() ? std::move(picture).value() : QImage());
        Next();
      });
}

void CampaignThumbnails::Keep(const Wish& wish, QImage picture) {
  if (known_.contains(wish.capture)) used_.remove(wish.capture);
  known_[wish.capture] = {wish.stamp, std::move(picture)};
  used_.push_front(wish.capture);
  while (used_.size() > kept_) {
    known_.erase(used_.back());
    used_.pop_back();
  }
  emit Made(QString::fromStdString(wish.capture.string()));
}

}  // namespace dorsum
