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

namespace {

QString nameOf(const QTableView& table, int column) {
  return table.model()->headerData(column, Qt::Horizontal, columnNameRole).toString();
}

}  // namespace

QString sortedColumn(const QTableView& table) {
  const int column = table.horizontalHeader()->sortIndicatorSection();
  return column < 0 ? QString() : nameOf(table, column);
}

bool isDescending(const QTableView& table) {
  return table.horizontalHeader()->sortIndicatorOrder() == Qt::DescendingOrder;
}

void sortBy(QTableView& table, const QString& column, bool descending) {
  int found = column.isEmpty() ? -1 : table.model()->columnCount() - 1;
  while (found >= 0 && nameOf(table, found) != column) --found;
  const bool isDown = found >= 0 && descending;
  table.horizontalHeader()->setSortIndicator(found, isDown ? Qt::DescendingOrder : Qt::AscendingOrder);
}

}  // namespace squat::studio
