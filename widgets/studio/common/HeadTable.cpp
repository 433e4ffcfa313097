#include "studio/common/HeadTable.h"

#include <QObject>
#include <QTableWidget>
#include <algorithm>

namespace squat::studio {

QTableWidget* makeHeadTable(QWidget* parent) {
  auto* table = new QTableWidget(parent);
  table->setTabKeyNavigation(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setAccessibleName(QObject::tr("First lines of the file"));
  return table;
}

void showHead(QTableWidget& table, const std::vector<std::vector<std::string>>& rows, int columns) {
  table.clearContents();
  table.setRowCount(static_cast<int>(rows.size()));
  table.setColumnCount(columns);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < std::min(rows[row].size(), static_cast<std::size_t>(columns)); ++column)
      table.setItem(static_cast<int>(row), static_cast<int>(column),
                    new QTableWidgetItem(QString::fromStdString(rows[row][column])));
}

}  // namespace squat::studio
