#include "model/BuildForceElements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "geometry/Stations.h"
#include "scenario/TrackCentre.h"

namespace squat::model {

namespace {

using Terms = std::vector<std::pair<std::size_t, double>>;

// Bilinear interpolation on a face line of a block: one displacement component at (section coordinate, station
// position).
void interpolate(const elasticity::SweptBlock& block, const std::vector<int>& line, int axis, double section,
                 double station, int component, double sign, Terms& terms) {
  std::vector<double> coordinates;
  for (const int node : line) coordinates.push_back(block.section.nodes[node][axis]);
  const auto [j, v] = geometry::intervalOf(coordinates, section);
  const auto [s, u] = geometry::intervalOf(block.positions, station);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      const double weight = (a ? v : 1 - v) * (b ? u : 1 - u);
      if (weight != 0) terms.push_back({block.index(line[j + a], component, s + b), sign * weight});
    }
}

std::vector<int> railBase(const elasticity::SweptBlock& rail) {
  double lowest = 0;
  for (const auto& p : rail.section.nodes) lowest = std::min(lowest, p[1]);
  return geometry::nodesWhere(
      rail.section, [&](const geometry::Point2& p) { return p[1] < lowest + 1e-9; }, 0);
}

std::vector<int> sleeperFace(const elasticity::SweptBlock& sleeper, double z) {
  return geometry::nodesWhere(
      sleeper.section, [&](const geometry::Point2& p) { return std::abs(p[0] - z) < 1e-9; }, 1);
}

// Local component of a block for a global axis (x, y, z).
int component(elasticity::SweepKind kind, int axis) {
  if (kind == elasticity::SweepKind::alongX) return axis;
  const int alongY[3] = {2, 0, 1};
  return alongY[axis];
}

forces::ForceElements emptySet(forces::Kind kind, const std::string& name) {
  forces::ForceElements set;
  set.kind = kind, set.name = name;
  return set;
}

// What a seat says of itself; nothing where it is like the others.
scenario::Seat seatAt(const Model& model, int sleeper) {
  const int index =
      scenario::sleepersOf(model.scenario.track, model.scenario.pad, model.scenario.motion).first + sleeper;
  for (const auto& seat : model.scenario.track.seats)
    if (seat.sleeper == index) return seat;
  return {};
}

forces::ElasticLaw padLaw(const scenario::Pad& pad) {
  std::vector<std::array<double, 2>> points;
  for (const auto& point : pad.curve) points.push_back({point.compression, point.force});
  return forces::ElasticLaw::fromCompression(points, pad.preload);
}

void addPads(Model& model) {
  auto pads = emptySet(forces::Kind::railPad, "rail pads");
  auto alongCurve = emptySet(forces::Kind::railPad, "rail pads along their curve");
  constexpr int alongRail = 6, acrossRail = 4;  // springs of one pad
  const auto& pad = model.scenario.pad;
  const auto& rail = model.blocks[model.rail];
  const auto base = railBase(rail);
  const Eigen::Matrix3d basis = elasticity::localBasis(rail, 0);
  const double lowest = rail.section.nodes[base.front()][1];
  if (!pad.curve.empty()) alongCurve.law = padLaw(pad);
  for (int i = 0; i < model.sleepers; ++i) {
    const auto seat = seatAt(model, i);
    const bool followsCurve = alongCurve.law && !seat.padStiffness;
    const double vertical = followsCurve ? 1 : seat.padStiffness.value_or(pad.stiffness);
    const double stiffness[3] = {pad.longitudinalStiffness, pad.lateralStiffness, vertical};
    const double damping[3] = {pad.longitudinalDamping, pad.lateralDamping, seat.padDamping.value_or(pad.damping)};
    const auto& sleeper = model.blocks[model.firstSleeper + i];
    const auto top = sleeperFace(sleeper, 0);
    for (int p = 0; p < alongRail; ++p)
      for (int q = 0; q < acrossRail; ++q) {
        const double dx = ((p + 0.5) / alongRail - 0.5) * pad.length, y = ((q + 0.5) / acrossRail - 0.5) * pad.width;
        // Pads lie under the foot and lean with the rail: the sleeper's seat is cut to its inclination.
        const double across = (basis * Eigen::Vector3d(0, y, lowest))[1];
        for (int axis = 0; axis < 3; ++axis) {
          Terms terms;
          interpolate(rail, base, 0, y, model.sleeperPositions[i] + dx, axis, 1, terms);
          for (int global = 0; global < 3; ++global)
            if (basis(global, axis) != 0)
              interpolate(sleeper, top, 1, dx, across, component(sleeper.kind, global), -basis(global, axis), terms);
          const double share = 1.0 / (alongRail * acrossRail);
          (axis == 2 && followsCurve ? alongCurve : pads).add(terms, share * stiffness[axis], share * damping[axis]);
        }
      }
  }
  model.forceElements.push_back(std::move(pads));
  if (alongCurve.size() > 0) model.forceElements.push_back(std::move(alongCurve));
}

void addBallast(Model& model) {
  auto ballast = emptySet(forces::Kind::ballast, "ballast");
  const auto& d = model.scenario;
  std::map<double, forces::ForceElements> voided;  // by gap
  for (int i = 0; i < model.sleepers; ++i) {
    const auto seat = seatAt(model, i);
    if (seat.gap && !voided.count(*seat.gap)) {
      auto& set = voided[*seat.gap] = emptySet(forces::Kind::ballast, "ballast under a void");
      set.law = forces::ElasticLaw::closingGap(*seat.gap);
    }
    const double stiffness[3] = {d.ballast.longitudinalStiffness, d.ballast.lateralStiffness,
                                 seat.ballastStiffness.value_or(d.ballast.stiffness)};
    const double damping[3] = {d.ballast.longitudinalDamping, d.ballast.lateralDamping,
                               seat.ballastDamping.value_or(d.ballast.damping)};
    const auto& sleeper = model.blocks[model.firstSleeper + i];
    const auto base = sleeperFace(sleeper, -d.sleeper.height);
    const int n = static_cast<int>(base.size());
    for (int j = 0; j < n; ++j)
      for (int s = 0; s < sleeper.stationCount; ++s) {
        // Share of the base area that belongs to the node.
        const double across = (j == 0 || j == n - 1 ? 0.5 : 1.0) / (n - 1);
        const double along = (s == 0 || s == sleeper.stationCount - 1 ? 0.5 : 1.0) / sleeper.intervals;
        for (int axis = 0; axis < 3; ++axis)
          (axis == 2 && seat.gap ? voided.at(*seat.gap) : ballast)
              .add({{sleeper.index(base[j], component(sleeper.kind, axis), s), 1.0}}, across * along * stiffness[axis],
                   across * along * damping[axis]);
      }
  }
  model.forceElements.push_back(std::move(ballast));
  for (auto& [gap, set] : voided) model.forceElements.push_back(std::move(set));
}

// Dashpots with the impedances of plane waves let rail waves leave (Lysmer and Kuhlemeyer 1969): density times the
// bar's wave speed along the rail, density times the shear wave speed across it.
forces::ForceElements absorbingEnds(const Model& model) {
  auto ends = emptySet(forces::Kind::railEnd, "absorbing rail ends");
  const auto& rail = model.blocks[model.rail];
  const auto& m = rail.material;
  const double impedance[3] = {m.density * std::sqrt(m.young / m.density),
                               m.density * std::sqrt(m.young / (2 * (1 + m.poisson)) / m.density),
                               m.density * std::sqrt(m.young / (2 * (1 + m.poisson)) / m.density)};
  std::vector<double> area(rail.nodes, 0.0);
  for (const auto& quad : rail.section.quads) {
    geometry::SectionMesh single{{}, {{0, 1, 2, 3}}};
    for (const int node : quad) single.nodes.push_back(rail.section.nodes[node]);
    for (const int node : quad) area[node] += sectionIntegrals(single).area / 4;
  }
  for (const int station : {0, rail.stationCount - 1})
    for (int n = 0; n < rail.nodes; ++n)
      for (int axis = 0; axis < 3; ++axis)
        ends.add({{rail.index(n, axis, station), 1.0}}, 0, impedance[axis] * area[n]);
  return ends;
}

// From the journal, or from the axle box where that is on a spring, to the sprung mass.
void addVehicle(Model& model) {
  const auto& d = model.scenario;
  std::size_t x = model.journalX, z = model.journalZ;
  if (model.boxOnSpring()) {
    // WheelsetModes.cpp has the same spring for one harmonic around the axis, where there is no state to add it to.
    auto bearing = emptySet(forces::Kind::axleBearing, "axle bearing");
    bearing.add({{x, 1.0}, {model.boxX, -1.0}}, d.wheelset.bearingStiffness, d.wheelset.bearingDamping);
    bearing.add({{z, 1.0}, {model.boxZ, -1.0}}, d.wheelset.bearingStiffness, d.wheelset.bearingDamping);
    model.forceElements.push_back(std::move(bearing));
    x = model.boxX, z = model.boxZ;
  }
  auto suspension = emptySet(forces::Kind::primarySuspension, "primary suspension");
  suspension.add({{x, 1.0}, {model.sprungX, -1.0}}, d.suspension.longitudinalStiffness,
                 d.suspension.longitudinalDamping);
  suspension.add({{z, 1.0}, {model.sprungZ, -1.0}}, d.suspension.stiffness, d.suspension.damping);
  model.forceElements.push_back(std::move(suspension));
}

void fillSlots(const Model& model, forces::ForceElements& set) {
  set.forceSlot.clear();
  for (const auto index : set.unknown) set.forceSlot.push_back(forceSlot(model, index));
}

}  // namespace

