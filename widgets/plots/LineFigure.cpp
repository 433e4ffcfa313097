#include "plots/LineFigure.h"
#include "plots/ShownStretch.h"

#include <algorithm>
#include <cmath>

#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

constexpr const char* nameOfNotices = "notice";

}  // namespace

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> result(values);
  for (double& value : result) value *= factor;
  return result;
}

QCPGraph* addCurve(Figure& figure, const Curve& curve) {
  QCPGraph* graph = figure.addGraph();
  const std::size_t count = std::min(curve.x.size(), curve.y.size());
  QVector<double> x(curve.x.begin(), curve.x.begin() + static_cast<std::ptrdiff_t>(count));
  QVector<double> y(curve.y.begin(), curve.y.begin() + static_cast<std::ptrdiff_t>(count));
  // Sorted data stay in their order: a grinding has two values at one tonnage.
  graph->setData(x, y, std::is_sorted(x.begin(), x.end()));
  // Thinning out shows as steps on steep slopes; only long records need it.
  constexpr std::size_t manyPoints = 30000;
  graph->setAdaptiveSampling(count > manyPoints);
  QPen pen(curve.own.isValid() ? curve.own : figure.style().curve(curve.colour), curve.width, curve.line);
  pen.setJoinStyle(Qt::RoundJoin);
  graph->setPen(pen);
  graph->setName(curve.label);
  if (curve.front) graph->setLayer("front");
  if (curve.label.isEmpty())
    graph->removeFromLegend();
  else
    figure.showLegend(true);
  return graph;
}

void addBand(Figure& figure, double from, double to) {
  auto* band = new QCPItemRect(&figure);
  band->setLayer("background");
  band->topLeft->setTypeX(QCPItemPosition::ptPlotCoords);
  band->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
  band->bottomRight->setTypeX(QCPItemPosition::ptPlotCoords);
  band->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
  band->topLeft->setCoords(from, 0);
  band->bottomRight->setCoords(to, 1);
  band->setPen(Qt::NoPen);
  band->setBrush(figure.style().band);
  band->setSelectable(false);
}

QCPItemText* addPointLabel(Figure& figure, double x, double y, const QString& text, Qt::AlignmentFlag side) {
  auto* label = new QCPItemText(&figure);
  label->setPositionAlignment(side | Qt::AlignBottom);
  label->position->setCoords(x, y);
  label->setPadding(QMargins(0, 0, 0, 3));
  label->setFont(figure.style().tickFont());
  label->setColor(figure.style().text);
  label->setText(text);
  label->setSelectable(false);
  return label;
}

QCPItemText* addNotice(Figure& figure, const QString& text) {
  auto* label = new QCPItemText(&figure);
  label->position->setType(QCPItemPosition::ptAxisRectRatio);
  label->position->setCoords(0.5, 0.5);
  label->setFont(figure.style().tickFont());
  label->setObjectName(nameOfNotices);
  label->setColor(figure.style().muted);
  label->setBrush(figure.style().background);
  label->setPadding(QMargins(4, 2, 4, 2));
  label->setText(text);
  label->setSelectable(false);
  return label;
}

void clearNotices(Figure& figure) {
  for (int i = figure.itemCount() - 1; i >= 0; --i)
    if (figure.item(i)->objectName() == nameOfNotices) figure.removeItem(i);
}

bool holdsNothing(Figure& figure) {
  for (int i = 0; i < figure.plottableCount(); ++i) {
    bool found = false;
    static_cast<void>(figure.plottable(i)->getKeyRange(found));
    if (found) return false;
  }
  return true;
}

void showEmpty(Figure& figure, const QString& nextStep) {
  for (QCPAxisRect* axes : figure.axisRects())  // one that is hidden itself hides the words
    for (QCPAxis* axis : axes->axes()) axis->setVisible(false), axis->grid()->setVisible(false);
  for (int i = 0; i < figure.itemCount(); ++i) figure.item(i)->setVisible(false);
  figure.setCaption({}, {});
  figure.showLegend(false);
  QCPItemText* words = addNotice(figure, nextStep);
  words->setFont(figure.style().labelFont());
  words->position->setType(QCPItemPosition::ptViewportRatio);
  words->position->setCoords(0.5, 0.5);
  words->setClipToAxisRect(false);
}

void fitValues(Figure& figure, double margin) {
  const QCPRange keys = figure.xAxis->range();
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < figure.graphCount(); ++i) {
    for (const QCPGraphData& point : *figure.graph(i)->data()) {
      if (!std::isfinite(point.value) || !keys.contains(point.key)) continue;
      low = std::min(low, point.value);
      high = std::max(high, point.value);
    }
  }
  if (!(low <= high)) low = -1, high = 1;
  double span = high - low;
  if (span <= 1e-9 * std::max(std::abs(low), std::abs(high)) || span <= 0)
    span = std::max(1e-9, 0.1 * std::max(std::abs(low), std::abs(high)));
  figure.yAxis->setRange(low - margin * span, high + margin * span);
}

void keepZeroInSight(Figure& figure) {
  const QCPRange range = figure.yAxis->range();
  figure.yAxis->setRange(std::min(range.lower, 0.0), std::max(range.upper, 0.0));
}

void fitWithZero(Figure& figure) {
  fitValues(figure);
  keepZeroInSight(figure);
}

void fitDensity(Figure& figure) {
  fitValues(figure);
  constexpr double roomForNames = 1.12;  // of the peaks
  figure.yAxis->setRange(0, roomForNames * figure.yAxis->range().upper);
}

QString noteOfLeftSide(const results::AnalysedRecord& result) {
  return signals::hasRightSide(result) ? QStringLiteral("left side: ") : QString();
}

void setCaption(Figure& figure, const results::AnalysedRecord& result, ShownSide side) {
  QString left = QString::fromStdString(result.title.empty() ? result.stem : result.title);
  // In front, where a narrow figure does not cut it off.
  if (side == ShownSide::left) left = noteOfLeftSide(result) + left;
  if (!result.complete)
    left = QStringLiteral("incomplete (%1): ").arg(QString::fromStdString(result.stopReason)) + left;
  figure.setCaption(left, QString::fromStdString(result.stem + "  " + result.caseHash));
}

Extent defectExtent(const results::RunResult& result) {
  const std::size_t count = std::min(result.profilePosition.size(), result.profileHeight.size());
  double deepest = 0;
  for (std::size_t i = 0; i < count; ++i) deepest = std::max(deepest, std::abs(result.profileHeight[i]));
  Extent extent;
  bool found = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(std::abs(result.profileHeight[i]) > 0.005 * deepest)) continue;
    if (!found) extent.from = result.profilePosition[i];
    found = true;
    extent.to = result.profilePosition[i];
  }
  return extent;
}

Window judgedWindow(const results::AnalysedRecord& result) {
  if (result.psdTo > result.psdFrom) return {result.psdFrom, result.psdTo};
  if (result.position.size() > 1 && result.position.back() > result.position.front())
    return {result.position.front(), result.position.back()};
  return {-shownBefore, shownAfter};
}

}  // namespace squat::plots
