// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_people.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "studio/campaign_filter.h"
#include "studio/campaign_table.h"

namespace dorsum {

CampaignPeople::CampaignPeople(CampaignTable* table, QWidget* parent)
    : QWidget(parent),
      table_(table),
      filter_(new CampaignFilter(this)),
      view_(new QTableView(this)),
      search_(new QLineEdit(this)),
      only_missing_(new QCheckBox(tr("Only &what is missing"), this)),
      add_(new QPushButton(tr("&Add a person…"), this)) {
  filter_->setSourceModel(table_);
  search_->setObjectName("search");
  search_->setPlaceholderText(tr("Find an id"));
  search_->setAccessibleName(tr("Find an id"));
  search_->setClearButtonEnabled(true);
  search_->setMinimumWidth(search_->fontMetrics().horizontalAdvance(search_->placeholderText()) +
                           3 * search_->fontMetrics().height());  // the button that clears, and margins
  only_missing_->setObjectName("onlyMissing");
  only_missing_->setToolTip(tr("Hides the people of whom all is there"));
  add_->setObjectName("addPerson");
  add_->setToolTip(tr("With the day of the consent"));
  auto* gap = new QPushButton(tr("Next &gap"), this);
  gap->setObjectName("gap");
  gap->setToolTip(tr("Goes to the next hand of which something is missing"));
  auto* row = new QHBoxLayout;
  row->addWidget(search_, 1);
  for (QWidget* widget :
       {static_cast<QWidget*>(only_missing_), static_cast<QWidget*>(gap), static_cast<QWidget*>(add_)})
    row->addWidget(widget);
  const int em = fontMetrics().height();
  view_->setObjectName("people");
  view_->setAccessibleName(tr("People and their hands"));
  view_->setModel(filter_);
  view_->setSortingEnabled(true);
  view_->sortByColumn(0, Qt::AscendingOrder);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setIconSize({4 * em, 3 * em});
  view_->setWordWrap(false);
  view_->setTabKeyNavigation(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // so that no row needs to be measured
  view_->verticalHeader()->setDefaultSectionSize(3 * em + em / 2);
  view_->horizontalHeader()->setDefaultSectionSize(8 * em);
  KeepColumns();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins({});
  column->addLayout(row);
  column->addWidget(view_, 1);
  connect(search_, &QLineEdit::textChanged, filter_, &CampaignFilter::SetText);
  connect(only_missing_, &QCheckBox::toggled, filter_, &CampaignFilter::SetOnlyMissing);
  connect(gap, &QPushButton::clicked, this, &CampaignPeople::ShowNextGap);
  connect(add_, &QPushButton::clicked, this, &CampaignPeople::AddWanted);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) { emit Chosen(filter_->mapToSource(now)); });
}

// A campaign is read anew after each change; what the person made of the columns stays.
void CampaignPeople::KeepColumns() {
  connect(filter_, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
    if (filter_->columnCount() > 0) columns_ = view_->horizontalHeader()->saveState();
  });
  connect(filter_, &QAbstractItemModel::modelReset, this, [this] {
    QHeaderView* header = view_->horizontalHeader();
    const QByteArray before = std::exchange(columns_, {});
    const int em = fontMetrics().height();
    for (int column = 0; column < std::min(header->count(), CampaignTable::kPersonColumns); ++column)
      header->resizeSection(column, 5 * em + em / 2);
    if (!before.isEmpty() && header->count() == shown_columns_) header->restoreState(before);
    shown_columns_ = header->count();
  });
}

void CampaignPeople::Choose(const CampaignPlace& place) {
  const QModelIndex cell = filter_->mapFromSource(table_->IndexOf(place));
  if (!cell.isValid() || cell == view_->currentIndex()) return emit Chosen(filter_->mapToSource(cell));
  view_->setCurrentIndex(cell);
  view_->scrollTo(cell);
}

void CampaignPeople::SetAddingPossible(bool possible) { add_->setEnabled(possible); }

void CampaignPeople::ShowNextGap() {
  const auto gap = table_->NextGap(filter_->mapToSource(view_->currentIndex()));
  if (!gap) return emit NothingMissing();
  search_->clear();
  Choose(*gap);
}

}  // namespace dorsum
