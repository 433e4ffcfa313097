#include "plots/AnalysisFigures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "analysis/AnalysisFiles.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "plots/ShownStretch.h"
#include "plots/UnitText.h"
#include "signals/Resample.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

constexpr double windowSeconds = 0.01;  // of the short-time transform, as the analysis takes it

QString titleOf(const analysis::SignalAnalysis& signal) {
  const auto stem = std::filesystem::path(signal.file).stem().string();
  return QString::fromStdString(signal.run.empty()               ? stem
                                : signal.run.rfind(stem, 0) == 0 ? signal.run
                                                                 : stem + ": " + signal.run);
}

std::string distinct(std::string name, std::set<std::string>& taken) {
  const std::string wanted = name;
  for (int number = 2; !taken.insert(name).second; ++number) name = wanted + "_" + std::to_string(number);
  return name;
}

QString locationLabel() { return "Position relative to the impact [mm]"; }

QString percentText(const signals::Dispersion& dispersion) {
  return std::isfinite(dispersion.mean) ? QString::number(100 * dispersion.range, 'f', 0) : QStringLiteral("-");
}

QString quantityLabel(const std::string& unit) {
  return (unit == "m/s2" ? QStringLiteral("Acceleration [%1]") : QStringLiteral("Signal [%1]")).arg(unitText(unit));
}

}  // namespace

results::AnalysedRecord aroundImpact(const analysis::SignalAnalysis& signal) {
  results::AnalysedRecord record;
  record.title = titleOf(signal).toStdString();
  record.complete = true;
  record.speed = signal.features.speed;
  record.frequency = signal.features.spectrum.frequency;
  record.psd = signal.features.spectrum.density;
  record.scalogramFrequency = signal.scalogram.frequency;
  record.scalogramTime = signal.scalogram.time;
  record.scalogramPosition = signal.scalogramPosition;
  record.scalogramPower = signal.scalogram.power;
  record.coneOfInfluence = signal.scalogram.coneOfInfluence;
  const auto& series = signal.filtered;
  const auto& position = signal.passage.position;
  const double zero = signals::positionAtTime(signal.passage, signal.features.impactTime);
  const double margin = 0.5 * windowSeconds * record.speed;
  results::Channel aba{signals::names::axleBoxFiltered, series.unit, "", {}};
  for (std::size_t i = 0; i < std::min(position.size(), series.values.size()); ++i) {
    const double fromImpact = position[i] - zero;
    if (fromImpact < -shownBefore - margin || fromImpact > shownAfter + margin) continue;
    record.time.push_back(series.timeAt(i));
    record.position.push_back(fromImpact);
    aba.values.push_back(series.values[i]);
  }
  if (!record.position.empty()) {
    record.psdFrom = std::max(-shownBefore, record.position.front());
    record.psdTo = std::min(shownAfter, record.position.back());
  }
  record.signals.push_back(std::move(aba));
  return record;
}

std::unique_ptr<Figure> historyFigure(const analysis::SignalAnalysis& signal, const Style& style) {
  auto figure = std::make_unique<Figure>("history", style);
  const auto& series = signal.filtered;
  const double end = series.timeAt(series.values.size() - 1);
  // Short records in ms, as the paper's; long ones in s.
  const bool isShort = end - series.start < 2;
  std::vector<double> time(series.values.size());
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = (isShort ? 1e3 : 1.0) * series.timeAt(i);
  figure->xAxis->setLabel(isShort ? "Time [ms]" : "Time [s]");
  figure->yAxis->setLabel(quantityLabel(series.unit));
  figure->xAxis->setRange(time.front(), std::max(time.back(), time.front() + 1e-9));
  addCurve(*figure, {time, series.values, QString(), 0, 0.9});
  fitValues(*figure);
  figure->setCaption(titleOf(signal),
                     QStringLiteral("peak %1 %2").arg(signal.features.peak, 0, 'g', 4).arg(unitText(series.unit)));
  return figure;
}

