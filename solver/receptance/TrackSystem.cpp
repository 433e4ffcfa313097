#include "receptance/TrackSystem.h"

#include <algorithm>

#include "elasticity/StandingWave.h"
#include "geometry/Stations.h"
#include "receptance/TrackLosses.h"

namespace squat::receptance {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;
using Terms = std::vector<std::pair<std::size_t, double>>;

constexpr int vertical = 2;      // component of a block swept along x
constexpr double fixing = 1e14;  // [N/m] of fixed degrees of freedom: far above any element, far from round-off

// Groups of all stations of the track, before anything is assembled: one for each family of shapes of a station.
Groups groupsOf(const model::Model& model, const std::vector<int>& railFamilies) {
  Groups groups;
  for (int s = 0; s < model.blocks[model.rail].stationCount; ++s)
    for (const int size : railFamilies) groups.add(size);
  for (int i = 0; i < model.sleepers; ++i) {
    const auto& block = model.blocks[model.firstSleeper + i];
    for (int s = 0; s < block.stationCount; ++s) groups.add(3 * block.nodes);
  }
  return groups;
}

bool isSleeperCentre(const model::Model& model, std::size_t index) {
  for (int i = 0; i < model.sleepers; ++i) {
    const auto& sleeper = model.blocks[model.firstSleeper + i];
    if (index >= sleeper.offset && index < sleeper.offset + sleeper.size() && sleeper.unknownAt(index).station == 0)
      return true;
  }
  return false;
}

}  // namespace

std::vector<TrackSymmetry> symmetriesOf(StruckRails rails) {
  if (rails == StruckRails::both) return {TrackSymmetry::symmetric};
  return {TrackSymmetry::symmetric, TrackSymmetry::antisymmetric};
}

TrackSystem::TrackSystem(const model::Model& model, const SectionShapes& railShapes, TrackSymmetry symmetry)
    : model_(model),
      groups_(groupsOf(model, railShapes.families)),
      stiffness_(trackParts, BlockMatrix(groups_)),
      damping_(trackParts, BlockMatrix(groups_)),
      mass_(groups_) {
  parts_.push_back({model.rail, 0, railShapes});
  int next = model.blocks[model.rail].stationCount * static_cast<int>(railShapes.families.size());
  for (int i = 0; i < model.sleepers; ++i) {
    const auto& block = model.blocks[model.firstSleeper + i];
    parts_.push_back({model.firstSleeper + i, next, allShapes(block)});
    next += block.stationCount;
  }
  for (const auto& part : parts_) addBlock(part);
  for (const auto& set : model.forceElements) addForceElements(set);
  for (const auto index : model.fixed)
    if (!isSleeperCentre(model, index)) fix(index);
  fixCentre(symmetry);
}

std::vector<HarmonicTerm> TrackSystem::terms() const { return termsOf(true); }
std::vector<HarmonicTerm> TrackSystem::termsWithoutPads() const { return termsOf(false); }

std::vector<HarmonicTerm> TrackSystem::termsOf(bool pads) const {
  const auto losses = trackLosses(model_.scenario);
  std::vector<HarmonicTerm> sum;
  for (std::size_t part = 0; part < trackParts; ++part) {
    const auto which = static_cast<TrackPart>(part);
    if (!pads && (which == TrackPart::padsVertical || which == TrackPart::padsHorizontal)) continue;
    const auto& loss = losses[part];
    sum.push_back({&stiffness_[part], loss ? loss : [](double) { return Complex(1); }});
    if (!loss) sum.push_back({&damping_[part], [](double omega) { return Complex(0, omega); }});
  }
  sum.push_back({&mass_, [](double omega) { return Complex(-omega * omega); }});
  return sum;
}

std::vector<int> TrackSystem::railStation(int station) const {
  const int families = static_cast<int>(parts_.front().shapes.families.size());
  std::vector<int> groups;
  for (int f = 0; f < families; ++f) groups.push_back(station * families + f);
  return groups;
}

std::vector<int> TrackSystem::lastStation() const { return railStation(model_.blocks[model_.rail].stationCount - 1); }

// Along the sleeper nothing moves in its middle, or nothing but that does.
void TrackSystem::fixCentre(TrackSymmetry symmetry) {
  for (int i = 0; i < model_.sleepers; ++i) {
    const auto& sleeper = model_.blocks[model_.firstSleeper + i];
    for (int n = 0; n < sleeper.nodes; ++n)
      for (int c = 0; c < 3; ++c)
        if ((c == 0) == (symmetry == TrackSymmetry::symmetric)) fix(sleeper.index(n, c, 0));
  }
}

