#include "plots/LegendRows.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace squat::plots {
namespace {

// Draws the name of its curve, shortened to the room that it has.
class LegendEntry : public QCPPlottableLegendItem {
 public:
  LegendEntry(QCPLegend& legend, QCPAbstractPlottable* curve) : QCPPlottableLegendItem(&legend, curve) {}

  // The legend makes a column as wide as this; it is given the row instead.
  QSize minimumOuterSizeHint() const override { return {0, QCPPlottableLegendItem::minimumOuterSizeHint().height()}; }

 protected:
  void draw(QCPPainter* painter) override {
    const QString name = mPlottable->name();
    const int room = rect().width() - mParentLegend->iconSize().width() - mParentLegend->iconTextPadding();
    mPlottable->setName(QFontMetrics(getFont()).elidedText(name, Qt::ElideMiddle, room));
    QCPPlottableLegendItem::draw(painter);
    mPlottable->setName(name);
  }
};

std::vector<QCPAbstractPlottable*> curvesOf(const QCPLegend& legend) {
  std::vector<QCPAbstractPlottable*> curves;
  for (int i = 0; i < legend.itemCount(); ++i)
    if (auto* item = qobject_cast<QCPPlottableLegendItem*>(legend.item(i))) curves.push_back(item->plottable());
  return curves;
}

int widthOf(const QCPLegend& legend, const QString& name) {
  return legend.iconSize().width() + legend.iconTextPadding() +
         QFontMetrics(legend.font()).boundingRect(0, 0, 0, 0, Qt::TextDontClip, name).width();
}

// Of rows filled one after the other: each column is as wide as its widest name.
int widthOfColumns(const std::vector<int>& widths, std::size_t columns, int spacing) {
  std::vector<int> widest(columns, 0);
  for (std::size_t i = 0; i < widths.size(); ++i) widest[i % columns] = std::max(widest[i % columns], widths[i]);
  return std::accumulate(widest.begin(), widest.end(), spacing * (static_cast<int>(columns) - 1));
}

void refill(QCPLegend& legend, const std::vector<QCPAbstractPlottable*>& curves, int columns, bool shortened) {
  legend.clearItems();
  legend.setWrap(columns);
  for (auto* curve : curves) {
    if (shortened)
      legend.addItem(new LegendEntry(legend, curve));
    else
      legend.addItem(new QCPPlottableLegendItem(&legend, curve));
  }
}

}  // namespace

void fitLegend(QCPLegend& legend, int width) {
  const auto curves = curvesOf(legend);
  if (curves.empty() || curves.size() != static_cast<std::size_t>(legend.itemCount())) return;
  std::vector<int> widths;
  for (const auto* curve : curves) widths.push_back(widthOf(legend, curve->name()));
  const int room = width - legend.margins().left() - legend.margins().right();
  std::size_t columns = curves.size();
  while (columns > 1 && widthOfColumns(widths, columns, legend.columnSpacing()) > room) --columns;
  const bool shortened = widthOfColumns(widths, columns, legend.columnSpacing()) > room;
  const bool isShortened = dynamic_cast<LegendEntry*>(legend.item(0)) != nullptr;
  if (legend.columnCount() == static_cast<int>(columns) && shortened == isShortened) return;
  refill(legend, curves, static_cast<int>(columns), shortened);
}

}  // namespace squat::plots
