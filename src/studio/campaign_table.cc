// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_table.h"

#include <QFont>
#include <QIcon>
#include <QPixmap>
#include <algorithm>
#include <utility>

namespace dorsum {

QString HandTitle(CampaignHand hand) {
  return hand == CampaignHand::kLeft ? CampaignTable::tr("left hand") : CampaignTable::tr("right hand");
}

QString SexTitle(const std::string& word) {
  if (word == "man") return CampaignTable::tr("man");
  if (word == "woman") return CampaignTable::tr("woman");
  if (word == "other") return CampaignTable::tr("other");
  return CampaignTable::tr("not said");
}

QString AgeTitle(const std::string& word) {
  return word == "not-said" ? CampaignTable::tr("not said") : QString::fromStdString(word);
}

CampaignTable::CampaignTable(CampaignThumbnails* thumbnails, QObject* parent)
    : QAbstractTableModel(parent), thumbnails_(thumbnails) {
  connect(thumbnails, &CampaignThumbnails::Made, this, [this](const QString& capture) {
    const auto it = waiting_.find(capture);
    if (it == waiting_.end()) return;
    const QModelIndex index = it->second;
    waiting_.erase(it);
    if (index.isValid()) emit dataChanged(index, index, {Qt::DecorationRole});
  });
}

void CampaignTable::SetView(std::shared_ptr<const CampaignView> view, const std::filesystem::path& dir) {
  beginResetModel();
  view_ = std::move(view);
  dir_ = dir;
  waiting_.clear();
  columns_.clear();
  if (view_) {
    const CampaignPlan& plan = view_->status.campaign.plan;
    for (int session = 1; session <= plan.sessions; ++session) {
      for (const CampaignHand hand : plan.hands) columns_.push_back({session, hand});
    }
  }
  endResetModel();
}

CampaignPlace CampaignTable::PlaceAt(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  CampaignPlace place{view_->people[static_cast<std::size_t>(index.row())].person.id, 0, std::nullopt};
  if (index.column() < kPersonColumns) return place;
  const Column& column = columns_[static_cast<std::size_t>(index.column() - kPersonColumns)];
  place.session = column.session;
  place.hand = column.hand;
  return place;
}

QModelIndex CampaignTable::IndexOf(const CampaignPlace& place) const {
  if (!view_) return {};
  const auto& people = view_->people;
  const auto person = std::find_if(people.begin(), people.end(),
                                   [&](const CampaignPersonView& p) { return p.person.id == place.id; });
  if (person == people.end()) return {};
  int column = 0;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (columns_[c].session == place.session && place.hand == columns_[c].hand)
      column = kPersonColumns + static_cast<int>(c);
  }
  return index(static_cast<int>(person - people.begin()), column);
}

std::optional<CampaignPlace> CampaignTable::NextGap(const QModelIndex& after) const {
  const int cells = static_cast<int>(columns_.size());
  const int all = rowCount() * cells;
  const int from =
      after.isValid() ? after.row() * cells + std::max(-1, after.column() - kPersonColumns) + 1 : 0;
  for (int i = 0; i < all; ++i) {
    const int at = (from + i) % all;
    const QModelIndex cell = index(at / cells, kPersonColumns + at % cells);
    const CampaignHandView* hand = Cell(cell);
    if (hand != nullptr && hand->missing > 0) return PlaceAt(cell);
  }
  return std::nullopt;
}

std::vector<CampaignCapture> CampaignTable::CapturesAt(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  if (index.column() >= kPersonColumns) {
    const CampaignHandView* hand = Cell(index);
    return hand != nullptr ? hand->captures : std::vector<CampaignCapture>();
  }
  std::vector<CampaignCapture> all;
  for (const CampaignSessionView& session : view_->people[static_cast<std::size_t>(index.row())].sessions) {
    for (const CampaignHandView& hand : session.hands)
      all.insert(all.end(), hand.captures.begin(), hand.captures.end());
  }
  return all;
}

int CampaignTable::rowCount(const QModelIndex& parent) const {
  return view_ && !parent.isValid() ? static_cast<int>(view_->people.size()) : 0;
}

int CampaignTable::columnCount(const QModelIndex& parent) const {
  return view_ && !parent.isValid() ? kPersonColumns + static_cast<int>(columns_.size()) : 0;
}

const CampaignHandView* CampaignTable::Cell(const QModelIndex& index) const {
  const Column& column = columns_[static_cast<std::size_t>(index.column() - kPersonColumns)];
  return FindHand(view_->people[static_cast<std::size_t>(index.row())], column.session, column.hand);
}

QVariant CampaignTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (index.column() >= kPersonColumns) return CellData(index, role);
  return PersonData(view_->people[static_cast<std::size_t>(index.row())], index.column(), role);
}

QVariant CampaignTable::PersonData(const CampaignPersonView& person, int column, int role) {
  if (role == kMissingRole) return person.missing;
  if (role == Qt::DisplayRole || role == kSortRole) {
    if (column == 0) return QString::fromStdString(person.person.id);
    return column == 1 ? SexTitle(person.person.sex) : AgeTitle(person.person.age_group);
  }
  if (role != Qt::ToolTipRole) return {};
  const QString id = QString::fromStdString(person.person.id);
  if (person.person.is_virtual) return tr("%1 is a virtual person.").arg(id);
  return tr("%1 consented on %2.").arg(id, QString::fromStdString(person.person.consent_date));
}

QVariant CampaignTable::CellData(const QModelIndex& index, int role) const {
  const CampaignHandView* hand = Cell(index);
  const int there = hand != nullptr ? static_cast<int>(hand->captures.size()) : 0;
  const int missing = hand != nullptr ? hand->missing : 0;
  switch (role) {
    case Qt::DisplayRole:
      return missing == 0 ? QString(QChar(0x2713)) + ' ' + QString::number(there)
                          : tr("%1 of %2").arg(there).arg(there + missing);
    case Qt::FontRole: {  // what is still to be done stands out, whatever the colours are
      QFont font;
      font.setBold(missing > 0);
      return font;
    }
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole: {
      const CampaignPlace place = PlaceAt(index);
      return tr("%1, session %2, %3: %4 captures are there, %5 are missing.")
          .arg(QString::fromStdString(place.id))
          .arg(place.session)
          .arg(HandTitle(*place.hand))
          .arg(there)
          .arg(missing);
    }
    case Qt::DecorationRole:
      return there > 0 ? Picture(index) : QVariant();
    case kSortRole:
    case kMissingRole:
      return missing;
    default:
      return {};
  }
}

QVariant CampaignTable::Picture(const QModelIndex& index) const {
  const CampaignCapture& capture = Cell(index)->captures.back();
  const std::filesystem::path folder = capture.Folder(dir_);
  const auto& pictures = capture.stored.pictures;
  const QImage picture = thumbnails_->Want(folder, pictures.empty() ? "" : pictures.front().sha256);
  if (!picture.isNull()) return QIcon(QPixmap::fromImage(picture));
  waiting_[QString::fromStdString(folder.string())] = index;
  return {};
}

QVariant CampaignTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
  if (section == 0) return tr("Person");
  if (section == 1) return tr("Sex");
  if (section == 2) return tr("Age");
  const auto column = static_cast<std::size_t>(section - kPersonColumns);
  if (column >= columns_.size()) return {};
  return tr("Session %1,\n%2").arg(columns_[column].session).arg(HandTitle(columns_[column].hand));
}

}  // namespace dorsum
