#include "case/Resolve.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {
namespace {

// Where the wheel is over the sensor, if the result says so.
void addSensor(Figure& figure, const results::RunResult& result) {
  if (!result.resolvedCase) return;
  const double location = 1e3 * result.resolvedCase->scenario.output.railAccelerometer;
  if (!figure.xAxis->range().contains(location)) return;
  auto* line = new QCPItemStraightLine(&figure);
  line->setLayer("background");
  line->point1->setCoords(location, 0);
  line->point2->setCoords(location, 1);
  line->setPen(QPen(figure.style().muted, 0.8, Qt::DashLine));
  line->setSelectable(false);
}

}  // namespace

std::unique_ptr<Figure> tracksideFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("trackside", style);
  const Window window = judgedWindow(result);
  const std::vector<double> position = scaled(result.position, 1e3);
  figure->xAxis->setLabel("Wheel position relative to the defect [mm]");
  figure->yAxis->setLabel("Vertical acceleration [m/s²]");
  figure->xAxis->setRange(1e3 * window.from, 1e3 * window.to);
  const auto* rail = result.signal(signals::names::rail);
  const auto* sleeper = result.signal(signals::names::sleeper);
  if (rail) addCurve(*figure, {position, *rail, "rail foot", 0, 0.9});
  if (sleeper) addCurve(*figure, {position, *sleeper, "nearest sleeper", 1, 1.1, Qt::SolidLine, true});
  if (!rail && !sleeper) addNotice(*figure, "no trackside sensor in this result");
  addSensor(*figure, result);
  fitValues(*figure);
  setCaption(*figure, result);
  return figure;
}

}  // namespace squat::plots
