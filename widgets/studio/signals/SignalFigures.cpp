#include "studio/signals/SignalFigures.h"

#include "analysis/SignalViews.h"
#include "signals/SignalError.h"
#include "studio/signals/PeakMarks.h"

namespace squat::studio {

namespace {

std::vector<plots::OverlaidRun> seenThrough(const analysis::FigureSettings& settings, const results::RunResult& shown,
                                            const std::vector<StoredRun>& runs) {
  std::vector<plots::OverlaidRun> overlays;
  for (const StoredRun& run : runs) {
    auto record = std::make_shared<signals::Record>(*run.record);
    signals::PowerSpectrum spectrum;
    try {
      analysis::filterPartners(*record, settings.cutoff);
      spectrum = analysis::sectionSpectrum(
          *record, settings.section.value_or(analysis::Section{shown.psdFrom, shown.psdTo}), settings.window);
    } catch (const signals::SignalError&) {
      // Shown as it was recorded, and without a spectrum.
    }
    overlays.push_back({std::move(record), std::move(spectrum),
                        project::nameWithGain(run.label.toStdString(), run.reading), run.colourIndex, run.colour});
  }
  return overlays;
}

}  // namespace

std::unique_ptr<plots::Figure> signalFigure(const std::string& name, const results::RunResult& shown,
                                            const std::vector<StoredRun>& overlays,
                                            const analysis::FigureSettings& settings, const plots::Style& style) {
  const plots::FigureRow& row = plots::figureRow(name);
  const auto over = row.overlay ? seenThrough(settings, shown, overlays) : std::vector<plots::OverlaidRun>();
  auto figure = row.drawsScalogram ? plots::buildFigure(row, *analysis::withScalogram(shown), style, settings, over)
                                   : plots::buildFigure(row, shown, style, settings, over);
  const auto unit = QString::fromStdString(plots::unitOf(row.axis));
  if (row.marks == plots::FigureMarks::extremes && row.applies(shown)) markExtremes(*figure, unit);
  if (row.marks == plots::FigureMarks::lines) markLines(*figure, unit);
  return figure;
}

void showNextStep(plots::Figure& figure, bool hasOverlays, bool isComing) {
  if (!plots::holdsNothing(figure)) return plots::clearNotices(figure);
  plots::showEmpty(figure, isComing      ? QObject::tr("The run is being read")
                           : hasOverlays ? QObject::tr("This figure is drawn of runs:\nrun the case (F5)")
                                         : QObject::tr("Run the case (F5),\noverlay a measured signal (Ctrl+M)\n"
                                                       "or open a result (Ctrl+Shift+O)"));
}

}  // namespace squat::studio
