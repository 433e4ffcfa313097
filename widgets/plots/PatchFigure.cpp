#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

// A contact and the axes that it is drawn in.
struct Panel {
  QCPAxisRect* axes;
  const results::PatchSnapshot* patch;  // null: none is known
};

void addPressureScale(Figure& figure, const std::vector<Panel>& panels, double highest) {
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
  for (const Panel& panel : panels) panel.axes->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMarginGroup(QCP::msTop | QCP::msBottom, group);
  scale->setMinimumMargins(QMargins(4, 0, 4, 0));
}

// Every point fills the part of the surface that it stands for.
void addCells(Figure& figure, const Panel& panel, double highest) {
  const auto cells = results::patchCells(*panel.patch);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double share = 1e-6 * static_cast<double>(panel.patch->pressure[i]) / highest;
    if (!(share > 0)) continue;
    auto* box = new QCPItemRect(&figure);
    box->setLayer("main");
    box->setClipAxisRect(panel.axes);
    for (auto* corner : {box->topLeft, box->bottomRight})
      corner->setAxes(panel.axes->axis(QCPAxis::atBottom), panel.axes->axis(QCPAxis::atLeft));
    box->topLeft->setCoords(1e3 * cells[i].left, 1e3 * cells[i].far);
    box->bottomRight->setCoords(1e3 * cells[i].right, 1e3 * cells[i].near);
    box->setPen(QPen(figure.style().background, 0.5));
    box->setBrush(colourOf(figure.style().colourMap, share));
    box->setSelectable(false);
  }
}

void addSlip(Figure& figure, const Panel& panel) {
  const results::PatchSnapshot& patch = *panel.patch;
  Curve slipping;
  if (figure.graphCount() == 0) slipping.label = "slip";  // one entry of the legend for both sides
  for (std::size_t i = 0; i < std::min(patch.slipping.size(), patch.pressure.size()); ++i) {
    if (!patch.slipping[i] || !(patch.pressure[i] > 0)) continue;
    slipping.x.push_back(1e3 * static_cast<double>(patch.x[i]));
    slipping.y.push_back(1e3 * static_cast<double>(patch.y[i]));
  }
  if (slipping.x.empty()) return;
  QCPGraph* graph = addCurve(figure, slipping);
  graph->setKeyAxis(panel.axes->axis(QCPAxis::atBottom));
  graph->setValueAxis(panel.axes->axis(QCPAxis::atLeft));
  graph->setLineStyle(QCPGraph::lsNone);
  graph->setLayer("front");
  graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(QColor(214, 39, 40), 1.5), Qt::NoBrush, 6));
}

QCPItemText* addText(Figure& figure, const Panel& panel, const QString& text) {
  auto* label = addNotice(figure, text);
  label->position->setAxisRect(panel.axes);
  label->setClipAxisRect(panel.axes);
  return label;
}

void addSideName(Figure& figure, const Panel& panel, const QString& name) {
  auto* label = addText(figure, panel, name);
  label->position->setCoords(0.02, 0.02);
  label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setFont(figure.style().labelFont());
  label->setColor(figure.style().text);
}

bool hasPressures(const results::PatchSnapshot& patch) {
  return !patch.pressure.empty() && patch.x.size() == patch.pressure.size() && patch.y.size() == patch.pressure.size();
}

// Largest pressure [MPa] and distance of a point of contact from the middle [mm].
struct Extremes {
  double pressure = 0, reach = 1;
};

// By one contact; null: none is known.
void widen(Extremes& extremes, const results::PatchSnapshot* contact) {
  if (!contact || !hasPressures(*contact)) return;
  for (std::size_t i = 0; i < contact->pressure.size(); ++i) {
    if (!(contact->pressure[i] > 0)) continue;
    extremes.pressure = std::max(extremes.pressure, 1e-6 * static_cast<double>(contact->pressure[i]));
    extremes.reach = std::max({extremes.reach, 1e3 * std::abs(static_cast<double>(contact->x[i])),
                               1e3 * std::abs(static_cast<double>(contact->y[i]))});
  }
}

// Of all moments, or of the one that is shown: axes and colours are the same on both sides.
Extremes extremesOf(const results::RunResult& result, const results::PatchSnapshot* shown, bool everyMoment) {
  Extremes extremes;
  for (const auto& patch : result.patches) {
    if (!everyMoment && &patch != shown) continue;
    widen(extremes, &patch);
    widen(extremes, patch.right.get());
  }
  return extremes;
}

bool isUnderPressure(const results::PatchSnapshot* contact) {
  Extremes own;
  widen(own, contact);
  return own.pressure > 0;
}

bool hasContact(const results::PatchSnapshot& patch) {
  return hasPressures(patch) || (patch.right && hasPressures(*patch.right));
}

// Whether the right contact was stored.
bool holdsBothSides(const results::RunResult& result) {
  return std::any_of(result.patches.begin(), result.patches.end(),
                     [](const auto& patch) { return patch.right != nullptr; });
}

