// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_filter.h"

#include "studio/campaign_table.h"

namespace dorsum {

CampaignFilter::CampaignFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setSortRole(CampaignTable::kSortRole);
  setSortCaseSensitivity(Qt::CaseInsensitive);
}

void CampaignFilter::SetText(const QString& part) {
  part_ = part.trimmed();
  invalidateFilter();
}

void CampaignFilter::SetOnlyMissing(bool only) {
  only_missing_ = only;
  invalidateFilter();
}

bool CampaignFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex person = sourceModel()->index(row, 0, parent);
  if (only_missing_ && person.data(CampaignTable::kMissingRole).toInt() == 0) return false;
  return part_.isEmpty() || person.data().toString().contains(part_, Qt::CaseInsensitive);
}

}  // namespace dorsum
