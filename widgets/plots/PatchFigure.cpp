#include <algorithm>
#include <cmath>

#include "colours/ColourTables.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"

namespace squat::plots {
namespace {

constexpr int levels = 24;  // of pressure that are told apart

QColor colourOf(const std::string& map, double share) {
  const colours::Rgb colour = colours::colourAt(map, share);
  return QColor::fromRgbF(colour.red, colour.green, colour.blue);
}

void addPressureScale(Figure& figure, double highest) {
  auto* scale = new QCPColorScale(&figure);
  figure.addBeside(scale);
  scale->setType(QCPAxis::atRight);
  scale->setBarWidth(8);
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (int i = 0; i <= 64; ++i) gradient.setColorStopAt(i / 64.0, colourOf(figure.style().colourMap, i / 64.0));
  scale->setGradient(gradient);
  scale->setDataRange(QCPRange(0, highest));
  QCPAxis* axis = scale->axis();
  axis->setLabel("Contact pressure [MPa]");
  axis->setLabelFont(figure.style().labelFont());
  axis->setTickLabelFont(figure.style().tickFont());
  axis->setLabelColor(figure.style().text);
  axis->setTickLabelColor(figure.style().text);
  axis->setNumberFormat("gb");
  axis->setSubTicks(false);
  axis->setTickLabelPadding(3);
  axis->setLabelPadding(2);
  auto* group = new QCPMarginGroup(&figure);
  figure.axisRect()->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMinimumMargins(QMargins(4, 0, 4, 0));
}

// One graph a level of pressure: points of a graph share their colour.
void addLevels(Figure& figure, const results::PatchSnapshot& patch, double highest) {
  for (int level = 0; level < levels; ++level) {
    Curve points;
    for (std::size_t i = 0; i < patch.pressure.size(); ++i) {
      const double share = 1e-6 * static_cast<double>(patch.pressure[i]) / highest;
      if (!(share > 0) || std::min(static_cast<int>(share * levels), levels - 1) != level) continue;
      points.x.push_back(1e3 * static_cast<double>(patch.x[i]));
      points.y.push_back(1e3 * static_cast<double>(patch.y[i]));
    }
    if (points.x.empty()) continue;
    QCPGraph* graph = addCurve(figure, points);
    graph->setLineStyle(QCPGraph::lsNone);
    const QColor colour = colourOf(figure.style().colourMap, (level + 0.5) / levels);
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, 7));
  }
}

void addSlip(Figure& figure, const results::PatchSnapshot& patch) {
  Curve slipping;
  slipping.label = "slips";
  for (std::size_t i = 0; i < std::min(patch.slipping.size(), patch.pressure.size()); ++i) {
    if (!patch.slipping[i] || !(patch.pressure[i] > 0)) continue;
    slipping.x.push_back(1e3 * static_cast<double>(patch.x[i]));
    slipping.y.push_back(1e3 * static_cast<double>(patch.y[i]));
  }
  if (slipping.x.empty()) return;
  QCPGraph* graph = addCurve(figure, slipping);
  graph->setLineStyle(QCPGraph::lsNone);
  graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, Qt::red, Qt::red, 2));
}

}  // namespace

const results::PatchSnapshot* shownPatch(const results::RunResult& result) {
  const results::PatchSnapshot* chosen = nullptr;
  for (const auto& patch : result.patches) {
    if (patch.pressure.empty() || patch.x.size() != patch.pressure.size() || patch.y.size() != patch.pressure.size())
      continue;
    chosen = &patch;
    if (patch.name == "impact") break;
  }
  return chosen;
}

std::unique_ptr<Figure> patchFigure(const results::RunResult& result, const Style& style) {
  auto figure = std::make_unique<Figure>("contact_patch", style);
  figure->setPrintedSize({85, 66});
  figure->xAxis->setLabel("Along the rail, from the wheel centre [mm]");
  figure->yAxis->setLabel("Across the rail [mm]");
  figure->xAxis->setRange(-12, 12);
  figure->yAxis->setRange(-12, 12);
  setCaption(*figure, result);
  const results::PatchSnapshot* patch = shownPatch(result);
  if (!patch) {
    addNotice(*figure, "no contact patch in this result");
    return figure;
  }
  double highest = 0, reach = 1;
  for (std::size_t i = 0; i < patch->pressure.size(); ++i) {
    if (!(patch->pressure[i] > 0)) continue;
    highest = std::max(highest, 1e-6 * static_cast<double>(patch->pressure[i]));
    reach = std::max(
        {reach, 1e3 * std::abs(static_cast<double>(patch->x[i])), 1e3 * std::abs(static_cast<double>(patch->y[i]))});
  }
  if (highest <= 0) {
    addNotice(*figure, "no contact at this moment");
    return figure;
  }
  figure->xAxis->setRange(-1.25 * reach, 1.25 * reach);
  figure->yAxis->setRange(-1.25 * reach, 1.25 * reach);
  addPressureScale(*figure, highest);
  addLevels(*figure, *patch, highest);
  addSlip(*figure, *patch);
  return figure;
}

}  // namespace squat::plots
