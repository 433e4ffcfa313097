#include "plots/GrowthFigures.h"

#include <algorithm>
#include <cmath>
#include <functional>

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

// Between sorted values: index of the one before `at` and the share of the way to the next.
struct Between {
  std::size_t index;
  double share;
};
Between placeIn(const std::vector<double>& sorted, double at) {
  const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(sorted.begin(), sorted.end(), at) - sorted.begin(), 1,
                                               static_cast<std::ptrdiff_t>(sorted.size()) - 1);
  const auto before = static_cast<std::size_t>(next - 1);
  const double step = sorted[before + 1] - sorted[before];
  return {before, step > 0 ? std::clamp((at - sorted[before]) / step, 0.0, 1.0) : 1.0};
}

// `change` [um] at a position along the rail and a row.
struct ChangeMap {
  QString name, rowLabel;
  double from = 0, to = 1, rowScale = 1;  // of the rows
  std::function<double(double x, double row)> change;
};

void addScale(Figure& figure, QCPColorMap& map, const Style& style) {
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorStopAt(0, QColor(33, 102, 172));
  gradient.setColorStopAt(0.5, QColor(247, 247, 247));
  gradient.setColorStopAt(1, QColor(178, 24, 43));
  auto* scale = new QCPColorScale(&figure);
  figure.addBeside(scale);
  scale->setType(QCPAxis::atRight);
  scale->setBarWidth(8);
  scale->setGradient(gradient);
  map.setColorScale(scale);
  scale->axis()->setLabel(QStringLiteral("Change of height [µm]"));
  scale->axis()->setLabelFont(style.labelFont());
  scale->axis()->setTickLabelFont(style.tickFont());
  scale->axis()->setLabelColor(style.text);
  scale->axis()->setTickLabelColor(style.text);
  scale->axis()->setNumberFormat("gb");
}

std::unique_ptr<Figure> changeFigure(const Growth& growth, const ChangeMap& changes, const Style& style) {
  constexpr int columns = 201, rows = 61;
  auto figure = std::make_unique<Figure>(changes.name, style);
  figure->xAxis->setLabel(QStringLiteral("Position [mm]"));
  figure->yAxis->setLabel(changes.rowLabel);
  auto* map = new QCPColorMap(figure->xAxis, figure->yAxis);
  const double first = growth.x.front(), last = growth.x.back();
  const QCPRange along{millimetres * first, millimetres * last},
      across{changes.rowScale * changes.from, changes.rowScale * changes.to};
  map->data()->setSize(columns, rows);
  map->data()->setRange(along, across);
  double largest = 1e-3;
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row) {
      const double change = changes.change(first + column * (last - first) / (columns - 1),
                                           changes.from + row * (changes.to - changes.from) / (rows - 1));
      map->data()->setCell(column, row, change);
      largest = std::max(largest, std::abs(change));
    }
  addScale(*figure, *map, style);
  map->setDataRange({-largest, largest});
  figure->xAxis->setRange(along);
  figure->yAxis->setRange(across);
  return figure;
}

// [um] since the first stage, between the nodes.
double changeAt(const Growth& growth, const growth::Field& shape, double x, double y) {
  const auto s = placeIn(growth.x, x), line = placeIn(growth.y, y);
  const auto node = [&](std::size_t ds, std::size_t dl) {
    const auto i = (s.index + ds) * growth.y.size() + line.index + dl;
    return shape[i] - growth.shapes.front()[i];
  };
  return micrometres * ((1 - s.share) * ((1 - line.share) * node(0, 0) + line.share * node(0, 1)) +
                        s.share * ((1 - line.share) * node(1, 0) + line.share * node(1, 1)));
}

std::unique_ptr<Figure> changeMap(const Growth& growth, const Style& style) {
  return changeFigure(
      growth,
      {QStringLiteral("growth_change"), QStringLiteral("Across the rail [mm]"), growth.y.front(), growth.y.back(),
       millimetres, [&](double x, double y) { return changeAt(growth, growth.shapes.back(), x, y); }},
      style);
}

// Along the running line, against tonnage.
std::unique_ptr<Figure> historyMap(const Growth& growth, const Style& style) {
  std::vector<double> tonnage;
  for (const auto& stage : growth.stages) tonnage.push_back(stage.tonnage);
  return changeFigure(growth,
                      {QStringLiteral("growth_history"), QStringLiteral("Traffic [Mt]"), 0, tonnage.back(), perMillion,
                       [&](double x, double at) {
                         const auto stage = placeIn(tonnage, at);
                         return (1 - stage.share) * changeAt(growth, growth.shapes[stage.index], x, growth.line) +
                                stage.share * changeAt(growth, growth.shapes[stage.index + 1], x, growth.line);
                       }},
                      style);
}

