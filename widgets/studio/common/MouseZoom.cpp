#include "studio/common/MouseZoom.h"

#include <QMouseEvent>
#include <utility>

namespace squat::studio {
namespace {

// What stood at `from` stands at `to` afterwards.
void shift(QCPAxis& axis, double from, double to) {
  const double before = axis.pixelToCoord(from), after = axis.pixelToCoord(to);
  if (axis.scaleType() == QCPAxis::stLogarithmic)
    axis.setRange(axis.range() * (before / after));
  else
    axis.moveRange(before - after);
}

}  // namespace

MouseZoom::MouseZoom(plots::Figure& figure, std::function<bool()> leftIsTaken)
    : QObject(&figure), figure_(figure), leftIsTaken_(std::move(leftIsTaken)) {
  figure_.setInteractions(QCP::iRangeZoom);
  QCPSelectionRect* box = figure_.selectionRect();
  QColor colour = figure_.style().curve(0);
  box->setPen(QPen(colour, 1));
  colour.setAlpha(40);
  box->setBrush(colour);
  connect(&figure_, &QCustomPlot::mousePress, this, &MouseZoom::press);  // after those who take the left button
  connect(&figure_, &QCustomPlot::mouseMove, this, &MouseZoom::move);
  connect(&figure_, &QCustomPlot::mouseRelease, this, [this] { panning_ = false; });
  connect(box, &QCPSelectionRect::accepted, this, [this](const QRect& rect) { zoomTo(rect.normalized()); });
}

// The plot begins a box after this, where it is in the mode for it.
void MouseZoom::press(QMouseEvent* event) {
  axes_ = figure_.axisRectAt(event->pos());
  const bool within = axes_ && axes_->rect().contains(event->pos());
  const bool boxes = within && event->button() == Qt::LeftButton && !(leftIsTaken_ && leftIsTaken_());
  figure_.setSelectionRectMode(boxes ? QCP::srmCustom : QCP::srmNone);
  panning_ = within && event->button() == Qt::MiddleButton;
  last_ = event->pos();
}

void MouseZoom::move(QMouseEvent* event) {
  if (!panning_ || !axes_) return;
  shift(*axes_->axis(QCPAxis::atBottom), last_.x(), event->pos().x());
  shift(*axes_->axis(QCPAxis::atLeft), last_.y(), event->pos().y());
  last_ = event->pos();
  figure_.replot(QCustomPlot::rpQueuedReplot);
}

void MouseZoom::zoomTo(const QRect& drawn) {
  constexpr int thin = 8;  // [pixels]
  if (!axes_) axes_ = figure_.axisRect();
  const QRect box = drawn & axes_->rect();
  if (box.width() < thin && box.height() < thin) return;
  const auto zoom = [](QCPAxis& axis, int low, int high) {
    axis.setRange(QCPRange(axis.pixelToCoord(low), axis.pixelToCoord(high)));
  };
  if (box.width() >= thin) zoom(*axes_->axis(QCPAxis::atBottom), box.left(), box.right());
  if (box.height() >= thin) zoom(*axes_->axis(QCPAxis::atLeft), box.bottom(), box.top());
  figure_.replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace squat::studio
