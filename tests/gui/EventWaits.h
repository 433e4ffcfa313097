// tests/gui/EventWaits.h - how long events of the window's thread wait, and a drag that keeps previews restarting.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <vector>

namespace squat::studio {
class MainWindow;
}

namespace squat::tests {

double threadMilliseconds();  // processor time of this thread

// From its making to stop(): a pulse every 5 ms, how late each one comes, and what processor time each turn of the
// event loop has taken. Other programs make pulses late, not turns long.
class EventWaits {
 public:
  EventWaits();
  void stop() { pulse_.stop(); }
  double late(double share) const;           // [ms] percentile, 0..1
  double processorTime(double share) const;  // [ms]
  void print(const char* what) const;

 private:
  QTimer pulse_;
  QElapsedTimer clock_;
  double used_ = 0;
  std::vector<double> late_, busy_;
};

// Changes the depth of the defect every 50 ms as a slider does. Returns how many pictures the preview has shown.
int dragAtTwentyChangesASecond(studio::MainWindow& window, int milliseconds);

}  // namespace squat::tests
