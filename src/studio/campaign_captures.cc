// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_captures.h"

#include <QIcon>
#include <QLocale>
#include <QPixmap>
#include <utility>

#include "studio/campaign_table.h"

namespace dorsum {

CampaignCaptures::CampaignCaptures(CampaignThumbnails* thumbnails, QSize size, QObject* parent)
    : QAbstractListModel(parent), thumbnails_(thumbnails), size_(size) {
  connect(thumbnails, &CampaignThumbnails::Made, this, [this](const QString& folder) {
    for (std::size_t i = 0; i < captures_.size(); ++i) {
      if (captures_[i].Folder(dir_) != std::filesystem::path(folder.toStdString())) continue;
      const QModelIndex changed = index(static_cast<int>(i));
      return emit dataChanged(changed, changed, {Qt::DecorationRole});
    }
  });
}

void CampaignCaptures::Set(std::vector<CampaignCapture> captures, const std::filesystem::path& dir,
                           std::size_t lasers) {
  beginResetModel();
  captures_ = std::move(captures);
  dir_ = dir;
  lasers_ = lasers;
  endResetModel();
}

int CampaignCaptures::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(captures_.size());
}

QString CampaignCaptures::Sentence(const CampaignCapture& capture) const {
  std::uint64_t bytes = 0;
  for (const StoredPicture& picture : capture.stored.pictures) bytes += picture.bytes;
  QString text = tr("%1, session %2, %3, capture %4: %5.")
                     .arg(QString::fromStdString(capture.id))
                     .arg(capture.session)
                     .arg(HandTitle(capture.stored.hand))
                     .arg(capture.stored.number)
                     .arg(QLocale().formattedDataSize(static_cast<qint64>(bytes)));
  if (capture.stored.lasers.size() < lasers_) text += ' ' + tr("The picture of a laser is missing.");
  if (capture.stored.calibration.empty()) text += ' ' + tr("It has no calibration.");
  return text;
}

QVariant CampaignCaptures::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const CampaignCapture& capture = captures_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole: {
      const bool whole = capture.stored.lasers.size() >= lasers_ && !capture.stored.calibration.empty();
      return tr("Session %1, %2, %3")
                 .arg(capture.session)
                 .arg(HandTitle(capture.stored.hand))
                 .arg(capture.stored.number) +
             (whole ? QString() : QString(" ⚠"));
    }
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return Sentence(capture);
    case Qt::SizeHintRole:
      return size_;
    case Qt::DecorationRole: {
      const auto& pictures = capture.stored.pictures;
      const QImage picture =
          thumbnails_->Want(capture.Folder(dir_), pictures.empty() ? "" : pictures.front().sha256);
      return picture.isNull() ? QVariant() : QVariant(QIcon(QPixmap::fromImage(picture)));
    }
    default:
      return {};
  }
}

}  // namespace dorsum