void TrackSystem::addBlock(const Part& part) {
  const auto& block = model_.blocks[part.block];
  const int families = static_cast<int>(part.shapes.families.size());
  auto& solid = stiffness(part.block == model_.rail ? TrackPart::rail : TrackPart::sleepers);
  for (std::size_t r = 0; r < block.stations.runs.size(); ++r) {
    const auto interval = elasticity::intervalMatrices(block, static_cast<int>(r));
    const double half = 0.5 * block.stations.runs[r].length;
    for (int f = 0, column = 0; f < families; column += part.shapes.families[f], ++f) {
      const MatrixXd shapes = part.shapes.shapes.middleCols(column, part.shapes.families[f]);
      const VectorXd turn = part.shapes.turn.segment(column, part.shapes.families[f]);
      const MatrixXd s = shapes.transpose() * interval.s * shapes, t = shapes.transpose() * interval.t * shapes;
      // Sums and differences written out: right-right S + T, left-left its mirror image, left-right J (S - T).
      const MatrixXd right = s + t, left = turn.asDiagonal() * right * turn.asDiagonal();
      const MatrixXd across = turn.asDiagonal() * (s - t);
      for (int i = block.runIntervals[r][0]; i < block.runIntervals[r][1]; ++i) {
        const int g = part.firstGroup + i * families + f, next = g + families;
        solid.block(g, g) += left;
        solid.block(g, next) += across;
        solid.block(next, next) += right;
        if (block.extent.empty())
          for (const int k : {g, next}) mass_.block(k, k).diagonal().array() += half;
      }
    }
  }
  if (!block.extent.empty()) addHeight(part);
}

// A sleeper of unequal height: what it changes in the stiffness, and masses that differ from station to station. Each
// of its shapes is a single unknown.
void TrackSystem::addHeight(const Part& part) {
  const auto& block = model_.blocks[part.block];
  Eigen::VectorXi column(3 * block.nodes);
  VectorXd scale(3 * block.nodes);
  for (Index row = 0; row < column.size(); ++row) {
    Index at = 0;
    part.shapes.shapes.row(row).cwiseAbs().maxCoeff(&at);
    column[row] = static_cast<int>(at), scale[row] = part.shapes.shapes(row, at);
  }
  const auto& shape = model_.sleeperShape;
  for (std::size_t e = 0; e < shape.size(); ++e)
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) {
        const auto to = block.unknownAt(shape.unknown[e][i] + block.offset);
        const auto from = block.unknownAt(shape.unknown[e][j] + block.offset);
        if (to.station > from.station) continue;
        const int row = 3 * to.node + to.component, other = 3 * from.node + from.component;
        stiffness(TrackPart::sleepers)
            .block(part.firstGroup + to.station, part.firstGroup + from.station)(column[row], column[other]) +=
            scale[row] * scale[other] * shape.difference[576 * e + 24 * i + j];
      }
  const auto mass = elasticity::lumpedMass(block);
  for (int s = 0; s < block.stationCount; ++s)
    for (int row = 0; row < 3 * block.nodes; ++row)
      mass_.block(part.firstGroup + s, part.firstGroup + s)(column[row], column[row]) +=
          scale[row] * scale[row] * mass[row / 3 * block.stride + s];
}

std::map<int, VectorXd> TrackSystem::pieces(const Terms& terms) const {
  std::map<int, VectorXd> result;
  for (const auto& [index, weight] : terms) {
    const auto part = std::find_if(parts_.begin(), parts_.end(), [&, wanted = index](const Part& p) {
      const auto& block = model_.blocks[p.block];
      return wanted >= block.offset && wanted < block.offset + block.size();
    });
    if (part == parts_.end()) continue;
    const auto& block = model_.blocks[part->block];
    const auto at = block.unknownAt(index);
    const auto& families = part->shapes.families;
    int group = part->firstGroup + at.station * static_cast<int>(families.size()), column = 0;
    for (const int size : families) {
      auto [entry, fresh] = result.try_emplace(group);
      if (fresh) entry->second = VectorXd::Zero(size);
      entry->second += weight * part->shapes.shapes.row(3 * at.node + at.component).segment(column, size).transpose();
      ++group, column += size;
    }
  }
  return result;
}

VectorXd TrackSystem::whole(const std::map<int, VectorXd>& pieces) const {
  VectorXd all = VectorXd::Zero(groups_.unknowns());
  for (const auto& [group, values] : pieces) all.segment(groups_.first[group], groups_.size[group]) = values;
  return all;
}

