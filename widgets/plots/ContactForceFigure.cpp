#include <algorithm>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {

std::unique_ptr<Figure> contactForceFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("contact_force", style);
  const Window window = judgedWindow(result);
  const std::vector<double> position = scaled(result.position, 1e3);
  figure->xAxis->setLabel("Wheel position relative to the defect [mm]");
  figure->yAxis->setLabel("Force on the rail [kN]");
  figure->xAxis->setRange(1e3 * window.from, 1e3 * window.to);
  if (const auto* vertical = result.signal(signals::names::contactForce))
    addCurve(*figure, {position, scaled(*vertical, 1e-3), "vertical", 0, 1.2, Qt::SolidLine, true});
  else
    addNotice(*figure, "no contact force in this result");
  if (const auto* creep = result.signal(signals::names::creepForce))
    addCurve(*figure, {position, scaled(*creep, 1e-3), "longitudinal", 1, 0.9});
  for (const auto& scalar : result.equilibrium) {
    if (scalar.name != "contact_force" || position.empty()) continue;
    const double level = scalar.value * 1e-3;
    const double to = std::max(position.back(), 1e3 * window.to);
    addCurve(*figure, {{position.front(), to}, {level, level}, "static", 6, 0.7, Qt::DashLine});
  }
  fitWithZero(*figure);  // where contact is lost
  setCaption(*figure, result);
  return figure;
}

}  // namespace squat::plots
