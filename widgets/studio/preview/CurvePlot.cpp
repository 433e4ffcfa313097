#include "studio/preview/CurvePlot.h"

#include <algorithm>
#include <cmath>

namespace squat::studio {
namespace {

constexpr int paleness = 90;  // of 255

QVector<double> toQt(const std::vector<double>& values) { return {values.begin(), values.end()}; }

QPen penOf(QColor colour, double width, bool isPale) {
  if (isPale) colour.setAlpha(paleness);
  QPen pen(colour, width);
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

}  // namespace

CurvePlot::CurvePlot(const QString& name, const QString& across, const QString& up, const plots::Style& style,
                     QWidget* parent)
    : Figure(name, style, parent) {
  setAccessibleName(up);
  xAxis->setLabel(across);
  yAxis->setLabel(up);
  yAxis->setRange(-100, 100);
  setMinimumSize(150, 120);
  band_ = new QCPItemRect(this);
  band_->setLayer("background");
  for (QCPItemPosition* corner : {band_->topLeft, band_->bottomRight}) {
    corner->setTypeX(QCPItemPosition::ptPlotCoords);
    corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  band_->setPen(Qt::NoPen);
  band_->setBrush(style.band);
  band_->setSelectable(false);
  band_->setVisible(false);
  reference_ = addGraph(), before_ = addGraph(), curve_ = addGraph();
  reference_->setPen(penOf(style.muted, 1.1, false));
  before_->setPen(penOf(style.curve(0), 1, true));
  curve_->setPen(penOf(style.curve(0), 1.4, false));
  for (QCPGraph* graph : {reference_, before_, curve_}) graph->removeFromLegend();
}

void CurvePlot::setRange(double from, double to) {
  xAxis->setRange(from, to);
  xAxis2->setRange(from, to);
}

void CurvePlot::setBand(double from, double to) {
  band_->topLeft->setCoords(from, 0);
  band_->bottomRight->setCoords(to, 1);
  band_->setVisible(to > from);
}

void CurvePlot::setReference(const std::vector<double>& x, const std::vector<double>& y, const QString& label) {
  reference_->setData(toQt(x), toQt(y), true);
  reference_->removeFromLegend();
  curve_->removeFromLegend();
  const bool hasLegend = !x.empty() && !label.isEmpty();
  if (hasLegend) {
    curve_->setName(tr("preview"));
    reference_->setName(label);
    curve_->addToLegend();
    reference_->addToLegend();
  } else {
    curve_->setVisible(true), reference_->setVisible(true);  // what a legend hides, it alone shows again
  }
  showLegend(hasLegend);
  fit(isWhole_);
  replot(rpQueuedReplot);
}

void CurvePlot::setCurve(const std::vector<double>& x, const std::vector<double>& y, bool isWhole) {
  // The curve of the profile before stands until the new one is whole.
  if (isWhole_ && !isWhole) before_->data()->set(*curve_->data());
  if (isWhole) before_->data()->clear();
  isWhole_ = isWhole;
  curve_->setData(toQt(x), toQt(y), true);
  fit(isWhole);
  replot(rpQueuedReplot);
}

void CurvePlot::setStale(bool stale) {
  if (isStale_ == stale) return;
  isStale_ = stale;
  curve_->setPen(penOf(style().curve(0), 1.4, stale));
  replot(rpQueuedReplot);
}

// While the curve grows the range only widens: an axis that jumps cannot be read.
void CurvePlot::fit(bool mayShrink) {
  double low = INFINITY, high = -INFINITY;
  for (const QCPGraph* graph : {reference_, before_, curve_})
    for (const QCPGraphData& point : *graph->data()) {
      if (!std::isfinite(point.value) || !xAxis->range().contains(point.key)) continue;
      low = std::min(low, point.value), high = std::max(high, point.value);
    }
  if (!(low < high)) return;
  const double margin = 0.06 * (high - low);
  const QCPRange now = yAxis->range();
  QCPRange wanted(low - margin, high + margin);
  if (!mayShrink && isFitted_) wanted = {std::min(wanted.lower, now.lower), std::max(wanted.upper, now.upper)};
  isFitted_ = true;
  yAxis->setRange(wanted);
  yAxis2->setRange(wanted);
}

std::size_t CurvePlot::pointCount() const { return static_cast<std::size_t>(curve_->data()->size()); }

std::size_t CurvePlot::referenceCount() const { return static_cast<std::size_t>(reference_->data()->size()); }

}  // namespace squat::studio
