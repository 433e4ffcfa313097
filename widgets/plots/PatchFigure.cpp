#include <algorithm>
#include <cmath>

#include "colours/ColourTables.h"
#include "plots/FigureBuilders.h"
#include "plots/LineFigure.h"
#include "results/PatchCells.h"

namespace squat::plots {
namespace {

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

// Every point fills the part of the surface that it stands for.
void addCells(Figure& figure, const results::PatchSnapshot& patch, double highest) {
  const auto cells = results::patchCells(patch);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double share = 1e-6 * static_cast<double>(patch.pressure[i]) / highest;
    if (!(share > 0)) continue;
    auto* box = new QCPItemRect(&figure);
    box->setLayer("main");
    box->topLeft->setCoords(1e3 * cells[i].left, 1e3 * cells[i].far);
    box->bottomRight->setCoords(1e3 * cells[i].right, 1e3 * cells[i].near);
    box->setPen(QPen(figure.style().background, 0.5));
    box->setBrush(colourOf(figure.style().colourMap, share));
    box->setSelectable(false);
  }
}

void addSlip(Figure& figure, const results::PatchSnapshot& patch) {
  Curve slipping;
  slipping.label = "slip";
  for (std::size_t i = 0; i < std::min(patch.slipping.size(), patch.pressure.size()); ++i) {
    if (!patch.slipping[i] || !(patch.pressure[i] > 0)) continue;
    slipping.x.push_back(1e3 * static_cast<double>(patch.x[i]));
    slipping.y.push_back(1e3 * static_cast<double>(patch.y[i]));
  }
  if (slipping.x.empty()) return;
  QCPGraph* graph = addCurve(figure, slipping);
  graph->setLineStyle(QCPGraph::lsNone);
  graph->setLayer("front");
  graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(QColor(214, 39, 40), 1.5), Qt::NoBrush, 6));
}

}  // namespace

namespace {

bool hasPressures(const results::PatchSnapshot& patch) {
  return !patch.pressure.empty() && patch.x.size() == patch.pressure.size() && patch.y.size() == patch.pressure.size();
}

// Largest pressure [MPa] and distance of a point of contact from the middle [mm].
struct Extremes {
  double pressure = 0, reach = 1;
};

void widen(Extremes& extremes, const results::PatchSnapshot& patch) {
  for (std::size_t i = 0; i < patch.pressure.size(); ++i) {
    if (!(patch.pressure[i] > 0)) continue;
    extremes.pressure = std::max(extremes.pressure, 1e-6 * static_cast<double>(patch.pressure[i]));
    extremes.reach = std::max({extremes.reach, 1e3 * std::abs(static_cast<double>(patch.x[i])),
                               1e3 * std::abs(static_cast<double>(patch.y[i]))});
  }
}

// In front of the case's name, where a narrow figure does not cut it off.
void nameMoment(Figure& figure, const results::RunResult& result, int index) {
  const auto& patch = result.patches[static_cast<std::size_t>(index)];
  const QString moment =
      noteOfLeftSide(result) +
      QStringLiteral("%1 at %2 mm: ").arg(QString::fromStdString(patch.name)).arg(1e3 * patch.position, 0, 'f', 1);
  figure.setCaption(moment + QString::fromStdString(result.title.empty() ? result.stem : result.title),
                    QString::fromStdString(result.stem + "  " + result.caseHash));
}

}  // namespace

const results::PatchSnapshot* shownPatch(const results::RunResult& result, int index) {
  if (index >= 0 && index < static_cast<int>(result.patches.size())) {
    const auto& asked = result.patches[static_cast<std::size_t>(index)];
    return hasPressures(asked) ? &asked : nullptr;
  }
  const results::PatchSnapshot* chosen = nullptr;
  for (const auto& patch : result.patches) {
    if (!hasPressures(patch)) continue;
    chosen = &patch;
    if (patch.name == "impact") break;
  }
  return chosen;
}

std::unique_ptr<Figure> patchFigure(const results::RunResult& result, const Style& style, int index) {
  auto figure = std::make_unique<Figure>("contact_patch", style);
  figure->setPrintedSize({85, 66});
  figure->xAxis->setLabel("Along the rail, relative to the wheel centre [mm]");
  figure->yAxis->setLabel("Across the rail [mm]");
  figure->xAxis->setRange(-12, 12);
  figure->yAxis->setRange(-12, 12);
  setCaption(*figure, result, ShownSide::left);
  Extremes scale;
  for (const auto& each : result.patches)
    if (index >= 0 && hasPressures(each)) widen(scale, each);
  const results::PatchSnapshot* patch = shownPatch(result, index);
  if (patch && index < 0) widen(scale, *patch);
  if (index >= 0 && index < static_cast<int>(result.patches.size())) nameMoment(*figure, result, index);
  if (!patch) {
    addNotice(*figure, index < 0 ? "no contact patch in this result" : "no contact patch at this moment");
    return figure;
  }
  if (scale.pressure > 0) {
    figure->xAxis->setRange(-1.25 * scale.reach, 1.25 * scale.reach);
    figure->yAxis->setRange(-1.25 * scale.reach, 1.25 * scale.reach);
  }
  Extremes shown;
  widen(shown, *patch);
  if (shown.pressure <= 0) {
    addNotice(*figure, "no contact at this moment");
    return figure;
  }
  addPressureScale(*figure, scale.pressure);
  addCells(*figure, *patch, scale.pressure);
  addSlip(*figure, *patch);
  return figure;
}

QByteArray patchTable(const results::RunResult& result, int index) {
  const results::PatchSnapshot* patch = shownPatch(result, index);
  if (!patch) return {};
  QByteArray text = "along [m],across [m],pressure [Pa],traction along [Pa],traction across [Pa],slips\n";
  for (std::size_t i = 0; i < patch->pressure.size(); ++i) {
    const auto at = [i](const std::vector<float>& values) {
      return i < values.size() ? QByteArray::number(values[i], 'g', 7) : QByteArray();
    };
    text += at(patch->x) + ',' + at(patch->y) + ',' + at(patch->pressure) + ',' + at(patch->tractionX) + ',' +
            at(patch->tractionY) + ',' + (i < patch->slipping.size() && patch->slipping[i] ? "1\n" : "0\n");
  }
  return text;
}

}  // namespace squat::plots
