// widgets/studio/common/HeadTable.h - the first lines of a file that is imported, as a table to look at.
#pragma once

#include <string>
#include <vector>

class QTableWidget;
class QWidget;

namespace squat::studio {

// Nothing in it can be changed; Tab leaves it.
QTableWidget* makeHeadTable(QWidget* parent);

// Rows may be shorter than `columns`; what they have beyond is left out.
void showHead(QTableWidget& table, const std::vector<std::vector<std::string>>& rows, int columns);

}  // namespace squat::studio
