#include "studio/common/RowTable.h"

#include <QTableView>

#include "studio/common/NarrowHeader.h"

namespace squat::studio {

void makeRowTable(QTableView& table) {
  table.setTabKeyNavigation(false);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
  table.setWordWrap(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 6);
  auto* heading = new NarrowHeader(&table);
  table.setHorizontalHeader(heading);
  heading->setSectionResizeMode(QHeaderView::ResizeToContents);
  heading->setSortIndicator(-1, Qt::AscendingOrder);
  heading->setSortIndicatorClearable(true);
  table.setSortingEnabled(true);
}

}  // namespace squat::studio
