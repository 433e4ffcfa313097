// What a project keeps of the signals panel: how figures are drawn, and what of them is enlarged.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <array>
#include <cmath>

#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

struct Unit {
  QString shown;  // on the axis
  double factor;  // to the unit in the file
  QString kept;
};

// What is not listed is SI already, or a level in dB.
Unit unitOfAxis(const QCPAxis& axis) {
  static const std::array units{Unit{"mm", 1e-3, "m"}, Unit{"µm", 1e-6, "m"}, Unit{"ms", 1e-3, "s"},
                                Unit{"kN", 1e3, "N"}, Unit{"MPa", 1e6, "Pa"}};
  const QString shown = axis.label().section('[', 1).section(']', 0, 0);
  for (const auto& unit : units)
    if (unit.shown == shown) return unit;
  return {shown, 1, shown};
}

// Nine digits, so that what was read is written the same.
double rounded(double value) { return QString::number(value, 'g', 9).toDouble(); }

std::optional<project::AxisRange> keptRange(const QCPAxis& axis, const QCPRange& whole) {
  if (axis.range() == whole) return std::nullopt;
  const Unit unit = unitOfAxis(axis);
  const project::AxisRange kept{rounded(axis.range().lower * unit.factor), rounded(axis.range().upper * unit.factor),
                                unit.kept.toStdString()};
  const bool canBeRead = std::isfinite(kept.low) && std::isfinite(kept.high) && kept.low < kept.high;
  return canBeRead ? std::optional(kept) : std::nullopt;
}

project::FigureRange keptRange(const QString& name, const FigureView& view) {
  project::FigureRange kept{name.toStdString(), {}, {}};
  if (!view.figure()) return kept;
  kept.x = keptRange(*view.figure()->xAxis, view.wholeX());
  kept.y = keptRange(*view.figure()->yAxis, view.wholeY());
  return kept;
}

// Where there is something to see, beyond what is seen without zoom as well.
QCPRange extentOf(plots::Figure& figure, const QCPAxis* axis, QCPRange extent) {
  for (int i = 0; i < figure.plottableCount(); ++i) {
    const QCPAbstractPlottable* drawn = figure.plottable(i);
    bool found = false;
    const QCPRange range = drawn->keyAxis() == axis ? drawn->getKeyRange(found) : drawn->getValueRange(found);
    if (found) extent.expand(range);
  }
  return extent;
}

// Nothing where the axis has got another unit, or the data have gone elsewhere.
std::optional<QCPRange> rangeOn(const QCPAxis& axis, const std::optional<project::AxisRange>& kept,
                                const QCPRange& extent) {
  const Unit unit = unitOfAxis(axis);
  if (!kept || kept->unit != unit.kept.toStdString()) return std::nullopt;
  const QCPRange range(kept->low / unit.factor, kept->high / unit.factor);
  return range.lower < extent.upper && range.upper > extent.lower ? std::optional(range) : std::nullopt;
}

void showRange(FigureView& view, const project::FigureRange& kept) {
  plots::Figure& figure = *view.figure();
  const auto x = rangeOn(*figure.xAxis, kept.x, extentOf(figure, figure.xAxis, view.wholeX()));
  const auto y = rangeOn(*figure.yAxis, kept.y, extentOf(figure, figure.yAxis, view.wholeY()));
  if (kept.x && !x) return;
  if (x) figure.xAxis->setRange(*x);
  if (y) figure.yAxis->setRange(*y);
  figure.replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace

project::FigureViews SignalsPanel::views() const {
  project::FigureViews views{settings_, {}};
  if (waitingMoment_ >= 0) views.settings.moment = waitingMoment_;
  for (const auto& [name, view] : views_) {
    const auto waiting = waitingRanges_.find(name);
    auto range = waiting == waitingRanges_.end() ? keptRange(name, *view) : waiting->second;
    if (linked_ && isLinked(name) && name != linkedFrom_) range.x.reset();  // it follows the one that was zoomed
    if (range.x || range.y) views.ranges.push_back(std::move(range));
  }
  return views;
}

void SignalsPanel::setViews(const project::FigureViews& views, const QString& run) {
  const auto& settings = views.settings;
  const std::initializer_list<QWidget*> controls{cutoff_, map_, window_, from_, to_, spectrum_, segment_, hop_};
  for (QWidget* each : controls) each->blockSignals(true);
  cutoff_->setValue(settings.cutoff);
  map_->setCurrentText(QString::fromStdString(settings.colours));
  window_->setCurrentText(QString::fromStdString(settings.window));
  if (const auto& section = settings.section) from_->setValue(section->from * 1e3), to_->setValue(section->to * 1e3);
  spectrum_->setCurrentIndex(static_cast<int>(settings.spectrum));
  segment_->setValue(static_cast<int>(settings.segment)), hop_->setValue(static_cast<int>(settings.hop));
  for (QWidget* each : controls) each->blockSignals(false);
  forgetRanges();
  for (const auto& range : views.ranges)
    if (const QString name = QString::fromStdString(range.figure); views_.contains(name)) waitingRanges_[name] = range;
  windowOf_ = run, waitingMoment_ = settings.moment;
  update();
}

void SignalsPanel::forgetRanges() {
  linked_.reset(), waitingRanges_.clear();
  for (const auto& [name, view] : views_) view->forgetZoom();
}

// Of a project, once the run is read; what its fields are needed for waits for these.
void SignalsPanel::takeRanges() {
  if (!store_.currentResult() && store_.overlays().empty()) return;
  for (const auto& [name, range] : std::map(waitingRanges_)) {
    if (!applies(plots::figureRow(name.toStdString()))) continue;
    waitingRanges_.erase(name);
    rebuild(name);
    showRange(*views_.at(name), range);
  }
}

}  // namespace squat::studio
