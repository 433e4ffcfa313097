#include "studio/signals/CursorPair.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "studio/common/KeyboardZoom.h"

namespace squat::studio {
namespace {

// The first that is not hidden; nothing where that is no curve but single points.
QSharedPointer<QCPGraphDataContainer> firstCurve(const plots::Figure& figure) {
  for (int i = 0; i < figure.graphCount(); ++i)
    if (figure.graph(i)->visible())
      return figure.graph(i)->lineStyle() == QCPGraph::lsNone ? nullptr : figure.graph(i)->data();
  return {};
}

// Not-a-number outside the first curve.
double valueOn(const plots::Figure& figure, double location) {
  const auto data = firstCurve(figure);
  if (!data) return NAN;
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
  figure_.installEventFilter(this);
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
  Q_EMIT changed();
}

// Escape would close some of the windows around the figure.
bool CursorPair::eventFilter(QObject*, QEvent* event) {
  const bool asked = event->type() == QEvent::ShortcutOverride;
  if (!asked && event->type() != QEvent::KeyPress) return false;
  const auto& key = static_cast<QKeyEvent&>(*event);
  if (asked ? !visible_ || key.key() != Qt::Key_Escape : !take(key)) return false;
  event->accept();
  return true;
}

bool CursorPair::take(const QKeyEvent& event) {
  const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
  const bool plain = !modifiers, tenfold = modifiers & Qt::ShiftModifier;
  const int side = arrowOf(event).x();
  if (plain && (event.key() == Qt::Key_A || event.key() == Qt::Key_B)) {
    bring(event.key() == Qt::Key_A ? 0 : 1);
  } else if (visible_ && plain && event.key() == Qt::Key_Escape) {
    setVisible(false);
    Q_EMIT toggled(false);
  } else if (visible_ && side != 0 && (modifiers & ~Qt::ShiftModifier) == Qt::ControlModifier) {
    step(tenfold ? 10 * side : side);
  } else {
    return false;
  }
  return true;
}

void CursorPair::bring(int cursor) {
  const bool seen = visible_;
  if (!seen) setVisible(true);
  if (!seen || !figure_.xAxis->range().contains(locations_[cursor])) locations_[cursor] = middleOf(*figure_.xAxis);
  lastMoved_ = cursor;
  show();
  if (!seen) Q_EMIT toggled(true);
}

void CursorPair::step(int count) {
  double& location = locations_[lastMoved_];
  const auto data = firstCurve(figure_);
  if (data && !data->isEmpty()) {
    const auto next = data->findBegin(location, false);  // the sample at the cursor, else the one behind it
    const bool between = next == data->constEnd() || next->key > location;
    const auto index = static_cast<int>(next - data->constBegin()) + count - (between && count > 0 ? 1 : 0);
    location = data->at(std::clamp(index, 0, data->size() - 1))->key;
  } else {
    location = figure_.xAxis->pixelToCoord(figure_.xAxis->coordToPixel(location) + count);
  }
  show();
}

void CursorPair::press(QMouseEvent* event) {
  if (!visible_ || event->button() != Qt::LeftButton) return;
  constexpr double reach = 6;  // pixels
  for (int i = 0; i < 2; ++i)
    if (std::abs(figure_.xAxis->coordToPixel(locations_[i]) - event->position().x()) < reach) dragged_ = lastMoved_ = i;
}

void CursorPair::move(QMouseEvent* event) {
  if (dragged_ < 0) return;
  locations_[dragged_] = figure_.xAxis->pixelToCoord(event->position().x());
  show();
}

void CursorPair::release() { dragged_ = -1; }

}  // namespace squat::studio
