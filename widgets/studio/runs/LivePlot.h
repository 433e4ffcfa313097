// widgets/studio/runs/LivePlot.h - axle box acceleration and contact force while the run goes on.
#pragma once

#include <QWidget>
#include <vector>

#include "plots/Figure.h"
#include "studio/runs/WorkerMonitor.h"

namespace squat::studio {

class LivePlot : public QWidget {
  Q_OBJECT
 public:
  explicit LivePlot(const plots::Style& style, QWidget* parent = nullptr);

  void clear();
  void add(const std::vector<LiveSample>& samples);
  void setStyle(const plots::Style& style);
  int sampleCount() const { return static_cast<int>(samples_.size()); }

 private:
  void makePlots(const plots::Style& style);
  plots::Figure *acceleration_ = nullptr, *force_ = nullptr;
  std::vector<LiveSample> samples_;
};

}  // namespace squat::studio
