// widgets/studio/common/MouseZoom.h - the mouse on a figure: the left button draws a box that is enlarged, the middle
// button moves the view, the wheel zooms.
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>

#include "plots/Figure.h"

namespace squat::studio {

class MouseZoom : public QObject {
  Q_OBJECT
 public:
  // While `leftIsTaken` says so, the left button draws no box: it drags a cursor, say. Belongs to the figure.
  explicit MouseZoom(plots::Figure& figure, std::function<bool()> leftIsTaken = {});

  // [pixels] A flat box zooms along its long side alone; a tiny one does nothing. Of the axes that were pressed last,
  // where the figure has two beside each other.
  void zoomTo(const QRect& box);

 private:
  void press(QMouseEvent* event);
  void move(QMouseEvent* event);

  plots::Figure& figure_;
  QPointer<QCPAxisRect> axes_;
  std::function<bool()> leftIsTaken_;
  QPoint last_;
  bool panning_ = false;
};

}  // namespace squat::studio
