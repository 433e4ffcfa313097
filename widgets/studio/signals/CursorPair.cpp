#include "studio/signals/CursorPair.h"

#include <QMouseEvent>
#include <cmath>

namespace squat::studio {
namespace {

// Not-a-number outside the first curve, and where the first one is no curve but single points.
double valueOn(const plots::Figure& figure, double location) {
  if (figure.graphCount() == 0 || figure.graph(0)->lineStyle() == QCPGraph::lsNone) return NAN;
  const auto data = figure.graph(0)->data();
  const auto after = data->findBegin(location, false);
  if (after == data->constEnd() || after == data->constBegin()) return NAN;
  const auto before = after - 1;
  const double span = after->key - before->key;
  return span > 0 ? before->value + (after->value - before->value) * (location - before->key) / span : after->value;
}

}  // namespace

CursorPair::CursorPair(plots::Figure& figure, double secondsPerUnit, const QString& unit)
    : QObject(&figure), figure_(figure), secondsPerUnit_(secondsPerUnit), unit_(unit) {
  for (auto& line : lines_) {
    line = new QCPItemStraightLine(&figure_);
    line->setPen(QPen(figure_.style().curve(3), 1.2));
    line->setSelectable(false);
    line->setVisible(false);
  }
  label_ = new QCPItemText(&figure_);
  label_->position->setType(QCPItemPosition::ptAxisRectRatio);
  label_->position->setCoords(0.01, 0.015);
  label_->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  label_->setTextAlignment(Qt::AlignLeft);
  label_->setFont(figure_.style().tickFont());
  label_->setColor(figure_.style().text);
  QColor ground = figure_.style().background;
  ground.setAlpha(215);
  label_->setBrush(ground);
  label_->setPadding(QMargins(4, 2, 4, 2));
  label_->setSelectable(false);
  label_->setVisible(false);
  connect(&figure_, &QCustomPlot::mousePress, this, &CursorPair::press);
  connect(&figure_, &QCustomPlot::mouseMove, this, &CursorPair::move);
  connect(&figure_, &QCustomPlot::mouseRelease, this, &CursorPair::release);
}

void CursorPair::setVisible(bool visible) {
  visible_ = visible;
  if (visible && !placed_) {
    const QCPRange range = figure_.xAxis->range();
    setLocations(range.lower + 0.4 * range.size(), range.lower + 0.6 * range.size());
  }
  show();
}

void CursorPair::setLocations(double first, double second) {
  locations_[0] = first;
  locations_[1] = second;
  placed_ = true;
  show();
}

QString CursorPair::text() const {
  const double distance = std::abs(locations_[1] - locations_[0]);
  QString text = tr("%1 and %2 %4, Δ = %3 %4")
                     .arg(locations_[0], 0, 'f', 2)
                     .arg(locations_[1], 0, 'f', 2)
                     .arg(distance, 0, 'f', 2)
                     .arg(unit_);
  if (secondsPerUnit_ > 0 && distance > 0)
    text += tr(", 1/Δt = %1 Hz").arg(1 / (distance * secondsPerUnit_), 0, 'f', 1);
  return text + valuesText();
}

QString CursorPair::valuesText() const {
  for (int i = 0; i < figure_.plottableCount(); ++i)
    if (qobject_cast<const QCPColorMap*>(figure_.plottable(i))) return {};
  const double first = valueOn(figure_, locations_[0]), second = valueOn(figure_, locations_[1]);
  if (!std::isfinite(first) || !std::isfinite(second)) return {};
  return tr("\nvalues %1 and %2, Δ = %3").arg(first, 0, 'g', 4).arg(second, 0, 'g', 4).arg(second - first, 0, 'g', 4);
}

void CursorPair::show() {
  for (int i = 0; i < 2; ++i) {
    lines_[i]->point1->setCoords(locations_[i], 0);
    lines_[i]->point2->setCoords(locations_[i], 1);
    lines_[i]->point2->setTypeY(QCPItemPosition::ptAxisRectRatio);
    lines_[i]->point1->setTypeY(QCPItemPosition::ptAxisRectRatio);
    lines_[i]->setVisible(visible_);
  }
  label_->setText(text());
  label_->setVisible(visible_);
  figure_.replot(QCustomPlot::rpQueuedReplot);
}

void CursorPair::press(QMouseEvent* event) {
  if (!visible_ || event->button() != Qt::LeftButton) return;
  constexpr double reach = 6;  // pixels
  for (int i = 0; i < 2; ++i)
    if (std::abs(figure_.xAxis->coordToPixel(locations_[i]) - event->position().x()) < reach) dragged_ = i;
}

void CursorPair::move(QMouseEvent* event) {
  if (dragged_ < 0) return;
  locations_[dragged_] = figure_.xAxis->pixelToCoord(event->position().x());
  show();
}

void CursorPair::release() { dragged_ = -1; }

}  // namespace squat::studio