// In front of the case's name, where a narrow figure does not cut it off.
void nameMoment(Figure& figure, const results::RunResult& result, int index) {
  const auto& patch = result.patches[static_cast<std::size_t>(index)];
  const QString moment =
      (holdsBothSides(result) ? QString() : noteOfLeftSide(result)) +
      QStringLiteral("%1 at %2 mm: ").arg(QString::fromStdString(patch.name)).arg(1e3 * patch.position, 0, 'f', 1);
  figure.setCaption(moment + QString::fromStdString(result.title.empty() ? result.stem : result.title),
                    QString::fromStdString(result.stem + "  " + result.caseHash));
}

// The axes of each contact, the left one first, with names where there are two.
std::vector<Panel> addPanels(Figure& figure, const results::PatchSnapshot* patch, bool bothSides) {
  std::vector<Panel> panels{{figure.axisRect(), patch}};
  if (bothSides) panels.push_back({figure.addAxesBeside(), patch ? patch->right.get() : nullptr});
  for (const Panel& panel : panels) {
    panel.axes->axis(QCPAxis::atBottom)
        ->setLabel(bothSides ? "Along the rail, from the wheel [mm]"
                             : "Along the rail, relative to the wheel centre [mm]");
    panel.axes->axis(QCPAxis::atLeft)->setLabel(bothSides ? "Across the rail, outwards [mm]" : "Across the rail [mm]");
  }
  if (!bothSides) return panels;
  addSideName(figure, panels[0], "left");
  addSideName(figure, panels[1], "right");
  return panels;
}

}  // namespace

const results::PatchSnapshot* shownPatch(const results::RunResult& result, int index) {
  if (index >= 0 && index < static_cast<int>(result.patches.size())) {
    const auto& asked = result.patches[static_cast<std::size_t>(index)];
    return hasContact(asked) ? &asked : nullptr;
  }
  const results::PatchSnapshot* chosen = nullptr;
  for (const auto& patch : result.patches) {
    if (!hasContact(patch)) continue;
    chosen = &patch;
    if (patch.name == "impact") break;
  }
  return chosen;
}

std::unique_ptr<Figure> patchFigure(const results::RunResult& result, const Style& style, int index) {
  auto figure = std::make_unique<Figure>("contact_patch", style);
  const bool bothSides = holdsBothSides(result);
  figure->setPrintedSize({bothSides ? 150.0 : 85.0, 66});
  const results::PatchSnapshot* patch = shownPatch(result, index);
  const auto panels = addPanels(*figure, patch, bothSides);
  figure->xAxis->setRange(-12, 12);
  figure->yAxis->setRange(-12, 12);
  setCaption(*figure, result, bothSides ? ShownSide::every : ShownSide::left);
  if (index >= 0 && index < static_cast<int>(result.patches.size())) nameMoment(*figure, result, index);
  if (!patch) {
    for (const Panel& panel : panels)
      addText(*figure, panel, index < 0 ? "no contact patch in this result" : "no contact patch at this moment");
    return figure;
  }
  const Extremes scale = extremesOf(result, patch, index >= 0);
  if (scale.pressure > 0) {
    figure->xAxis->setRange(-1.25 * scale.reach, 1.25 * scale.reach);
    figure->yAxis->setRange(-1.25 * scale.reach, 1.25 * scale.reach);
  }
  bool drawn = false;
  for (const Panel& panel : panels) {
    if (!isUnderPressure(panel.patch)) {
      addText(*figure, panel, "no contact at this moment");
      continue;
    }
    if (!std::exchange(drawn, true)) addPressureScale(*figure, panels, scale.pressure);
    addCells(*figure, panel, scale.pressure);
    addSlip(*figure, panel);
  }
  return figure;
}

namespace {

void addRows(QByteArray& text, const results::PatchSnapshot& contact, const QByteArray& side) {
  for (std::size_t i = 0; i < contact.pressure.size(); ++i) {
    const auto at = [i](const std::vector<float>& values) {
      return i < values.size() ? QByteArray::number(values[i], 'g', 7) : QByteArray();
    };
    text += side + at(contact.x) + ',' + at(contact.y) + ',' + at(contact.pressure) + ',' + at(contact.tractionX) +
            ',' + at(contact.tractionY) + ',' + (i < contact.slipping.size() && contact.slipping[i] ? "1\n" : "0\n");
  }
}

}  // namespace

QByteArray patchTable(const results::RunResult& result, int index) {
  const results::PatchSnapshot* patch = shownPatch(result, index);
  if (!patch) return {};
  QByteArray text = "along [m],across [m],pressure [Pa],traction along [Pa],traction across [Pa],slips\n";
  if (!patch->right) {
    addRows(text, *patch, {});
    return text;
  }
  text.prepend("side,");
  addRows(text, *patch, "left,");
  addRows(text, *patch->right, "right,");
  return text;
}

}  // namespace squat::plots
