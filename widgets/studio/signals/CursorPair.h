// widgets/studio/signals/CursorPair.h - two vertical lines on a figure, with their distance and its inverse.
#pragma once

#include <QObject>

#include "plots/Figure.h"

class QKeyEvent;

namespace squat::studio {

// Lines are dragged with the mouse, or moved by keys while the figure has the focus: A and B bring the first and the
// second one into the view, Ctrl with left and right moves the one moved last by a sample of the first curve (a pixel
// where there is none), with Shift by ten, Escape hides both. Shows the places, the values of the first curve there
// (not for coloured maps), both differences and 1/dt. `secondsPerUnit` turns a distance on the axis into seconds (0: no
// frequency shown): 1e-3 for an axis in ms, 1e-3/speed for one in mm.
class CursorPair : public QObject {
  Q_OBJECT
 public:
  CursorPair(plots::Figure& figure, double secondsPerUnit, const QString& unit);

  void setVisible(bool visible);
  bool isVisible() const { return visible_; }
  void setLocations(double first, double second);
  double location(int cursor) const { return locations_[cursor]; }
  bool isPlaced() const { return placed_; }
  bool isDragged() const { return dragged_ >= 0; }
  int lastMoved() const { return lastMoved_; }
  void setLastMoved(int cursor) { lastMoved_ = cursor; }
  QString text() const;

 Q_SIGNALS:
  void changed();              // what text() says, or whether it is seen
  void toggled(bool visible);  // by a key

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool take(const QKeyEvent& event);
  void bring(int cursor);
  void step(int count);
  void press(QMouseEvent* event);
  void move(QMouseEvent* event);
  void release();
  void show();
  QString valuesText() const;

  plots::Figure& figure_;
  double secondsPerUnit_;
  QString unit_;
  QCPItemStraightLine* lines_[2];
  QCPItemText* label_;
  double locations_[2] = {0, 0};
  int dragged_ = -1, lastMoved_ = 0;
  bool visible_ = false, placed_ = false;
};

}  // namespace squat::studio
