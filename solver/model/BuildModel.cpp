#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "geometry/RailSection.h"
#include "geometry/WheelSection.h"
#include "model/BuildBlocks.h"
#include "model/BuildForceElements.h"
#include "model/CentrePlane.h"
#include "model/Model.h"
#include "model/Rings.h"
#include "scenario/DefectSurface.h"
#include "scenario/WheelsetMass.h"

namespace squat::model {

namespace {

Ring makeRing(const Model& model, double radius, double from, double to) {
  return seatRing(model.blocks[model.body], model.body, radius, from, to);
}

void tieRim(Model& model) {
  const double radius = model.scenario.wheelset.radius - model.scenario.mesh.rimDepth;
  const auto inner = geometry::nodesWhere(
      model.blocks[model.rim].section, [&](const geometry::Point2& p) { return std::abs(p[0] - radius) < 1e-9; }, 1);
  model.ties.push_back(elasticity::makeTie(model.blocks, model.rim, model.body, inner));
  for (const auto& block : model.blocks) model.slave.emplace_back(block.nodes, 0);
  for (const int node : inner) model.slave[model.rim][node] = 1;
}

// A ring's mass is added evenly around, by the ring's weights along y.
void addRingMass(Model& model, const Ring& ring, double mass) {
  const auto& block = model.blocks[ring.block];
  for (std::size_t i = 0; i < ring.nodes.size(); ++i)
    for (int s = 0; s < block.stationCount; ++s)
      model.mass[ring.block][ring.nodes[i] * block.stride + s] += mass * ring.weight[i] / block.stationCount;
}

void passSlaveMass(Model& model, const elasticity::SweptTie& tie) {
  const auto &slave = model.blocks[tie.slaveBlock], &master = model.blocks[tie.masterBlock];
  auto &from = model.mass[tie.slaveBlock], &to = model.mass[tie.masterBlock];
  for (std::size_t i = 0; i < tie.slaveNodes.size(); ++i)
    for (int s = 0; s < slave.stationCount; ++s) {
      double& own = from[tie.slaveNodes[i] * slave.stride + s];
      const auto& at = tie.stations;
      for (int e = tie.entryStart[i]; e < tie.entryStart[i + 1]; ++e) {
        const auto& column = tie.columns[tie.entryColumn[e]];
        for (int layer = 0; layer < 2; ++layer) {
          const int node = layer ? column.inner : column.outer;
          if (node < 0) continue;
          const double share = own * tie.entryWeight[e] * (layer ? -at.extrapolation[s] : 1 + at.extrapolation[s]);
          to[node * master.stride + at.left[s]] += share * at.leftWeight[s];
          to[node * master.stride + at.right[s]] += share * at.rightWeight[s];
        }
      }
      own = 0;
    }
}

double massOf(const elasticity::SweptBlock& block, const AlignedVector& mass) {
  double sum = 0;
  for (int n = 0; n < block.nodes; ++n)
    for (int s = 0; s < block.stationCount; ++s) sum += mass[n * block.stride + s];
  return sum;
}

// Tied nodes of a thin ring reach beyond it, between its chords: they would leave less than nothing to its inner nodes.
void requireMass(const Model& model) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    for (int n = 0; n < model.blocks[b].nodes; ++n)
      for (int s = 0; s < model.blocks[b].stationCount; ++s)
        if (!model.slave[b][n] && !(model.mass[b][n * model.blocks[b].stride + s] > 0))
          throw CaseError(
              {{"mesh.rim_depth", std::to_string(1e3 * model.scenario.mesh.rimDepth) + " mm",
                "such that the rim's inner layer is thicker than what the chords of mesh.wheel_sectors cut off",
                "Lower mesh.rim_depth or raise mesh.wheel_sectors"}});
}

void addMasses(Model& model) {
  const auto& w = model.scenario.wheelset;
  for (const auto& block : model.blocks) {
    const auto mass = elasticity::lumpedMass(block);
    model.mass.emplace_back(mass.begin(), mass.end());
  }
  auto& figures = model.wheelset;
  figures.solidMass =
      massOf(model.blocks[model.rim], model.mass[model.rim]) + massOf(model.blocks[model.body], model.mass[model.body]);
  const double stated = scenario::brakeDiscsMass(w);
  const double rest = w.totalMass - w.axleBoxMass - figures.solidMass - stated;
  // A derived mass is that of the drawing: the meshed solids, with chords in place of arcs and without details below
  // 12 mm, may weigh a little more. What they weigh too much is taken from the axle.
  constexpr double details = 0.01;
  const bool derived = w.totalMass == scenario::partsMass(w);
  if (!derived && rest < -details * w.totalMass)
    throw CaseError({{"wheelset.total_mass", std::to_string(w.totalMass) + " kg",
                      "at least " + std::to_string(figures.solidMass + w.axleBoxMass + stated) +
                          " kg: solids as meshed, axle box" + (stated > 0 ? " and brake discs" : ""),
                      "Raise wheelset.total_mass or lower wheelset.axle_box_mass"}});
  if (!model.boxOnSpring()) addRingMass(model, model.bearing, w.axleBoxMass);
  // Brake discs sit on the axle between wheel and symmetry plane; what no part is stated for is spread there as well.
  for (const auto& disc : discRings(w, model.blocks[model.body], model.body)) addRingMass(model, disc, w.brakeDiscMass);
  addRingMass(model, axleMassRing(w, model.blocks[model.body], model.body), rest);
  for (const auto& tie : model.ties) passSlaveMass(model, tie);
  figures.mass = w.totalMass;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int n = 0; n < block.nodes; ++n)
      for (int s = 0; s < block.stationCount; ++s) {
        const double mass = model.mass[b][n * block.stride + s], radius = block.section.nodes[n][0];
        figures.inertia += mass * radius * radius, figures.turningMass += mass;
        figures.leverX += mass * radius * block.cosines[s], figures.leverZ += mass * radius * block.sines[s];
      }
  }
  requireMass(model);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    AlignedVector inverse(model.mass[b].size(), 0.0);
    for (std::size_t i = 0; i < inverse.size(); ++i)
      if (model.mass[b][i] > 0) inverse[i] = 1 / model.mass[b][i];
    for (int n = 0; n < model.blocks[b].nodes; ++n)
      if (model.slave[b][n]) std::fill_n(inverse.begin() + n * model.blocks[b].stride, model.blocks[b].stride, 0.0);
    model.inverseMass.push_back(std::move(inverse));
  }
}

