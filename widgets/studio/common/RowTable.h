// widgets/studio/common/RowTable.h - tables of rows, one of which is chosen: runs, comparison, events.
#pragma once

class QTableView;

namespace squat::studio {

// Whole rows are chosen, one at a time; Tab leaves the table; columns are as wide as their contents, and a click on a
// heading sorts: up, down, and as it was. The table has its model already.
void makeRowTable(QTableView& table);

}  // namespace squat::studio
