#include "studio/common/FocusFrame.h"

#include <QEvent>
#include <QPainter>
#include <QRegion>

namespace squat::studio {

FocusFrame::FocusFrame(QWidget& framed) : QWidget(&framed) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  framed.installEventFilter(this);
  setVisible(framed.hasFocus());
  fit();
}

bool FocusFrame::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize) fit();
  if (event->type() == QEvent::FocusIn) {
    raise();
    show();
  } else if (event->type() == QEvent::FocusOut) {
    hide();
  }
  return false;
}

// The mask spares the widget a repaint of what lies within.
void FocusFrame::fit() {
  constexpr int width = 2;  // [pixels]
  setGeometry(parentWidget()->rect());
  setMask(QRegion(rect()) - QRegion(rect().adjusted(width, width, -width, -width)));
}

void FocusFrame::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), palette().highlight()); }

}  // namespace squat::studio
