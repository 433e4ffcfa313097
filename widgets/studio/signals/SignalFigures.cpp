#include "studio/signals/SignalFigures.h"

#include "signals/SignalError.h"
#include "studio/signals/PeakMarks.h"

namespace squat::studio {

plots::FigureSettings figureSettings(const plots::FigureRow& row, const std::vector<StoredRun>& overlays,
                                     const SignalSettings& settings) {
  plots::FigureSettings chosen;
  chosen.segment = settings.segment;
  chosen.hop = settings.hop;
  chosen.spectrum = settings.spectrum;
  chosen.section = settings.to - settings.from;
  chosen.patch = settings.moment;
  if (!row.overlay) return chosen;
  for (const StoredRun& run : overlays) {
    auto record = std::make_shared<signals::Record>(*run.record);
    signals::PowerSpectrum spectrum;
    try {
      filterAnew(*record, settings);
      spectrum = spectrumOf(*record, settings);
    } catch (const signals::SignalError&) {
      // Shown as it was recorded, and without a spectrum.
    }
    chosen.overlays.push_back({std::move(record), std::move(spectrum),
                               project::nameWithGain(run.label.toStdString(), run.reading), run.colourIndex,
                               run.colour});
  }
  return chosen;
}

std::unique_ptr<plots::Figure> signalFigure(const std::string& name, const results::RunResult& shown,
                                            const std::vector<StoredRun>& overlays, const SignalSettings& settings,
                                            const plots::Style& style) {
  const plots::FigureRow& row = plots::figureRow(name);
  const auto chosen = figureSettings(row, overlays, settings);
  auto figure = row.drawsScalogram ? plots::buildFigure(row, *withScalogram(shown), style, chosen)
                                   : plots::buildFigure(row, shown, style, chosen);
  const auto unit = QString::fromStdString(plots::unitOf(row.axis));
  if (row.marks == plots::FigureMarks::extremes && row.applies(shown)) markExtremes(*figure, unit);
  if (row.marks == plots::FigureMarks::lines) markLines(*figure, unit);
  return figure;
}

}  // namespace squat::studio
