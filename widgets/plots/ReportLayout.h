// widgets/plots/ReportLayout.h - where the pages of a report end.
#pragma once

#include <QTextDocument>
#include <QTextFormat>

namespace squat::plots {

inline constexpr int staysWithNext = QTextFormat::UserProperty + 1;  // of a block: true for a heading

// Of a document that has its pages. A heading that would be left at the foot of a page begins on the next one, with the
// first rows or the first line of what it heads; so does a row of a table that a page would end in. A page break that
// would leave an empty page is taken away. `unitsPerInch`: of the document's layout.
void arrangePages(QTextDocument& document, double unitsPerInch);

}  // namespace squat::plots
