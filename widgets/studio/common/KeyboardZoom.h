// widgets/studio/common/KeyboardZoom.h - the keys on a figure: + and - zoom, arrows move the view, Home shows all.
#pragma once

#include <QObject>
#include <QPoint>
#include <functional>
#include <optional>

#include "plots/Figure.h"

class QKeyEvent;

namespace squat::studio {

// 1: nearer (+, and = where + needs Shift), -1: farther, 0: no such key. Shift, which some keyboards need for them, is
// left to the caller.
int zoomOf(const QKeyEvent& event);
// To the right and upwards, by one; (0, 0): no arrow.
QPoint arrowOf(const QKeyEvent& event);
// In decades on a logarithmic axis.
double middleOf(const QCPAxis& axis);

// What one figure does otherwise than the others.
struct FigureKeys {
  std::function<void()> showAll{};
  std::function<std::optional<double>()> fixed{};  // place on the abscissa about which it zooms; the middle without one
  std::function<bool()> arrowsAreTaken{};          // as long as it is so, arrows do not move the view
  bool alongOnly = false;                          // the ordinate follows by itself
  std::function<bool(int key)> others{};           // keys without modifiers that the figure has for itself, true where
                                                   // it took one; with it, digits hide no curves
  QString more{};                                  // further keys, for the description
};

// + and - change the range as a notch of the wheel does: along the abscissa, with Shift along the ordinate. An arrow
// moves the view by a tenth of the range. Shows a frame where the figure has the focus, and says its keys to screen
// readers. Belongs to the figure.
class KeyboardZoom : public QObject {
  Q_OBJECT
 public:
  KeyboardZoom(plots::Figure& figure, FigureKeys keys);
  QString description() const;

 Q_SIGNALS:
  void moved();  // by keys other than Home

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool take(const QKeyEvent& event);
  void zoom(const QKeyEvent& event);
  bool pan(const QPoint& arrow);

  plots::Figure& figure_;
  FigureKeys keys_;
};

}  // namespace squat::studio