void layOutForces(Model& model) {
  std::vector<std::vector<char>> wanted;
  for (const auto& block : model.blocks) wanted.emplace_back(block.nodes, 0);
  const auto mark = [&](int block, const std::vector<int>& nodes) {
    for (const int node : nodes) wanted[block][node] = 1;
  };
  mark(model.rail, railBase(model.blocks[model.rail]));
  mark(model.rail, model.surfaces.railLine);
  mark(model.rim, model.surfaces.treadLine);
  mark(model.body, model.bearing.nodes);
  mark(model.body, model.hub.nodes);
  for (const auto& tie : model.ties) {
    mark(tie.slaveBlock, tie.slaveNodes);
    for (const auto& column : tie.columns) {
      mark(tie.masterBlock, {column.outer});
      if (column.inner >= 0) mark(tie.masterBlock, {column.inner});
    }
  }
  if (model.scenario.track.railEnds == scenario::RailEnds::absorbing)
    std::fill(wanted[model.rail].begin(), wanted[model.rail].end(), 1);
  for (const auto& unknown : model.movedElements.unknown)
    for (const auto index : unknown) wanted[model.rail][model.blocks[model.rail].unknownAt(index).node] = 1;
  mark(model.rail, plasticity::layerNodes(model.layer));
  for (int i = 0; i < model.sleepers; ++i) {
    const int block = model.firstSleeper + i;
    mark(block, sleeperFace(model.blocks[block], 0));
    mark(block, sleeperFace(model.blocks[block], -model.scenario.sleeper.height));
    if (!model.blocks[block].extent.empty()) std::fill(wanted[block].begin(), wanted[block].end(), 1);
  }
  model.loaded.clear();
  model.forceSize = 0;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    LoadedNodes loaded;
    loaded.offset = model.forceSize;
    for (const char yes : wanted[b]) loaded.lineOfNode.push_back(yes ? loaded.count++ : -1);
    model.forceSize += static_cast<std::size_t>(loaded.count) * 3 * model.blocks[b].stride;
    model.loaded.push_back(std::move(loaded));
  }
  model.forceSize += auxiliaryUnknowns;
}

