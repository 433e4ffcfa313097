#include "studio/SignalFigures.h"

#include <algorithm>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/SignalError.h"
#include "studio/PeakMarks.h"

namespace squat::studio {
namespace {

std::unique_ptr<plots::Figure> bareFigure(const QString& name, const results::RunResult& shown,
                                          const SignalSettings& settings, const plots::Style& style) {
  if (name == "aba")
    return settings.againstTime ? plots::abaTimeFigure(shown, style) : plots::abaPositionFigure(shown, style);
  if (name == "psd") return plots::psdFigure(shown, style);
  if (name == "stft") return plots::stftFigure(shown, style, settings.segment, settings.hop);
  if (name == "scalogram") return plots::scalogramFigure(*withScalogram(shown), style);
  if (name == "contact_force") return plots::contactForceFigure(shown, style);
  if (name == "contact_patch") return plots::patchFigure(shown, style);
  return plots::defectProfileFigure(shown, style);
}

void addOverlays(plots::Figure& figure, const QString& name, const results::RunResult& shown,
                 const std::vector<StoredRun>& overlays, const SignalSettings& settings) {
  std::size_t colour = 2;
  for (const StoredRun& run : overlays) {
    signals::Record other = *run.record;
    try {
      filterAnew(other, settings);
      if (name == "psd") {
        const auto spectrum = spectrumOf(other, settings);
        plots::addCurve(figure, {spectrum.frequency, spectrum.density, run.label, colour++, 0.9});
      }
    } catch (const signals::SignalError&) {
      // Shown as it was recorded, and without a spectrum.
    }
    if (name == "psd") continue;
    const auto* values = other.signal(name == "aba" ? "aba_filtered" : "contact_force");
    if (!values) continue;
    std::vector<double> x = other.position;
    if (name == "aba" && settings.againstTime) {
      const double shift = passageTime(shown) - passageTime(other);
      x = other.time;
      for (double& time : x) time += shift;
    }
    plots::addCurve(
        figure, {plots::scaled(x, 1e3), plots::scaled(*values, name == "aba" ? 1 : 1e-3), run.label, colour++, 0.9});
  }
  if (colour == 2) return;
  plots::fitValues(figure);
  constexpr double roomForNames = 1.12;  // of the peaks, as in the figure of one run
  if (name == "psd") figure.yAxis->setRange(0, roomForNames * figure.yAxis->range().upper);
  if (name == "contact_force") plots::keepZeroInSight(figure);
}

}  // namespace

double passageTime(const signals::Record& result) {
  if (result.time.empty() || result.position.empty() || !(result.speed > 0)) return 0;
  return result.time.front() - result.position.front() / result.speed;
}

std::unique_ptr<plots::Figure> signalFigure(const QString& name, const results::RunResult& shown,
                                            const std::vector<StoredRun>& overlays, const SignalSettings& settings,
                                            const plots::Style& style) {
  auto figure = bareFigure(name, shown, settings, style);
  if (name == "aba" || name == "psd" || name == "contact_force") addOverlays(*figure, name, shown, overlays, settings);
  if (name == "aba" && shown.signal("aba_filtered")) markExtremes(*figure, settings.againstTime ? "ms" : "mm");
  if (name == "contact_force" && shown.signal("contact_force")) markExtremes(*figure, "mm");
  if (name == "stft" || name == "scalogram") markLines(*figure, "mm");
  return figure;
}

QByteArray patchTable(const results::RunResult& result) {
  const results::PatchSnapshot* patch = plots::shownPatch(result);
  if (!patch) return {};
  QByteArray text = "along [m],across [m],pressure [Pa],traction along [Pa],traction across [Pa],slips\n";
  for (std::size_t i = 0; i < patch->pressure.size(); ++i) {
    const auto at = [i](const std::vector<float>& values) {
      return i < values.size() ? QByteArray::number(values[i], 'g', 7) : QByteArray();
    };
    text += at(patch->x) + ',' + at(patch->y) + ',' + at(patch->pressure) + ',' + at(patch->tractionX) + ',' +
            at(patch->tractionY) + ',' + (i < patch->slipping.size() && patch->slipping[i] ? "1\n" : "0\n");
  }
  return text;
}

}  // namespace squat::studio