// The surface nodes take the shape of the defect; nodes below follow, less with depth, down to four element sizes.
elasticity::NodeShift defectShift(const Model& model) {
  const auto& d = model.scenario;
  if (d.defectModel != scenario::DefectModel::movedNodes) return {};
  const auto* rail = &model.blocks[model.rail];
  return [defect = d.defectSurface, rail, section = d.rail.section, blended = 4 * d.mesh.contactSize](
             int node, int station) -> Eigen::Vector3d {
    const auto& p = rail->section.nodes[node];
    const double depth = geometry::crownHeight(section, p[0]) - p[1];
    if (depth >= blended) return {0, 0, 0};
    return {0, 0, defect.height(rail->positions[station], p[0]) * (1 - std::max(0.0, depth) / blended)};
  };
}

// The surface layer that may yield: below all columns that the wheel can touch, where it can roll.
void addLayer(Model& model, const elasticity::NodeShift& shift) {
  const auto& rail = model.scenario.rail;
  if (!rail.plastic) return;
  const auto& s = model.surfaces;
  const auto& at = model.blocks[model.rail].positions;
  int from = s.firstInterval, end = s.firstInterval + s.intervals;
  contact::Columns columns{s.firstColumn, s.columns};
  if (rail.plasticFrom < rail.plasticTo) {
    columns = contact::touchedColumns(s.railY, rail.plasticMiddle);
    while (from < end && at[from + 1] <= rail.plasticFrom) ++from;
    while (end > from && at[end - 1] >= rail.plasticTo) --end;
  }
  const auto first = s.railLine.begin() + columns.first;
  model.layer = plasticity::makeLayer(model.blocks[model.rail], plasticity::hardeningLaw(rail),
                                      {first, first + columns.count + 1}, rail.plasticDepth, from, end - from, shift);
}

// Of the first sleeper; the others are alike.
void shapeSleepers(Model& model) {
  const auto& sleeper = model.blocks[model.firstSleeper];
  if (sleeper.extent.empty()) return;
  model.sleeperShape = elasticity::irregularElements(
      sleeper, [&](int node, int station) { return elasticity::extentShift(sleeper, node, station); });
  if (!model.loaded.empty()) {
    const std::size_t lines = model.loaded[model.firstSleeper].offset;
    for (const auto& unknown : model.sleeperShape.unknown) {
      std::array<std::size_t, 24> slots{};
      for (int i = 0; i < 24; ++i) slots[i] = forceSlot(model, unknown[i]) - lines;
      model.sleeperShape.forceSlot.push_back(slots);
    }
  }
  for (auto& unknown : model.sleeperShape.unknown)
    for (auto& index : unknown) index -= sleeper.offset;
}