std::unique_ptr<Figure> strainFigure(const Growth& growth, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_strain"), style);
  figure->xAxis->setLabel(QStringLiteral("Traffic [Mt]"));
  figure->yAxis->setLabel(QStringLiteral("Depth below the surface [mm]"));
  const auto t = tonnages(growth);
  addCurve(*figure,
           {t, valuesOf(growth, &Stage::strainedDepth, millimetres), QStringLiteral("strained down to"), 0, 1.5});
  addCurve(*figure, {t, valuesOf(growth, &Stage::strainDepth, millimetres), QStringLiteral("largest strain at"), 1});
  figure->xAxis->setRange(0, std::max(t.back(), 1e-6));
  fitWithZero(*figure);
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

std::unique_ptr<Figure> dipLengthFigure(const Growth& growth, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_length"), style);
  figure->xAxis->setLabel(QStringLiteral("Traffic [Mt]"));
  figure->yAxis->setLabel(QStringLiteral("Length of the dip [mm]"));
  addCurve(*figure, {tonnages(growth), valuesOf(growth, &Stage::length, millimetres), {}, 0, 1.5});
  fitWithZero(*figure);
  constexpr double roomAbove = 1.1;  // a dip that keeps its length is no line on the frame
  figure->yAxis->setRange(0, roomAbove * figure->yAxis->range().upper);
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
  if (growth.stages.size() > 1) sheet.panels.push_back(historyMap(growth, style));
  sheet.panels.push_back(depthFigure(growth, style));
  sheet.panels.push_back(responseFigure(growth, style));
  if (growth.stages.back().strainedDepth > 0) sheet.panels.push_back(strainFigure(growth, style));
  for (auto& panel : sheet.panels) panel->setCaption(QString::fromStdString(growth.description.title), {});
  alignAxes(sheet);
  return sheet;
}

std::unique_ptr<Figure> stageFigure(const Growth& growth, std::size_t stage, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("growth_stage"), style);
  figure->xAxis->setLabel(QStringLiteral("Position [mm]"));
  figure->yAxis->setLabel(QStringLiteral("Height [mm]"));
  const auto x = scaled(growth.x, millimetres);
  figure->xAxis->setRange(x.front(), x.back());
  // The axes are those of all stages, so that nothing jumps in between.
  for (std::size_t other = 0; other < growth.stages.size(); ++other)
    addCurve(*figure, {x, profileOf(growth, other), {}, 0});
  fitValues(*figure);
  figure->clearGraphs();
  addCurve(*figure, {x, profileOf(growth, 0), QStringLiteral("at first"), 1, 1.0, Qt::DashLine});
  addCurve(*figure, {x, profileOf(growth, stage),
                     QStringLiteral("after %1 Mt").arg(perMillion * growth.stages[stage].tonnage, 0, 'f', 2), 0, 1.5});
  return figure;
}

std::vector<std::unique_ptr<Figure>> growthCurves(const Growth& growth, double end, const Style& style) {
  std::vector<std::unique_ptr<Figure>> curves;
  curves.push_back(depthFigure(growth, style));
  curves.push_back(dipLengthFigure(growth, style));
  curves.push_back(responseFigure(growth, style));
  for (const auto& figure : curves) figure->xAxis->setRange(0, std::max(perMillion * end, 1e-6));
  // Low figures have no room for long labels; the legend names the rest.
  curves[1]->yAxis->setLabel(QStringLiteral("Length [mm]"));
  curves[2]->yAxis->setLabel(QStringLiteral("[m/s²], [kN]"));
  return curves;
}

FigureSheet forecastFigure(const growth::Forecast& forecast, const std::string& stem, const Style& style) {
  auto figure = std::make_unique<Figure>(QStringLiteral("forecast"), style);
  figure->xAxis->setLabel(QStringLiteral("Traffic [Mt]"));
  figure->yAxis->setLabel(QStringLiteral("Depth of the dip [mm]"));
  std::vector<double> t;
  for (const auto& point : forecast.points) t.push_back(perMillion * point.tonnage);
  addCurve(*figure, {t, scaled(forecast.median, millimetres), QStringLiteral("median"), 0, 1.5});
  addCurve(*figure, {t, scaled(forecast.lowest, millimetres), QStringLiteral("lowest"), 1, 1.0, Qt::DashLine});
  addCurve(*figure, {t, scaled(forecast.highest, millimetres), QStringLiteral("highest"), 2, 1.0, Qt::DashLine});
  if (forecast.limit)
    addCurve(*figure, {t, std::vector<double>(t.size(), millimetres * *forecast.limit), QStringLiteral("limit"), 3, 1.0,
                       Qt::DotLine});
  figure->xAxis->setRange(0, std::max(t.back(), 1e-6));
  fitValues(*figure);
  keepZeroInSight(*figure);
  FigureSheet sheet{stem + "_forecast", {}, 1};
  sheet.panels.push_back(std::move(figure));
  return sheet;
}

}  // namespace squat::plots
