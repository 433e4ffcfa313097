#include "plots/GrowthFigures.h"

#include <algorithm>
#include <cmath>

#include "plots/LineFigure.h"

namespace squat::plots {

namespace {

constexpr double perMillion = 1 / growth::kilogramsInMegatonne, millimetres = 1e3, micrometres = 1e6;
constexpr std::size_t profiles = 5;

using growth::Growth;
using growth::Stage;

std::vector<double> tonnages(const Growth& growth) {
  std::vector<double> t;
  for (const auto& stage : growth.stages) t.push_back(perMillion * stage.tonnage);
  return t;
}

std::vector<double> valuesOf(const Growth& growth, double Stage::*value, double scale) {
  std::vector<double> values;
  for (const auto& stage : growth.stages) values.push_back(scale * stage.*value);
  return values;
}

// Heights of a stage along the line nearest to the running line [mm].
std::vector<double> profileOf(const Growth& growth, std::size_t stage) {
  std::size_t line = 0;
  for (std::size_t i = 0; i < growth.y.size(); ++i)
    if (std::abs(growth.y[i] - growth.line) < std::abs(growth.y[line] - growth.line)) line = i;
  std::vector<double> heights;
  for (std::size_t s = 0; s < growth.x.size(); ++s)
    heights.push_back(millimetres * growth.shapes[stage][s * growth.y.size() + line]);
  return heights;
}

// Stages nearest to equal steps of tonnage.
std::vector<std::size_t> shownStages(const Growth& growth) {
  std::vector<std::size_t> shown;
  const double end = growth.stages.back().tonnage;
  for (std::size_t k = 0; k < profiles; ++k) {
    const double wanted = end * static_cast<double>(k) / (profiles - 1);
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < growth.stages.size(); ++i)
      if (std::abs(growth.stages[i].tonnage - wanted) <= std::abs(growth.stages[nearest].tonnage - wanted)) nearest = i;
    if (shown.empty() || shown.back() != nearest) shown.push_back(nearest);
  }
  return shown;
}

std::unique_ptr<Figure> profileFigure(const Growth& growth, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_profiles"), style);
  figure->xAxis->setLabel(QStringLiteral("Position [mm]"));
  figure->yAxis->setLabel(QStringLiteral("Height [mm]"));
  const auto x = scaled(growth.x, millimetres);
  std::size_t colour = 0;
  for (const std::size_t stage : shownStages(growth))
    addCurve(*figure, {x, profileOf(growth, stage),
                       QStringLiteral("%1 Mt").arg(perMillion * growth.stages[stage].tonnage, 0, 'g', 3), colour++});
  figure->xAxis->setRange(x.front(), x.back());
  fitValues(*figure);
  return figure;
}

std::unique_ptr<Figure> changeMap(const Growth& growth, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_change"), style);
  figure->xAxis->setLabel(QStringLiteral("Position [mm]"));
  figure->yAxis->setLabel(QStringLiteral("Across the rail [mm]"));
  auto* map = new QCPColorMap(figure->xAxis, figure->yAxis);
  const auto columns = static_cast<int>(growth.x.size()), rows = 61;
  const double from = growth.y.front(), to = growth.y.back();
  map->data()->setSize(columns, rows);
  map->data()->setRange({millimetres * growth.x.front(), millimetres * growth.x.back()},
                        {millimetres * from, millimetres * to});
  double largest = 0;
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row) {
      const double x = growth.x.front() + column * (growth.x.back() - growth.x.front()) / (columns - 1);
      const double y = from + row * (to - from) / (rows - 1);
      const auto s = std::clamp<std::ptrdiff_t>(
          std::lower_bound(growth.x.begin(), growth.x.end(), x) - growth.x.begin(), 0, columns - 1);
      const auto upper =
          std::clamp<std::ptrdiff_t>(std::upper_bound(growth.y.begin(), growth.y.end(), y) - growth.y.begin(), 1,
                                     static_cast<std::ptrdiff_t>(growth.y.size()) - 1);
      const double t = (y - growth.y[upper - 1]) / (growth.y[upper] - growth.y[upper - 1]);
      const auto changeAt = [&](std::ptrdiff_t line) {
        const auto i = static_cast<std::size_t>(s) * growth.y.size() + static_cast<std::size_t>(line);
        return micrometres * (growth.shapes.back()[i] - growth.shapes.front()[i]);
      };
      const double change = (1 - t) * changeAt(upper - 1) + t * changeAt(upper);
      map->data()->setCell(column, row, change);
      largest = std::max(largest, std::abs(change));
    }
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorStopAt(0, QColor(33, 102, 172));
  gradient.setColorStopAt(0.5, QColor(247, 247, 247));
  gradient.setColorStopAt(1, QColor(178, 24, 43));
  auto* scale = new QCPColorScale(figure.get());
  figure->addBeside(scale);
  scale->setType(QCPAxis::atRight);
  scale->setBarWidth(8);
  scale->setGradient(gradient);
  map->setColorScale(scale);
  scale->axis()->setLabel(QStringLiteral("Change of height [µm]"));
  scale->axis()->setLabelFont(style.labelFont());
  scale->axis()->setTickLabelFont(style.tickFont());
  scale->axis()->setLabelColor(style.text);
  scale->axis()->setTickLabelColor(style.text);
  scale->axis()->setNumberFormat("gb");
  map->setDataRange({-std::max(largest, 1e-3), std::max(largest, 1e-3)});
  figure->xAxis->setRange(millimetres * growth.x.front(), millimetres * growth.x.back());
  figure->yAxis->setRange(millimetres * from, millimetres * to);
  return figure;
}

