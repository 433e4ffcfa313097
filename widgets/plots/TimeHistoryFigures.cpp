#include <algorithm>
#include <cmath>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

// "axle box: 106 / -92" - largest and smallest value within the shown stretch.
QString labelWithExtremes(const QString& label, const std::vector<double>& x, const std::vector<double>& y, double from,
                          double to) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (x[i] < from || x[i] > to || !std::isfinite(y[i])) continue;
    low = std::min(low, y[i]);
    high = std::max(high, y[i]);
  }
  if (!(low <= high)) return label;
  return QStringLiteral("%1 (%2 … %3)")
      .arg(label, QString::number(low, 'f', 0).replace('-', QChar(0x2212)),
           QString::number(high, 'f', 0).replace('-', QChar(0x2212)));
}

void addAccelerations(Figure& figure, const results::RunResult& result, const std::vector<double>& x, double from,
                      double to) {
  const auto* wheel = result.signal(signals::names::wheelFiltered);
  const auto* box = result.signal(signals::names::axleBoxFiltered);
  if (!box) box = result.signal(signals::names::axleBox);
  // Short enough for two columns of the legend, also where a whole bogie has four axle boxes.
  const bool isWhole = signals::hasRightSide(result);
  const char *ofBox = isWhole ? "axle box, left" : "axle box", *ofWheel = isWhole ? "wheel, left" : "wheel centre";
  if (box) addCurve(figure, {x, *box, labelWithExtremes(ofBox, x, *box, from, to), 0, 1.2, Qt::SolidLine, true});
  if (wheel) addCurve(figure, {x, *wheel, labelWithExtremes(ofWheel, x, *wheel, from, to), 1, 0.8});
  // Of a whole model, behind the left side.
  if (const auto* right = result.signal(signals::filteredNameOnRight(signals::names::axleBox)))
    addCurve(figure, {x, *right, labelWithExtremes("axle box, right", x, *right, from, to), 2, 0.9});
  // Of a bogie.
  const auto* second = result.signal(signals::names::secondAxleBoxFiltered);
  const auto* secondRight = result.signal(signals::filteredNameOnRight(signals::names::secondAxleBox));
  const char* name = secondRight ? "second, left" : "second wheelset";
  if (second) addCurve(figure, {x, *second, labelWithExtremes(name, x, *second, from, to), 3, 0.9});
  if (secondRight)
    addCurve(figure, {x, *secondRight, labelWithExtremes("second, right", x, *secondRight, from, to), 4, 0.9});
  if (!box && !wheel) addNotice(figure, "no acceleration in this result");
  figure.xAxis->setRange(from, to);
  figure.yAxis->setLabel("Vertical acceleration [m/s²]");
  fitValues(figure);
  setCaption(figure, result);
}

}  // namespace

std::unique_ptr<Figure> abaPositionFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("aba_position", style);
  const Window window = judgedWindow(result);
  figure->xAxis->setLabel("Wheel position relative to the defect [mm]");
  const Extent defect = defectExtent(result);
  if (!defect.empty()) addBand(*figure, 1e3 * defect.from, 1e3 * defect.to);
  addAccelerations(*figure, result, scaled(result.position, 1e3), 1e3 * window.from, 1e3 * window.to);
  return figure;
}

std::unique_ptr<Figure> abaTimeFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("aba_time", style);
  figure->xAxis->setLabel("Time since the start of rolling [ms]");
  const double from = result.time.empty() ? 0 : 1e3 * result.time.front();
  const double to = result.time.size() < 2 ? from + 1 : 1e3 * result.time.back();
  addAccelerations(*figure, result, scaled(result.time, 1e3), from, to);
  return figure;
}

}  // namespace squat::plots
