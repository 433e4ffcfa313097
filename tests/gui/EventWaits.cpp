#include "gui/EventWaits.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "studio/window/MainWindow.h"

namespace squat::tests {
namespace {

constexpr int pulseEvery = 5, changeEvery = 50;  // [ms]

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

double threadMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

EventWaits::EventWaits() : used_(threadMilliseconds()) {
  pulse_.setTimerType(Qt::PreciseTimer);
  QObject::connect(&pulse_, &QTimer::timeout, [this] {
    const double now = threadMilliseconds();
    late_.push_back(std::max(0.0, 1e-6 * static_cast<double>(clock_.nsecsElapsed()) - pulseEvery));
    busy_.push_back(now - used_);
    used_ = now;
    clock_.restart();
  });
  clock_.start();
  pulse_.start(pulseEvery);
}

double EventWaits::late(double share) const { return percentile(late_, share); }

double EventWaits::processorTime(double share) const { return percentile(busy_, share); }

void EventWaits::print(const char* what) const {
  std::printf("%s, %zu turns of the event loop:\n", what, late_.size());
  std::printf("  an event waits    50 %% %.1f, 99 %% %.1f, largest %.1f ms\n", late(0.5), late(0.99), late(1));
  std::printf("  processor time    50 %% %.1f, 99 %% %.1f, largest %.1f ms a turn\n", processorTime(0.5),
              processorTime(0.99), processorTime(1));
}

int dragAtTwentyChangesASecond(studio::MainWindow& window, int milliseconds) {
  int shown = 0, step = 0;
  const auto watch = QObject::connect(&window.preview(), &studio::PreviewController::changed, [&] { ++shown; });
  QTimer hand;
  hand.setTimerType(Qt::PreciseTimer);
  const int gesture = window.document().newGesture();
  QObject::connect(&hand, &QTimer::timeout, [&] {
    auto after = window.document().description();
    after.defect.depth = 1e-4 * (1.5 + std::sin(0.1 * ++step));
    window.document().edit("Drag", after, gesture);
  });
  hand.start(changeEvery);
  QTest::qWait(milliseconds);
  hand.stop();
  QObject::disconnect(watch);
  return shown;
}

}  // namespace squat::tests