std::unique_ptr<Figure> depthFigure(const Growth& growth, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_depth"), style);
  figure->xAxis->setLabel(QStringLiteral("Traffic [Mt]"));
  figure->yAxis->setLabel(QStringLiteral("Depth [mm]"));
  const auto t = tonnages(growth);
  addCurve(*figure, {t, valuesOf(growth, &Stage::depth, millimetres), QStringLiteral("dip"), 0, 1.5});
  addCurve(*figure, {t, valuesOf(growth, &Stage::waveHeight, millimetres), QStringLiteral("wave, crest to valley"), 1});
  addCurve(*figure,
           {t, valuesOf(growth, &Stage::wearAround, millimetres), QStringLiteral("wear around"), 2, 1.0, Qt::DashLine});
  addCurve(*figure, {t, valuesOf(growth, &Stage::flow, millimetres), QStringLiteral("flow at the deepest place"), 3,
                     1.0, Qt::DashLine});
  figure->xAxis->setRange(0, std::max(t.back(), 1e-6));
  fitValues(*figure);
  keepZeroInSight(*figure);
  return figure;
}

std::unique_ptr<Figure> responseFigure(const Growth& growth, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_response"), style);
  figure->xAxis->setLabel(QStringLiteral("Traffic [Mt]"));
  figure->yAxis->setLabel(QStringLiteral("Peak ABA [m/s²], force [kN]"));
  const auto t = tonnages(growth);
  addCurve(*figure,
           {t, valuesOf(growth, &Stage::peakAcceleration, 1), QStringLiteral("axle box acceleration"), 0, 1.5});
  addCurve(*figure, {t, valuesOf(growth, &Stage::largestForce, 1e-3), QStringLiteral("largest contact force"), 1});
  addCurve(*figure, {t, valuesOf(growth, &Stage::smallestForce, 1e-3), QStringLiteral("smallest contact force"), 2});
  figure->xAxis->setRange(0, std::max(t.back(), 1e-6));
  fitWithZero(*figure);
  return figure;
}

}  // namespace

FigureSheet growthFigure(const Growth& growth, const std::string& stem, const Style& style) {
  FigureSheet sheet{stem + "_growth", {}, 2};
  sheet.panels.push_back(profileFigure(growth, style));
  sheet.panels.push_back(changeMap(growth, style));
  sheet.panels.push_back(depthFigure(growth, style));
  sheet.panels.push_back(responseFigure(growth, style));
  for (auto& panel : sheet.panels) panel->setCaption(QString::fromStdString(growth.description.title), {});
  alignAxes(sheet);
  return sheet;
}

}  // namespace squat::plots
