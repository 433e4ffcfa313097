#include "plots/RoughnessFigure.h"

#include <cmath>

#include "plots/LineFigure.h"
#include "scenario/Irregularity.h"

namespace squat::plots {

namespace {

void setWavelengthAxis(Figure& figure, double shortest, double longest) {
  for (auto* axis : {figure.xAxis, figure.xAxis2}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  }
  figure.xAxis->setLabel(QStringLiteral("Wavelength [mm]"));
  figure.xAxis->setRange(shortest, longest);
}

void addPoints(Figure& figure, const std::vector<double>& x, const std::vector<double>& y, const QString& label) {
  auto* graph = addCurve(figure, {x, y, label, 1, 1.0});
  graph->setLineStyle(QCPGraph::lsNone);
  graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDiamond, 6));
}

}  // namespace

FigureSheet roughnessFigure(const roughness::RecordRoughness& roughness, const std::string& name, const Style& style) {
  FigureSheet sheet{name, {}, 1};
  auto figure = std::make_unique<Figure>(QStringLiteral("roughness"), style);
  figure->yAxis->setLabel(QStringLiteral("Level of third octaves [dB re 1 µm]"));
  Curve level{{}, {}, QStringLiteral("implied by the record"), 0, 1.5}, lowest{{}, {}, {}, 0, 0.7, Qt::DashLine};
  lowest.label = QStringLiteral("bounds of what is known");
  Curve highest{{}, {}, {}, 0, 0.7, Qt::DashLine};
  for (const auto& row : roughness.levels) {
    if (!std::isfinite(row.level)) continue;
    for (auto* curve : {&level, &lowest, &highest}) curve->x.push_back(1e3 * row.band.middle);
    level.y.push_back(row.level), lowest.y.push_back(row.lowest), highest.y.push_back(row.highest);
  }
  const double shortest = level.x.empty() ? 10 : level.x.front(), longest = level.x.empty() ? 1000 : level.x.back();
  std::vector<double> limitAt, limit;
  for (const auto& row : scenario::iso3095Limit())
    if (1e3 * row.wavelength >= 0.97 * shortest && 1e3 * row.wavelength <= 1.03 * longest)
      limitAt.push_back(1e3 * row.wavelength), limit.push_back(row.level);
  setWavelengthAxis(*figure, shortest / 1.12, longest * 1.12);
  if (level.x.empty())
    addNotice(*figure, QStringLiteral("no third octave within reach"));
  else
    for (const auto* curve : {&lowest, &highest, &level}) addCurve(*figure, *curve);
  if (!limitAt.empty()) addPoints(*figure, limitAt, limit, QStringLiteral("limit of ISO 3095:2013"));
  fitValues(*figure);
  figure->setCaption(QString::fromStdString(name), {});
  sheet.panels.push_back(std::move(figure));
  return sheet;
}

}  // namespace squat::plots
