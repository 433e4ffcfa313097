#include "studio/runs/LivePlot.h"

#include <QHBoxLayout>

namespace squat::studio {

LivePlot::LivePlot(const plots::Style& style, QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  makePlots(style);
}

void LivePlot::makePlots(const plots::Style& style) {
  delete acceleration_;
  delete force_;
  const auto make = [&](const QString& name, const QString& label, std::size_t colour) {
    auto* plot = new plots::Figure(name, style, this);
    plot->setAccessibleName(label);
    plot->xAxis->setLabel(tr("Wheel position [mm]"));
    plot->yAxis->setLabel(label);
    plot->xAxis->setRange(-100, 200);  // until there is a curve: about what a run will show
    plot->yAxis->setRange(colour == 0 ? -100 : 0, 100);
    plot->addGraph();
    plot->graph(0)->setPen(QPen(style.curve(colour), 1.2));
    plot->setMinimumSize(180, 95);
    layout()->addWidget(plot);
    return plot;
  };
  acceleration_ = make("live_acceleration", tr("ABA [m/s²]"), 0);
  force_ = make("live_force", tr("Force [kN]"), 1);
}

void LivePlot::clear() {
  samples_.clear();
  for (plots::Figure* plot : {acceleration_, force_}) {
    plot->graph(0)->setData(QVector<double>(), QVector<double>());
    plot->replot(QCustomPlot::rpQueuedReplot);
  }
}

void LivePlot::add(const std::vector<LiveSample>& samples) {
  if (samples.empty()) return;
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  for (const LiveSample& sample : samples) {
    acceleration_->graph(0)->addData(sample.accelerationPosition * 1e3, sample.axleBoxAcceleration);
    force_->graph(0)->addData(sample.position * 1e3, sample.contactForce * 1e-3);
  }
  for (plots::Figure* plot : {acceleration_, force_}) {
    plot->rescaleAxes();
    plot->yAxis->scaleRange(1.1);
    plot->replot(QCustomPlot::rpQueuedReplot);
  }
}

void LivePlot::setStyle(const plots::Style& style) {
  const std::vector<LiveSample> kept = std::move(samples_);
  samples_.clear();
  makePlots(style);
  add(kept);
}

}  // namespace squat::studio
