// widgets/studio/common/NarrowTabs.h - tabs hardly wider than their words.
#pragma once

#include <QProxyStyle>
#include <QTabBar>

namespace squat::studio {

// Less room beside the word of a tab than usual, and less still where there are many: all figures of a run then stand
// side by side on a small screen.
class NarrowTabs : public QProxyStyle {
 public:
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    constexpr int few = 9, besideText = 10, besideTextOfMany = 3;
    const auto* bar = qobject_cast<const QTabBar*>(widget);
    if (metric != PM_TabBarTabHSpace || !bar) return QProxyStyle::pixelMetric(metric, option, widget);
    int seen = 0;
    for (int tab = 0; tab < bar->count(); ++tab)
      if (bar->isTabVisible(tab)) ++seen;
    return seen > few ? besideTextOfMany : besideText;
  }
};

inline void makeNarrow(QTabBar& bar) {
  auto* style = new NarrowTabs;
  style->setParent(&bar);  // a widget does not own its style
  bar.setStyle(style);
}

}  // namespace squat::studio
