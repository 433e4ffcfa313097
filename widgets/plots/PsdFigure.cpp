#include <algorithm>
#include <cmath>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/Features.h"

namespace squat::plots {
namespace {

constexpr double shownUpTo = 2500;  // [Hz] a little beyond the filter's cut-off

// The lines that the tables name, at the same frequencies.
std::vector<signals::SpectralPeak> linesOf(const results::AnalysedRecord& result) {
  if (result.frequency.size() < 3 || result.psd.size() != result.frequency.size()) return {};
  signals::PowerSpectrum spectrum;
  spectrum.frequency = result.frequency;
  spectrum.density = result.psd;
  return signals::namedLines(spectrum);
}

// Labels of near lines of about the same height stand back to back, so that they do not touch.
void addLineLabels(Figure& figure, const std::vector<signals::SpectralPeak>& lines) {
  const double wide = 0.08 * figure.xAxis->range().size(), high = 0.08 * figure.yAxis->range().size();
  for (const auto& line : lines) {
    auto side = Qt::AlignHCenter;
    for (const auto& other : lines) {
      const double apart = line.frequency - other.frequency;
      if (apart == 0 || std::abs(apart) > wide || std::abs(line.density - other.density) > high) continue;
      side = apart > 0 ? Qt::AlignLeft : Qt::AlignRight;
    }
    addPointLabel(figure, line.frequency, line.density, QString::number(line.frequency, 'f', 0), side);
  }
}

}  // namespace

std::unique_ptr<Figure> psdFigure(const results::AnalysedRecord& result, const Style& style) {
  auto figure = std::make_unique<Figure>("psd", style);
  figure->xAxis->setLabel("Frequency [Hz]");
  figure->yAxis->setLabel("PSD [(m/s²)²/Hz]");
  if (result.frequency.size() < 2 || result.psd.size() != result.frequency.size())
    addNotice(*figure, "no spectrum in this result");
  addCurve(*figure, {result.frequency, result.psd, result.psdWheel.empty() ? QString() : QString("axle box"), 0, 1.2,
                     Qt::SolidLine, true});
  if (result.psdWheel.size() == result.frequency.size() && !result.psdWheel.empty())
    addCurve(*figure, {result.frequency, result.psdWheel, "wheel centre", 1, 0.8});
  const double top = result.frequency.empty() ? shownUpTo : std::min(shownUpTo, result.frequency.back());
  figure->xAxis->setRange(0, std::max(top, 1.0));
  fitDensity(*figure);
  addLineLabels(*figure, linesOf(result));
  setCaption(*figure, result);
  return figure;
}

}  // namespace squat::plots
