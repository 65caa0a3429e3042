// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "studio/campaign_thumbnails.h"
#include "studio/campaign_view.h"

namespace dorsum {

// A campaign as a table: a row for each person; id, sex and age group; then a column for each hand of each
// session, with what is there, what is missing, and the last capture's picture. Pictures are only asked for
// as cells are drawn.
class CampaignTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  static constexpr int kPersonColumns = 3;               // id, sex, age group
  static constexpr int kSortRole = Qt::UserRole;         // by what a column is to be sorted
  static constexpr int kMissingRole = Qt::UserRole + 1;  // captures of this cell, or of the person, int

  explicit CampaignTable(CampaignThumbnails* thumbnails, QObject* parent = nullptr);

  // `dir`: the campaign's folder. Without a view the table is empty.
  void SetView(std::shared_ptr<const CampaignView> view, const std::filesystem::path& dir);
  const std::shared_ptr<const CampaignView>& view() const { return view_; }

  // What a cell stands for. Columns of the person have neither session nor hand.
  CampaignPlace PlaceAt(const QModelIndex& index) const;
  QModelIndex IndexOf(const CampaignPlace& place) const;
  // The first place after this one, row by row, where something is missing; from the beginning again after
  // the last.
  std::optional<CampaignPlace> NextGap(const QModelIndex& after) const;
  // The captures of a cell, or all of a person.
  std::vector<CampaignCapture> CapturesAt(const QModelIndex& index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Column {
    int session = 0;
    CampaignHand hand = CampaignHand::kLeft;
  };
  const CampaignHandView* Cell(const QModelIndex& index) const;
  static QVariant PersonData(const CampaignPersonView& person, int column, int role);
  QVariant CellData(const QModelIndex& index, int role) const;
  QVariant Picture(const QModelIndex& index) const;

  CampaignThumbnails* thumbnails_;
  std::shared_ptr<const CampaignView> view_;
  std::filesystem::path dir_;
  std::vector<Column> columns_;                               // beyond those of the person
  mutable std::map<QString, QPersistentModelIndex> waiting_;  // cells whose picture is being made, by folder
};

// Words that people read.
QString HandTitle(CampaignHand hand);
QString SexTitle(const std::string& word);
QString AgeTitle(const std::string& word);

}  // namespace dorsum
