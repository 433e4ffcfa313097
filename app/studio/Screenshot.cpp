#include "studio/Screenshot.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QThread>

#include "studio/comparison/ComparisonWindow.h"
#include "studio/project/RunReader.h"
#include "studio/window/MainWindow.h"

namespace squat::studio {

bool runFirst(MainWindow& window) {
  window.show();
  window.startRun();
  constexpr int patience = 24 * 3600 * 1000;  // [ms]
  window.controller().waitFor(patience);
  const ResultPointer result = window.store().currentResult();
  return result && result->complete;
}

bool takeScreenshot(MainWindow& window, const QString& path) {
  window.show();
  constexpr int patience = 600 * 1000;  // [ms]
  window.reader()->waitFor(patience);
  window.preview().waitFor(patience);
  // Queued replots and late layouts are done after a few turns of the event loop.
  QElapsedTimer clock;
  clock.start();
  constexpr int settling = 700;  // [ms]
  while (clock.elapsed() < settling) {
    QApplication::processEvents(QEventLoop::AllEvents, 50);
    QThread::msleep(10);
  }
  QWidget* front = window.comparison()->isVisible() ? static_cast<QWidget*>(window.comparison()) : &window;
  return front->grab().save(path, "PNG");
}

}  // namespace squat::studio
