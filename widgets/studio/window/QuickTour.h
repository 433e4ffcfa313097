// widgets/studio/window/QuickTour.h - shows a newcomer the parts of the window, one after the other.
#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace squat::studio {

// A card with a few sentences beside the part that they are about, which is outlined. Nothing is blocked: the window
// can be used meanwhile. Escape ends the tour; closing the card deletes it.
class QuickTour : public QFrame {
  Q_OBJECT
 public:
  struct Stop {
    QString title, words;
    std::function<QWidget*()> part;  // brings the part to the front and returns it
  };
  // Shows the first stop at once; a child of the window.
  QuickTour(std::vector<Stop> stops, QWidget& window);

  int stop() const { return stop_; }
  int stops() const { return static_cast<int>(all_.size()); }
  void go(int stop);  // to one behind the last: ends

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeCard();
  void settle();  // beside the part, inside the window
  void end();

  std::vector<Stop> all_;
  QWidget& window_;
  QPointer<QFrame> outline_;
  QLabel *title_, *words_, *count_;
  QPushButton *back_, *next_;
  QPointer<QWidget> part_, focusBefore_;
  int stop_ = 0;
};

}  // namespace squat::studio
