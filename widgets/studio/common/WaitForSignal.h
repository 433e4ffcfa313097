// widgets/studio/common/WaitForSignal.h - waits while events pass.
#pragma once

#include <QEventLoop>
#include <QTimer>

namespace squat::studio {

// Runs the event loop until the sender emits the signal, at most so many milliseconds.
template <class Sender, class Signal>
void waitForSignal(const Sender* sender, Signal signal, int milliseconds) {
  QEventLoop loop;
  QObject::connect(sender, signal, &loop, &QEventLoop::quit);
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

}  // namespace squat::studio
