// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QWidget>

#include "studio/campaign_view.h"

class QCheckBox;
class QLineEdit;
class QModelIndex;
class QPushButton;
class QTableView;

namespace dorsum {

class CampaignFilter;
class CampaignTable;

// The table of a campaign's people, to be sorted, searched and narrowed to those of whom something is
// missing.
class CampaignPeople : public QWidget {
  Q_OBJECT

 public:
  CampaignPeople(CampaignTable* table, QWidget* parent);

  // Chosen() follows. Nothing is chosen where the table does not show the place.
  void Choose(const CampaignPlace& place);
  void SetAddingPossible(bool possible);

 signals:
  void Chosen(const QModelIndex& cell);  // of the table; invalid: nothing
  void AddWanted();
  void NothingMissing();  // the next gap was asked for, and there is none

 private:
  void KeepColumns();
  void ShowNextGap();

  CampaignTable* table_;
  CampaignFilter* filter_;
  QTableView* view_;
  QLineEdit* search_;
  QCheckBox* only_missing_;
  QPushButton* add_;
  QByteArray columns_;     // the header's state
  int shown_columns_ = 0;  // whose state it is
};

}  // namespace dorsum
