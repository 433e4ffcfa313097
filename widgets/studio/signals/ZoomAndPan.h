// widgets/studio/signals/ZoomAndPan.h - the mouse on a figure: the left button draws a box that is enlarged, the middle
// button moves the view, the wheel zooms.
#pragma once

#include <QObject>

#include "plots/Figure.h"

namespace squat::studio {

class CursorPair;

class ZoomAndPan : public QObject {
  Q_OBJECT
 public:
  // A cursor that is dragged has the left button for itself. Belongs to the figure.
  ZoomAndPan(plots::Figure& figure, const CursorPair& cursors);

  // [pixels] A flat box zooms along its long side alone; a tiny one does nothing.
  void zoomTo(const QRect& box);

 private:
  void press(QMouseEvent* event);
  void move(QMouseEvent* event);

  plots::Figure& figure_;
  const CursorPair& cursors_;
  QPoint last_;
  bool panning_ = false;
};

}  // namespace squat::studio
