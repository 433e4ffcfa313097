#include <algorithm>
#include <cmath>

#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"

namespace squat::plots {
namespace {

bool fits(const results::PermanentChange& change) {
  const std::size_t across = change.position.size() * change.lateral.size();
  const std::size_t down = change.position.size() * change.depth.size();
  return across > 0 && down > 0 && change.height.size() == across && change.equivalentStrain.size() == down &&
         change.stressAlong.size() == down && change.stressAcross.size() == down;
}

const char* const notice = "no plastic flow in this result (rail.plastic)";

// Values of one column of a field of position x width.
std::vector<double> column(const std::vector<double>& field, std::size_t width, std::size_t at) {
  std::vector<double> values;
  for (std::size_t i = at; i < field.size(); i += width) values.push_back(field[i]);
  return values;
}

// Smallest value of each row.
std::vector<double> lowestAcross(const std::vector<double>& field, std::size_t width) {
  std::vector<double> values;
  for (std::size_t i = 0; i < field.size(); i += width)
    values.push_back(*std::min_element(field.begin() + static_cast<std::ptrdiff_t>(i),
                                       field.begin() + static_cast<std::ptrdiff_t>(i + width)));
  return values;
}

}  // namespace

std::unique_ptr<Figure> permanentChangeFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("permanent_change", style);
  figure->xAxis->setLabel("Position along the rail [mm]");
  figure->yAxis->setLabel("Height change [µm]");
  setCaption(*figure, result);
  const auto& change = result.permanent;
  if (!fits(change)) {
    addNotice(*figure, notice);
    return figure;
  }
  const std::vector<double> x = scaled(change.position, 1e3);
  figure->xAxis->setRange(x.front(), x.back());
  if (const Extent defect = defectExtent(result); !defect.empty()) addBand(*figure, 1e3 * defect.from, 1e3 * defect.to);
  const auto middle = std::min_element(change.lateral.begin(), change.lateral.end(),
                                       [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto centre = static_cast<std::size_t>(middle - change.lateral.begin());
  addCurve(*figure, {x, scaled(lowestAcross(change.height, change.lateral.size()), 1e6), "minimum across the rail", 1,
                     0.9, Qt::DashLine});
  addCurve(*figure, {x, scaled(column(change.height, change.lateral.size(), centre), 1e6), "centre line", 0, 1.2});
  fitValues(*figure, 0.08);
  return figure;
}

std::unique_ptr<Figure> residualStressFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("residual_stress", style);
  figure->xAxis->setLabel("Residual stress [MPa]");
  figure->yAxis->setLabel("Depth [mm]");
  figure->yAxis->setRangeReversed(true);
  setCaption(*figure, result);
  const auto& change = result.permanent;
  if (!fits(change)) {
    addNotice(*figure, notice);
    return figure;
  }
  const std::size_t width = change.depth.size();
  const auto maximum = std::max_element(change.equivalentStrain.begin(), change.equivalentStrain.end());
  const std::size_t row = static_cast<std::size_t>(maximum - change.equivalentStrain.begin()) / width;
  const auto first = static_cast<std::ptrdiff_t>(row * width), last = static_cast<std::ptrdiff_t>(row * width + width);
  const std::vector<double> depth = scaled(change.depth, 1e3);
  double low = 0, high = 0;
  const auto profile = [&](const std::vector<double>& stress, const QString& label, std::size_t colour) {
    const std::vector<double> values = scaled({stress.begin() + first, stress.begin() + last}, 1e-6);
    low = std::min(low, *std::min_element(values.begin(), values.end()));
    high = std::max(high, *std::max_element(values.begin(), values.end()));
    auto* curve = new QCPCurve(figure->xAxis, figure->yAxis);  // depth is no function of stress
    for (std::size_t i = 0; i < width; ++i) curve->addData(values[i], depth[i]);
    curve->setPen(QPen(style.curve(colour), 1.1));
    curve->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 3.5));
    curve->setName(label);
    figure->showLegend(true);
  };
  profile(change.stressAlong, "along the rail", 0);
  profile(change.stressAcross, "across the rail", 1);
  const double margin = 0.08 * std::max(high - low, 1.0);
  figure->xAxis->setRange(low - margin, high + margin);
  figure->yAxis->setRange(0, depth.back());
  figure->setCaption(
      QStringLiteral("unloaded, y = 0, at %1 mm (maximum plastic strain)").arg(1e3 * change.position[row], 0, 'f', 0),
      QString::fromStdString(result.stem + "  " + result.caseHash));
  return figure;
}

}  // namespace squat::plots
