#include "case/Resolve.h"
#include "plots/CatalogueFigure.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"

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
  return catalogueFigure("trackside", result, style, [&](Figure& figure) { addSensor(figure, result); });
}

}  // namespace squat::plots
