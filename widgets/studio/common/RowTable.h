// widgets/studio/common/RowTable.h - tables of rows, one of which is chosen: runs, comparison, events.
#pragma once

#include <QString>
#include <Qt>

class QTableView;

namespace squat::studio {

// Whole rows are chosen, one at a time; Tab leaves the table; columns are as wide as their contents, and a click on a
// heading sorts: up, down, and as it was. The table has its model already.
void makeRowTable(QTableView& table);

// Of a heading: what a project calls the column, whatever its language and wherever it stands.
inline constexpr int columnNameRole = Qt::UserRole + 3;

QString sortedColumn(const QTableView& table);  // its name; empty: the rows stand as they were made
bool isDescending(const QTableView& table);
// As a click on the heading would; rows stand as they were made where there is no such column.
void sortBy(QTableView& table, const QString& column, bool descending);

}  // namespace squat::studio