// By their tangents at rest; elements of the vehicle act on nothing that is in this system.
void TrackSystem::addForceElements(const forces::ForceElements& set) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto element = pieces(set.terms(i));
    if (element.empty()) continue;
    const TrackPart part = partOf(set, i);
    stiffness(part).addOuter(element, set.tangent(i, 0));
    damping(part).addOuter(element, set.activeDamping(i, 0));
  }
}

// A pad's springs begin with their terms on the rail.
TrackPart TrackSystem::partOf(const forces::ForceElements& set, std::size_t element) const {
  if (set.kind == forces::Kind::ballast) return TrackPart::ballast;
  if (set.kind != forces::Kind::railPad) return TrackPart::others;
  const auto first = set.unknown[set.start[element]];
  return model_.blocks[model_.rail].unknownAt(first).component == vertical ? TrackPart::padsVertical
                                                                           : TrackPart::padsHorizontal;
}

void TrackSystem::fix(std::size_t index) { stiffness(TrackPart::others).addOuter(pieces({{index, 1.0}}), fixing); }

VectorXd TrackSystem::load(double position, double side) const {
  constexpr int points = 8;  // each way: even pressure
  const auto& rail = model_.blocks[model_.rail];
  Terms terms;
  for (int p = 0; p < points; ++p)
    for (int q = 0; q < points; ++q) {
      const auto [s, u] = geometry::intervalOf(rail.positions, position + ((p + 0.5) / points - 0.5) * side);
      const auto [j, v] = geometry::intervalOf(model_.surfaces.railY, ((q + 0.5) / points - 0.5) * side);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          terms.push_back({rail.index(model_.surfaces.railLine[j + a], vertical, s + b),
                           -(a ? v : 1 - v) * (b ? u : 1 - u) / (points * points)});
    }
  return whole(pieces(terms));
}

// Along a direction in the rail's own axes, of all that lies above `lowest` in the section.
VectorXd TrackSystem::meanOf(double position, double lowest, const Eigen::Vector3d& direction) const {
  const auto& rail = model_.blocks[model_.rail];
  const auto [s, u] = geometry::intervalOf(rail.positions, position);
  const auto& mass = model_.mass[model_.rail];
  const auto counts = [&](int n) { return rail.section.nodes[static_cast<std::size_t>(n)][1] >= lowest; };
  double sum = 0;
  for (int n = 0; n < rail.nodes; ++n)
    if (counts(n)) sum += mass[n * rail.stride + s];
  Terms terms;
  for (int n = 0; n < rail.nodes; ++n)
    for (int b = 0; b < 2 && counts(n); ++b)
      for (int c = 1; c < 3; ++c)
        if (direction[c] != 0)
          terms.push_back({rail.index(n, c, s + b), direction[c] * mass[n * rail.stride + s] / sum * (b ? u : 1 - u)});
  return whole(pieces(terms));
}

VectorXd TrackSystem::sleeperSeat() const {
  constexpr int points = 8;  // each way
  const auto& sleeper = model_.blocks[model_.firstSleeper];
  const auto& pad = model_.scenario.pad;
  const auto top = geometry::nodesWhere(
      sleeper.section, [](const geometry::Point2& p) { return std::abs(p[0]) < 1e-9; }, 1);
  std::vector<double> across;  // of the sleeper: x
  for (const int node : top) across.push_back(sleeper.section.nodes[node][1]);
  constexpr int upwards = 1;  // component of a block swept along y
  Terms terms;
  for (int p = 0; p < points; ++p)
    for (int q = 0; q < points; ++q) {
      const auto [s, u] = geometry::intervalOf(sleeper.positions, ((p + 0.5) / points - 0.5) * pad.width);
      const auto [j, v] = geometry::intervalOf(across, ((q + 0.5) / points - 0.5) * pad.length);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          terms.push_back(
              {sleeper.index(top[j + a], upwards, s + b), -(a ? v : 1 - v) * (b ? u : 1 - u) / (points * points)});
    }
  return whole(pieces(terms));
}

VectorXd TrackSystem::sectionMean(double position) const { return meanOf(position, -1, {0, 0, -1}); }

VectorXd TrackSystem::headMean(double position, RailDirection direction) const {
  constexpr double head = 0.036;  // [m] what lies above belongs to the head of every section
  const Eigen::Vector3d along =
      direction == RailDirection::vertical ? Eigen::Vector3d{0, 0, -1} : Eigen::Vector3d{0, 1, 0};
  return meanOf(position, -head, along);
}

}  // namespace squat::receptance
