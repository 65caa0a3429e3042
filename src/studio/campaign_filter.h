// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSortFilterProxyModel>

namespace dorsum {

// The people of a CampaignTable whose id holds a text, or of whom something is missing.
class CampaignFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit CampaignFilter(QObject* parent = nullptr);

  void SetText(const QString& part);
  void SetOnlyMissing(bool only);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QString part_;
  bool only_missing_ = false;
};

}  // namespace dorsum