void fillIrregularSlots(Model& model) {
  auto& moved = model.movedElements;
  for (const auto& unknown : moved.unknown) {
    std::array<std::size_t, 24> slots{};
    for (int i = 0; i < 24; ++i) slots[i] = forceSlot(model, unknown[i]);
    moved.forceSlot.push_back(slots);
  }
}

}  // namespace

std::size_t Model::elements() const {
  std::size_t sum = 0;
  for (const auto& block : blocks) sum += block.elements();
  return sum;
}

std::size_t Model::nodeCount() const {
  std::size_t sum = 0;
  for (const auto& block : blocks) sum += static_cast<std::size_t>(block.nodes) * block.stationCount;
  for (const auto& tie : ties) sum -= tie.slaveNodes.size() * blocks[tie.slaveBlock].stationCount;
  return sum;
}

void addSleeperShapes(const Model& model, const double* u, double* result) {
  if (model.sleeperShape.size() == 0) return;
  for (int i = 0; i < model.sleepers; ++i) {
    const std::size_t offset = model.blocks[model.firstSleeper + i].offset;
    elasticity::addIrregularStiffness(model.sleeperShape, u + offset, result + offset);
  }
}

Model withDefect(Model model, const scenario::Scenario& scenario) {
  model.scenario = scenario;
  contact::layDefect(model.surfaces, model.blocks[model.rail], scenario);
  return model;
}

Model buildTrackCell(const scenario::Scenario& scenario, double stationLength, int sleeperIntervals) {
  constexpr int multiple = 8;  // intervals of a block
  Model model;
  model.scenario = scenario;
  model.scenario.track.seats.clear();
  const double bay = scenario.track.sleeperSpacing;
  auto rail = railBlock(scenario);
  const int intervals = multiple * static_cast<int>(std::ceil(bay / stationLength / multiple - 1e-9));
  rail.stations = {-bay / 2, false, {{intervals, bay / intervals}}};
  model.rail = 0;
  append(model, std::move(rail));
  model.sleeperPositions = {0};
  addSleepers(model, sleeperIntervals);
  shapeSleepers(model);
  addSupports(model);
  fixSleeper(model, model.blocks[model.firstSleeper], Centre::symmetric);
  for (const auto& block : model.blocks) {
    const auto mass = elasticity::lumpedMass(block);
    model.mass.emplace_back(mass.begin(), mass.end());
  }
  model.surfaces.railLine = contact::runningLine(model.blocks[model.rail], scenario.rail.section);
  for (const int node : model.surfaces.railLine)
    model.surfaces.railY.push_back(model.blocks[model.rail].section.nodes[node][0]);
  return model;
}

Model buildModel(const scenario::Scenario& scenario, int sleeperIntervals) {
  Model model;
  model.scenario = scenario;
  const RollingStretch stretch = addBlocks(model, sleeperIntervals);
  const auto& w = scenario.wheelset;
  model.wheelset.centreHeight = contact::seatOf(scenario).centreHeight;
  model.bearing =
      makeRing(model, w.journalRadius, w.bearingCentre - w.bearingWidth / 2, w.bearingCentre + w.bearingWidth / 2);
  model.hub = makeRing(model, w.hubRadius, -w.hubWidth / 2, w.hubWidth / 2);
  model.centre = sectionRing(model.blocks[model.body], model.body, geometry::seatLineRadius(w), 0);
  tieRim(model);
  model.surfaces = contact::makeSurfaces(model.blocks[model.rail], model.rail, model.blocks[model.rim], model.rim,
                                         scenario, stretch.from, stretch.to);
  model.firstAuxiliary = model.stateSize;
  model.sprungX = model.stateSize, model.sprungZ = model.stateSize + 1;
  model.boxX = model.stateSize + 2, model.boxZ = model.stateSize + 3;
  model.journalX = model.stateSize + 4, model.journalZ = model.stateSize + 5;
  model.stateSize += auxiliaryUnknowns;
  const auto shift = defectShift(model);
  if (shift) model.movedElements = elasticity::irregularElements(model.blocks[model.rail], shift);
  addLayer(model, shift);
  layOutForces(model);
  fillIrregularSlots(model);
  shapeSleepers(model);
  addForceElements(model);
  fixUnknowns(model, scenario.extent == scenario::ModelExtent::whole ? Centre::shared : Centre::symmetric);
  addMasses(model);
  if (scenario.bogie.hasSecond()) model.second = secondWheelset(model);
  return model;
}

}  // namespace squat::model
