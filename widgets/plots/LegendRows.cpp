#include "plots/LegendRows.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace squat::plots {
namespace {

constexpr double shareOfText = 0.35;  // in the colour of names whose curves are hidden

QColor dimmed(const QColor& text, const QColor& ground) {
  const auto mixed = [](int front, int back) { return qRound(shareOfText * front + (1 - shareOfText) * back); };
  return {mixed(text.red(), ground.red()), mixed(text.green(), ground.green()), mixed(text.blue(), ground.blue())};
}

// Draws the name of its curve, dimmed where that is hidden, and shortened to the room that it has where it is too long.
class LegendEntry : public QCPPlottableLegendItem {
 public:
  LegendEntry(QCPLegend& legend, QCPAbstractPlottable* curve, const QColor& ground, bool isShortened)
      : QCPPlottableLegendItem(&legend, curve), ground_(ground), isShortened_(isShortened) {}

  bool isShortened() const { return isShortened_; }

  // The legend makes a column as wide as this; a name that is shortened is given the row instead.
  QSize minimumOuterSizeHint() const override {
    const QSize whole = QCPPlottableLegendItem::minimumOuterSizeHint();
    return isShortened_ ? QSize(0, whole.height()) : whole;
  }

 protected:
  void draw(QCPPainter* painter) override {
    const QString name = mPlottable->name();
    const int room = rect().width() - mParentLegend->iconSize().width() - mParentLegend->iconTextPadding();
    if (isShortened_) mPlottable->setName(QFontMetrics(getFont()).elidedText(name, Qt::ElideMiddle, room));
    mPlottable->visible() ? QCPPlottableLegendItem::draw(painter) : drawDimmed(*painter);
    if (isShortened_) mPlottable->setName(name);
  }

 private:
  // The name at the place that it has otherwise, so that nothing moves; no line in front of it.
  void drawDimmed(QCPPainter& painter) {
    const QSize icon = mParentLegend->iconSize();
    painter.setFont(getFont());
    painter.setPen(QPen(dimmed(QCPPlottableLegendItem::getTextColor(), ground_)));
    const QRect text = painter.fontMetrics().boundingRect(0, 0, 0, icon.height(), Qt::TextDontClip, mPlottable->name());
    painter.drawText(rect().x() + icon.width() + mParentLegend->iconTextPadding(), rect().y(), text.width(),
                     std::max(text.height(), icon.height()), Qt::TextDontClip, mPlottable->name());
  }

  QColor ground_;
  bool isShortened_;
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

void refill(QCPLegend& legend, const std::vector<QCPAbstractPlottable*>& curves, const QColor& ground, int columns,
            bool shortened) {
  legend.clearItems();
  legend.setWrap(columns);
  for (auto* curve : curves) legend.addItem(new LegendEntry(legend, curve, ground, shortened));
}

// A curve that has come since then has an entry of the library's own.
bool isFilled(const QCPLegend& legend, int columns, bool shortened) {
  for (int i = 0; i < legend.itemCount(); ++i) {
    const auto* entry = dynamic_cast<LegendEntry*>(legend.item(i));
    if (!entry || entry->isShortened() != shortened) return false;
  }
  return legend.columnCount() == columns;
}

}  // namespace

void fitLegend(QCPLegend& legend, int width, const QColor& ground) {
  const auto curves = curvesOf(legend);
  if (curves.empty() || curves.size() != static_cast<std::size_t>(legend.itemCount())) return;
  std::vector<int> widths;
  for (const auto* curve : curves) widths.push_back(widthOf(legend, curve->name()));
  const int room = width - legend.margins().left() - legend.margins().right();
  std::size_t columns = curves.size();
  while (columns > 1 && widthOfColumns(widths, columns, legend.columnSpacing()) > room) --columns;
  const bool shortened = widthOfColumns(widths, columns, legend.columnSpacing()) > room;
  if (isFilled(legend, static_cast<int>(columns), shortened)) return;
  refill(legend, curves, ground, static_cast<int>(columns), shortened);
}

}  // namespace squat::plots