std::size_t forceSlot(const Model& model, std::size_t index) {
  if (index >= model.firstAuxiliary) return model.forceSize - auxiliaryUnknowns + (index - model.firstAuxiliary);
  std::size_t b = 0;
  while (b + 1 < model.blocks.size() && model.blocks[b + 1].offset <= index) ++b;
  const auto& block = model.blocks[b];
  const auto at = block.unknownAt(index);
  const int triple = model.loaded[b].lineOfNode[at.node];
  if (triple < 0) throw std::logic_error("a spring acts on a node without a force line");
  return model.loaded[b].offset + (static_cast<std::size_t>(triple) * 3 + at.component) * block.stride + at.station;
}

void addSupports(Model& model) {
  addBallast(model);
  addPads(model);
}

void addForceElements(Model& model) {
  auto& sets = model.forceElements;
  addSupports(model);
  if (model.scenario.track.railEnds == scenario::RailEnds::absorbing) sets.push_back(absorbingEnds(model));
  addVehicle(model);
  for (auto& set : sets) fillSlots(model, set);
}

void fixRailEnds(Model& model) {
  if (model.scenario.track.railEnds != scenario::RailEnds::clamped) return;
  const auto& rail = model.blocks[model.rail];
  for (const int station : {0, rail.stationCount - 1})
    for (int n = 0; n < rail.nodes; ++n)
      for (int c = 0; c < 3; ++c) model.fixed.push_back(rail.index(n, c, station));
}

}  // namespace squat::model
