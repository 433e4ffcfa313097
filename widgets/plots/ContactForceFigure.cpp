#include <algorithm>

#include "plots/CatalogueFigure.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "signals/SignalCatalogue.h"

namespace squat::plots {

// With the force at rest.
std::unique_ptr<Figure> contactForceFigure(const results::RunResult& result, const Style& style) {
  return catalogueFigure("contact_force", result, style, [&](Figure& figure) {
    for (const auto& scalar : result.equilibrium) {
      if (scalar.name != "contact_force" || result.position.empty()) continue;
      const double level = scalar.value * 1e-3,
                   to = std::max(1e3 * result.position.back(), figure.xAxis->range().upper);
      const char* label = signals::hasRightSide(result) ? "static, left" : "static";
      addCurve(figure, {{1e3 * result.position.front(), to}, {level, level}, label, 6, 0.7, Qt::DashLine});
    }
  });
}

}  // namespace squat::plots
