// widgets/studio/common/FocusFrame.h - a frame that shows that keys go to what is drawn within it.
#pragma once

#include <QWidget>

namespace squat::studio {

// For widgets that paint themselves, which Qt gives no frame. Belongs to the widget, lies on it and takes no mouse; a
// picture that the widget draws of itself is without it.
class FocusFrame : public QWidget {
  Q_OBJECT
 public:
  explicit FocusFrame(QWidget& framed);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void fit();
};

}  // namespace squat::studio
