#include "studio/common/KeyboardZoom.h"

#include <QKeyEvent>
#include <cmath>
#include <utility>

#include "studio/common/FocusFrame.h"

namespace squat::studio {
namespace {

constexpr double stepOfView = 0.1;  // share of the range

bool hasDecades(const QCPAxis& axis) { return axis.scaleType() == QCPAxis::stLogarithmic; }

void moveView(QCPAxis& axis, int steps) {
  const QCPRange range = axis.range();
  const double share = stepOfView * (axis.rangeReversed() ? -steps : steps);
  if (hasDecades(axis))
    axis.setRange(range * std::pow(range.upper / range.lower, share));
  else
    axis.moveRange(share * range.size());
}

Qt::KeyboardModifiers modifiersOf(const QKeyEvent& event) { return event.modifiers() & ~Qt::KeypadModifier; }

}  // namespace

int zoomOf(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return 1;
    case Qt::Key_Asterisk:  // + with Shift on many keyboards
      return modifiersOf(event) == Qt::ShiftModifier ? 1 : 0;
    case Qt::Key_Minus:
    case Qt::Key_Underscore:  // - with Shift
      return -1;
    default:
      return 0;
  }
}

QPoint arrowOf(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Left:
      return {-1, 0};
    case Qt::Key_Right:
      return {1, 0};
    case Qt::Key_Up:
      return {0, 1};
    case Qt::Key_Down:
      return {0, -1};
    default:
      return {};
  }
}

double middleOf(const QCPAxis& axis) {
  const QCPRange range = axis.range();
  return hasDecades(axis) ? range.upper * std::sqrt(range.lower / range.upper) : range.center();
}

KeyboardZoom::KeyboardZoom(plots::Figure& figure, FigureKeys keys)
    : QObject(&figure), figure_(figure), keys_(std::move(keys)) {
  figure_.setFocusPolicy(Qt::StrongFocus);
  figure_.setAccessibleDescription(description());
  figure_.installEventFilter(this);
  new FocusFrame(figure_);
}

QString KeyboardZoom::description() const {
  const QString view = keys_.alongOnly
                           ? tr("Plus and minus zoom, left and right move the view, Home shows the whole.")
                           : tr("Plus and minus zoom along the horizontal axis, with Shift along the vertical one; "
                                "arrow keys move the view, Home shows all.");
  QStringList all{view};
  if (!keys_.more.isEmpty()) all << keys_.more;
  if (!keys_.others) all << tr("Digits hide and show the curves of the legend.");
  return all.join(' ');
}

bool KeyboardZoom::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !take(static_cast<QKeyEvent&>(*event))) return false;
  event->accept();
  return true;
}

bool KeyboardZoom::take(const QKeyEvent& event) {
  const auto modifiers = modifiersOf(event);
  if (event.key() == Qt::Key_Home && !modifiers) {
    keys_.showAll();
    return true;
  }
  if (!modifiers && keys_.others && keys_.others(event.key())) return true;
  if (!modifiers && !keys_.others && event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9)
    return figure_.toggleCurve(event.key() - Qt::Key_1);
  if (zoomOf(event) != 0 && !(modifiers & ~Qt::ShiftModifier))
    zoom(event);
  else if (modifiers || !pan(arrowOf(event)))
    return false;
  Q_EMIT moved();
  figure_.replot(QCustomPlot::rpQueuedReplot);
  return true;
}

void KeyboardZoom::zoom(const QKeyEvent& event) {
  const bool up = !keys_.alongOnly && modifiersOf(event) & Qt::ShiftModifier;
  QCPAxis& axis = up ? *figure_.yAxis : *figure_.xAxis;
  const double notch = figure_.axisRect()->rangeZoomFactor(axis.orientation());
  const auto fixed = up || !keys_.fixed ? std::nullopt : keys_.fixed();
  axis.scaleRange(zoomOf(event) > 0 ? notch : 1 / notch,
                  fixed && axis.range().contains(*fixed) ? *fixed : middleOf(axis));
}

bool KeyboardZoom::pan(const QPoint& arrow) {
  if (arrow.isNull() || (arrow.y() != 0 && keys_.alongOnly)) return false;
  if (keys_.arrowsAreTaken && keys_.arrowsAreTaken()) return false;
  if (arrow.x() != 0) moveView(*figure_.xAxis, arrow.x());
  if (arrow.y() != 0) moveView(*figure_.yAxis, arrow.y());
  return true;
}

}  // namespace squat::studio
