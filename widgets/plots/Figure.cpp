#include "plots/Figure.h"

#include "plots/AxisTicker.h"
#include "plots/CaptionElement.h"
#include "plots/LegendRows.h"

#include <QMouseEvent>

namespace squat::plots {

Figure::Figure(const QString& name, const Style& style, QWidget* parent)
    : QCustomPlot(parent), name_(name), style_(style), caption_(new CaptionElement(this, style)) {
  setObjectName(name);
  setBackground(QBrush(style_.background));
  setNoAntialiasingOnDrag(true);
  addLayer("front", layer("main"));
  layOut();
  styleAxes(*axisRect());
  takeClicks();
  connect(this, &QCustomPlot::beforeReplot, this,
          [this] { fitLegend(*legend, viewport().width(), style_.background); });
}

QSize Figure::printedUnits() const {
  return {qRound(printedSize_.width() * unitsPerMillimetre), qRound(printedSize_.height() * unitsPerMillimetre)};
}

// Rows: caption, legend, axes.
void Figure::layOut() {
  axisRect()->insetLayout()->take(legend);
  plotLayout()->insertRow(0);
  plotLayout()->insertRow(0);
  plotLayout()->addElement(0, 0, caption_);
  // Axes stand in a row of their own, so that a colour scale beside them does not narrow the caption.
  axesRow_ = new QCPLayoutGrid;
  axesRow_->setColumnSpacing(0);
  QCPAxisRect* axes = axisRect();
  plotLayout()->take(axes);
  plotLayout()->addElement(2, 0, axesRow_);
  axesRow_->addElement(0, 0, axes);
  plotLayout()->setRowSpacing(0);
  plotLayout()->setRowStretchFactor(1, 0.001);
  legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
  legend->setBorderPen(Qt::NoPen);
  legend->setBrush(Qt::NoBrush);
  legend->setFont(style_.tickFont());
  legend->setTextColor(style_.text);
  legend->setIconSize(14, 8);
  legend->setIconTextPadding(4);
  // The larger letters of a window would touch the caption above.
  legend->setMargins(QMargins(6, qRound(12 * (style_.fontScale - 1)), 6, 0));
  legend->setColumnSpacing(8);
  legend->setVisible(false);
}

void Figure::styleAxes(QCPAxisRect& axes) {
  axes.setMinimumMargins(QMargins(4, 3, 10, 4));
  axes.setupFullAxesBox(true);
  for (QCPAxis* axis : axes.axes()) {
    axis->setTicker(QSharedPointer<AxisTicker>::create());
    axis->setLabelFont(style_.labelFont());
    axis->setTickLabelFont(style_.tickFont());
    axis->setLabelColor(style_.text);
    axis->setTickLabelColor(style_.text);
    axis->setBasePen(QPen(style_.axis, 0.8));
    axis->setTickPen(QPen(style_.axis, 0.8));
    axis->setSubTickPen(QPen(style_.axis, 0.5));
    axis->setTickLength(4, 0);
    axis->setSubTickLength(2, 0);
    axis->setLabelPadding(2);
    axis->setTickLabelPadding(3);
    axis->grid()->setPen(QPen(style_.grid, 0.6));
    axis->grid()->setZeroLinePen(QPen(style_.axis, 0.5));
    axis->setNumberFormat("gb");
    axis->setNumberPrecision(5);
  }
}

QCPAxisRect* Figure::addAxesBeside() {
  auto* beside = new QCPAxisRect(this);
  addBeside(beside);
  for (QCPAxis* axis : beside->axes()) {
    axis->setLayer("axes");
    axis->grid()->setLayer("grid");
  }
  styleAxes(*beside);
  auto* margins = new QCPMarginGroup(this);
  for (QCPAxisRect* axes : {axisRect(), beside}) axes->setMarginGroup(QCP::msAll, margins);
  const auto link = [](QCPAxis* from, QCPAxis* to) {
    connect(from, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), to,
            qOverload<const QCPRange&>(&QCPAxis::setRange));
  };
  for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
    link(axisRect()->axis(side), beside->axis(side));
    link(beside->axis(side), axisRect()->axis(side));
  }
  return beside;
}

void Figure::settleLayout(QSize units) {
  const QRect before = viewport();
  setViewport(QRect(QPoint(0, 0), units));
  fitLegend(*legend, units.width(), style_.background);
  for (int pass = 0; pass < 3; ++pass) updateLayout();
  setViewport(before);
}

void Figure::setCaption(const QString& left, const QString& right) { caption_->setTexts(left, right); }

// An empty legend in the layout would limit the width of everything above and below it.
void Figure::showLegend(bool visible) {
  if (visible && !plotLayout()->hasElement(1, 0)) plotLayout()->addElement(1, 0, legend);
  if (!visible && plotLayout()->hasElement(1, 0)) plotLayout()->take(legend);
  legend->setVisible(visible);
}

// Two fast clicks are a click and a double-click: there and back.
void Figure::takeClicks() {
  const auto toggle = [this](QCPLegend*, QCPAbstractLegendItem*, QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) toggleCurve(legendEntryAt(event->pos()));
  };
  connect(this, &QCustomPlot::legendClick, this, toggle);
  connect(this, &QCustomPlot::legendDoubleClick, this, toggle);
  connect(this, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    const bool on = legendEntryAt(event->pos()) >= 0;
    if (on) setCursor(Qt::PointingHandCursor);
    if (!on && onLegend_) unsetCursor();
    onLegend_ = on;
  });
}

int Figure::legendEntryAt(const QPoint& place) const {
  if (!legend->visible()) return -1;
  for (int i = 0; i < legend->itemCount(); ++i)
    if (curveOfEntry(i) && legend->item(i)->rect().contains(place)) return i;
  return -1;
}

QCPAbstractPlottable* Figure::curveOfEntry(int entry) const {
  if (entry < 0 || entry >= legend->itemCount()) return nullptr;
  auto* item = qobject_cast<QCPPlottableLegendItem*>(legend->item(entry));
  return item ? item->plottable() : nullptr;
}

bool Figure::toggleCurve(int entry) {
  QCPAbstractPlottable* curve = curveOfEntry(entry);
  if (!curve || !legend->visible()) return false;
  setCurveVisible(*curve, !curve->visible());
  replot(rpQueuedReplot);
  return true;
}

void Figure::setCurveVisible(QCPAbstractPlottable& curve, bool visible) {
  for (int i = 0; i < plottableCount(); ++i) {
    QCPAbstractPlottable* other = plottable(i);
    const bool goesAlong = !legend->hasItemWithPlottable(other) && other->pen() == curve.pen();
    if (other == &curve || goesAlong) other->setVisible(visible);
  }
  for (const auto& [mark, marked] : marks_)
    if (mark && marked == &curve) mark->setVisible(visible);
}

}  // namespace squat::plots
