#include "plots/CalibrationFigure.h"

#include <algorithm>
#include <cmath>

#include "plots/LineFigure.h"
#include "plots/UnitText.h"

namespace squat::plots {
namespace {

constexpr int panelColumns = 3;

void addPoints(Figure& figure, const Curve& curve, QCPScatterStyle::ScatterShape shape, double size,
               const Style& style) {
  QCPGraph* graph = addCurve(figure, curve);
  graph->setLineStyle(QCPGraph::lsNone);
  graph->setScatterStyle(QCPScatterStyle(shape, style.curve(curve.colour), style.curve(curve.colour), size));
}

std::unique_ptr<Figure> inputPanel(const calibration::Calibration& found, std::size_t input, const Style& style) {
  const auto& free = found.definition.inputs[input];
  const auto& range = found.ranges[input];
  auto figure = std::make_unique<Figure>(QString::fromStdString(free.key()), style);
  figure->xAxis->setLabel(QString::fromStdString(free.key()) +
                          (free.parameter->unit == "-" ? QString() : " [" + unitText(free.parameter->unit) + "]"));
  if (input % panelColumns == 0) figure->yAxis->setLabel("log10 of the misfit");
  const bool isFirst = input == 0;
  Curve all{{}, {}, isFirst ? "computed" : "", 7, 1.0}, good{{}, {}, isFirst ? "as good as the best" : "", 0, 1.0};
  Curve best{{}, {}, isFirst ? "best" : "", 1, 1.0};
  const auto add = [&](Curve& curve, std::size_t row) {
    curve.x.push_back(found.evaluations[row].values[input]);
    curve.y.push_back(std::log10(std::max(found.evaluations[row].misfit, 1e-6)));
  };
  for (std::size_t row = 0; row < found.evaluations.size(); ++row) {
    const auto& evaluation = found.evaluations[row];
    if (evaluation.hasFailed || evaluation.mesh != found.definition.searchMesh) continue;
    const bool isGood = std::count(found.equallyGood.begin(), found.equallyGood.end(), row) > 0;
    add(isGood ? good : all, row);
  }
  add(best, found.best);
  const double margin = 0.04 * (free.high - free.low);
  figure->xAxis->setRange(free.low - margin, free.high + margin);
  addBand(*figure, range.low, range.high);
  addPoints(*figure, all, QCPScatterStyle::ssDisc, 3, style);
  addPoints(*figure, good, QCPScatterStyle::ssDisc, 4, style);
  addPoints(*figure, best, QCPScatterStyle::ssDiamond, 8, style);
  fitValues(*figure, 0.08);
  return figure;
}

}  // namespace

FigureSheet calibrationFigure(const calibration::Calibration& found, const Style& style) {
  FigureSheet sheet{"calibration", {}, panelColumns};
  for (std::size_t input = 0; input < found.ranges.size(); ++input) {
    auto figure = inputPanel(found, input, style);
    figure->setCaption(input == 0 ? QString::fromStdString(found.definition.caseName) : QString(),
                       input == 1 ? QString::fromStdString("mesh " + found.definition.searchMesh) : QString());
    sheet.panels.push_back(std::move(figure));
  }
  return sheet;
}

}  // namespace squat::plots
