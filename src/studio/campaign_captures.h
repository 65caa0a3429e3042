// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QSize>
#include <filesystem>
#include <map>
#include <vector>

#include "jobs/campaign.h"
#include "studio/campaign_thumbnails.h"

namespace dorsum {

// Captures as a list with their pictures, which are only asked for as they are drawn.
class CampaignCaptures : public QAbstractListModel {
  Q_OBJECT

 public:
  // `size`: of a capture in the view, also before its picture is there.
  CampaignCaptures(CampaignThumbnails* thumbnails, QSize size, QObject* parent = nullptr);

  // Of the campaign in `dir`, whose device has so many lasers.
  void Set(std::vector<CampaignCapture> captures, const std::filesystem::path& dir, std::size_t lasers);
  const std::vector<CampaignCapture>& captures() const { return captures_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  QString Sentence(const CampaignCapture& capture) const;

  CampaignThumbnails* thumbnails_;
  QSize size_;
  std::vector<CampaignCapture> captures_;
  std::filesystem::path dir_;
  std::size_t lasers_ = 0;
};

}  // namespace dorsum
