// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <list>
#include <map>
#include <string>

#include "studio/job_runner.h"

namespace dorsum {

// Small, brightened pictures of captures, made one after the other beside the window, those that were asked
// for last first. However large a campaign is, only the latest pictures are kept and only the latest wishes
// are fulfilled: who scrolls past a row does not wait for it. No widgets.
class CampaignThumbnails : public QObject {
  Q_OBJECT

 public:
  // `side`: the longer side of a picture, px; `kept`: how many pictures at most, at least 1.
  explicit CampaignThumbnails(int side, std::size_t kept = 400, QObject* parent = nullptr);

  // Of bgHand in this capture folder: what is known of it already, or an empty picture, and Made() follows,
  // unless so many others are asked for that the wish is dropped; to be asked for again when it is drawn
  // again. One that cannot be read has none. `stamp` tells captures apart that follow each other in one
  // folder.
  QImage Want(const std::filesystem::path& capture, const std::string& stamp);
  std::size_t open_wishes() const { return wishes_.size(); }

 signals:
  void Made(const QString& capture);  // folder

 private:
  struct Wish {
    std::filesystem::path capture;
    std::string stamp;
  };
  struct Known {
    std::string stamp;
    QImage picture;  // empty: it cannot be made
  };
  void Next();
  void Keep(const Wish& wish, QImage picture);

  int side_;
  std::size_t kept_;
  std::map<std::filesystem::path, Known> known_;
  std::list<std::filesystem::path> used_;  // keys of known_, the latest made first
  std::deque<Wish> wishes_;                // the latest first
  std::filesystem::path now_;              // being made
  JobRunner runner_;
};

}  // namespace dorsum
