// widgets/studio/common/NarrowHeader.h - headings of several lines, hardly wider than their words.
#pragma once

#include <QHeaderView>
#include <algorithm>

namespace squat::studio {

// The style keeps room for the arrow of sorting beside every heading, as wide as the heading is high: here the column
// that is sorted alone has it.
class NarrowHeader : public QHeaderView {
 public:
  explicit NarrowHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
    setSectionsClickable(true);
    setHighlightSections(false);
    setDefaultAlignment(Qt::AlignCenter);
  }

 protected:
  QSize sectionSizeFromContents(int section) const override {
    constexpr int margin = 6, arrow = 14;  // [pixels]
    int widest = 0;
    for (const QString& line : model()->headerData(section, Qt::Horizontal).toString().split('\n'))
      widest = std::max(widest, fontMetrics().horizontalAdvance(line));
    const bool sorted = section == sortIndicatorSection();
    return {widest + 2 * margin + (sorted ? arrow : 0), QHeaderView::sectionSizeFromContents(section).height()};
  }
};

}  // namespace squat::studio