std::unique_ptr<Figure> scatterFigure(const signals::AlignedRuns& runs, const std::string& unit, const Style& style) {
  auto figure = std::make_unique<Figure>("scatter", style);
  const auto axis = scaled(runs.axis, 1e3);
  figure->xAxis->setLabel(runs.inPosition ? locationLabel() : QString("Time relative to the impact [ms]"));
  figure->yAxis->setLabel(quantityLabel(unit));
  const double speed = runs.speed.empty() || runs.inPosition ? 1.0 : std::max(1e-3, runs.speed.front());
  if (!axis.empty())
    figure->xAxis->setRange(std::max(axis.front(), -1e3 * shownBefore / speed),
                            std::min(axis.back(), 1e3 * shownAfter / speed));
  QCPGraph* low = addCurve(*figure, {axis, runs.lowest, QString()});
  low->setPen(Qt::NoPen);
  QCPGraph* high = addCurve(*figure, {axis, runs.highest, "minimum to maximum"});
  QColor fill = style.curve(0);
  fill.setAlpha(60);
  high->setPen(QPen(fill, 0.5));
  high->setBrush(fill);
  high->setChannelFillGraph(low);
  for (std::size_t run = 0; run < runs.values.size(); ++run)
    addCurve(*figure, {axis, runs.values[run], QString(), 1 + run, 0.5});
  addCurve(*figure,
           {axis, runs.mean, QStringLiteral("mean of %1 runs").arg(runs.values.size()), 0, 1.3, Qt::SolidLine, true});
  fitValues(*figure);
  return figure;
}

std::vector<FigureSheet> analysisFigures(const analysis::Analysis& analysis, const Style& style) {
  std::vector<FigureSheet> sheets;
  std::set<std::string> taken;
  for (const auto& signal : analysis.signals) {
    const std::string stem =
        distinct(analysis::safeFileName(signal.run.empty() ? std::string("signal") : signal.run), taken);
    const auto record = aroundImpact(signal);
    sheets.push_back(sheetOf(stem + "_history", historyFigure(signal, style)));
    auto density = psdFigure(record, style);
    density->yAxis->setLabel(QStringLiteral("PSD [(%1)²/Hz]").arg(unitText(signal.filtered.unit)));
    density->setCaption(titleOf(signal),
                        "around the " + QString::fromStdString(signals::toText(signal.features.anchor)) + ": Hann");
    sheets.push_back(sheetOf(stem + "_psd", std::move(density)));
    // A stretch that is short for the window gets half of itself: poor in frequency, but a picture.
    const double wanted = signal.stft ? static_cast<double>(signal.stft->segment)
                                      : std::max(16.0, windowSeconds * signal.filtered.rate());
    const auto segment = std::min(static_cast<std::size_t>(wanted), std::max<std::size_t>(16, record.time.size() / 2));
    sheets.push_back(sheetOf(stem + "_stft", stftFigure(record, style, segment)));
    sheets.push_back(sheetOf(stem + "_scalogram", signal.scalogramByAmplitude ? amplitudeScalogramFigure(record, style)
                                                                              : scalogramFigure(record, style)));
    for (std::size_t back = 1; back <= 2; ++back)
      sheets[sheets.size() - back].panels.front()->xAxis->setLabel(locationLabel());
  }
  for (const auto* runs : {&analysis.inTime, &analysis.inPosition}) {
    if (!*runs) continue;
    const auto& unit = analysis.signals.front().filtered.unit;
    auto figure = scatterFigure(**runs, unit, style);
    QString right;
    if (analysis.dispersion)
      right = QStringLiteral("range / mean: largest peak %1 %, wavelength %2 %")
                  .arg(percentText(analysis.dispersion->largestPeak), percentText(analysis.dispersion->wavelength));
    figure->setCaption("repeated runs, aligned at the impact", right);
    sheets.push_back(sheetOf((*runs)->inPosition ? "scatter_position" : "scatter_time", std::move(figure)));
  }
  return sheets;
}

}  // namespace squat::plots
