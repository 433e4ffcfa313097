#include "model/WheelsetModes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/DenseAlgebra.h"
#include "core/ElementaryFunctions.h"
#include "elasticity/StandingWave.h"
#include "geometry/WheelSection.h"
#include "model/CentrePlane.h"
#include "model/Rings.h"
#include "scenario/WheelsetMass.h"

namespace squat::model {

namespace {

constexpr int sectors = 48;
constexpr double sectionSize = 0.016;  // [m]

elasticity::SweptBlock wholeWheelset(const scenario::Wheelset& w) {
  elasticity::SweptBlock block;
  block.name = "wheelset";
  block.kind = elasticity::SweepKind::aroundAxis;
  block.section = geometry::wheelBodySectionMesh(w, {sectionSize, 0, sectionSize, 1.5, 0});
  block.material = w.material;
  block.stations = {0, true, {{sectors, 2 * std::numbers::pi / sectors}}};
  elasticity::prepareBlock(block);
  return block;
}

void addMass(std::vector<double>& mass, const Ring& ring, double total) {
  for (std::size_t i = 0; i < ring.nodes.size(); ++i) mass[ring.nodes[i]] += total * ring.weight[i] / sectors;
}

// Vertical mean motion of a ring for u_r = b cos(alpha), u_alpha = a sin(alpha): (a - b) / 2.
template <typename Shape>
double ringShare(const Ring& ring, const Shape& shape) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.nodes.size(); ++i)
    sum += ring.weight[i] * 0.5 * (shape[3 * ring.nodes[i]] - shape[3 * ring.nodes[i] + 1]);
  return sum;
}

// A spring between the ring's mean motion and the box, as a share of each sector: as in BuildForceElements.cpp, in the
// amplitudes of one harmonic and undamped.
void addBearing(Eigen::MatrixXd& matrix, const Ring& bearing, int box, double stiffness) {
  std::vector<std::pair<int, double>> terms{{box, -1.0}};
  for (std::size_t i = 0; i < bearing.nodes.size(); ++i) {
    terms.push_back({3 * bearing.nodes[i], 0.5 * bearing.weight[i]});
    terms.push_back({3 * bearing.nodes[i] + 1, -0.5 * bearing.weight[i]});
  }
  for (const auto& [i, a] : terms)
    for (const auto& [j, b] : terms) matrix(i, j) += stiffness * a * b;
}

struct Lowest {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// Eigenpairs of a symmetric matrix below a limit, ascending: subspace iteration with Rayleigh and Ritz, a dozen times
// quicker than all pairs. The shift takes care of rigid motions; the subspace is far larger than what is asked for.
Lowest lowestPairs(const Eigen::MatrixXd& matrix, double limit) {
  const Eigen::Index size = matrix.rows();
  Eigen::MatrixXd shifted = matrix;
  shifted.diagonal().array() += 0.05 * limit;
  const algebra::PositiveFactor factor(shifted);
  for (Eigen::Index count = std::min<Eigen::Index>(40, size);; count = std::min(2 * count, size)) {
    Eigen::MatrixXd basis(size, count);
    for (Eigen::Index j = 0; j < count; ++j)
      for (Eigen::Index i = 0; i < size; ++i) basis(i, j) = elementary::sin(1.0 + static_cast<double>(i * (2 * j + 3)));
    Lowest found;
    Eigen::VectorXd before = Eigen::VectorXd::Zero(count);
    for (int k = 0; k < 60; ++k) {
      basis = factor.solve(basis);
      const Eigen::MatrixXd q = algebra::orthonormalColumns(basis);
      const auto ritz = algebra::symmetricEigenPairs(q.transpose() * matrix * q);
      basis = q * ritz.vectors;
      found.values = ritz.values;
      const Eigen::Index inside = (found.values.array() < limit).count();
      if (((found.values - before).head(inside).array().abs() < 1e-8 * limit).all()) break;
      before = found.values;
    }
    const Eigen::Index inside = (found.values.array() < limit).count();
    if (2 * inside > count && count < size) continue;
    found.values.conservativeResize(inside);
    found.vectors = basis.leftCols(inside);
    return found;
  }
}

}  // namespace

WheelsetShapes wheelsetShapes(const scenario::Scenario& d, double highest, int lastHarmonic, Centre centre) {
  const auto& w = d.wheelset;
  const auto block = wholeWheelset(w);
  const auto lumped = elasticity::lumpedMass(block);
  std::vector<double> mass(block.nodes);
  double solid = 0;
  for (int n = 0; n < block.nodes; ++n) mass[n] = lumped[n * block.stride], solid += sectors * mass[n];
  const auto bearing =
      seatRing(block, 0, w.journalRadius, w.bearingCentre - w.bearingWidth / 2, w.bearingCentre + w.bearingWidth / 2);
  const auto wheelCentre = sectionRing(block, 0, geometry::seatLineRadius(w), 0);
  const auto tread = sectionRing(block, 0, w.radius, 0);
  const bool onSpring = w.bearingStiffness > 0;
  if (!onSpring) addMass(mass, bearing, w.axleBoxMass);
  for (const auto& disc : discRings(w, block, 0)) addMass(mass, disc, w.brakeDiscMass);
  addMass(mass, axleMassRing(w, block, 0),
          std::max(0.0, w.totalMass - w.axleBoxMass - solid - scenario::brakeDiscsMass(w)));

  const auto interval = elasticity::intervalMatrices(block, 0);
  const auto mayMove = centreMask(w, block, centre);
  WheelsetShapes shapes;
  shapes.section = block.section;
  for (const double each : mass) shapes.mass.push_back(sectors * each);
  for (int harmonic = 0; harmonic <= lastHarmonic; ++harmonic) {
    // Half the circumference's mean of cos^2 for n > 0; the whole for n = 0.
    const double whole = (harmonic == 0 ? 1.0 : 0.5) * sectors;
    const int boxAt = 3 * block.nodes, size = boxAt + 1;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    matrix.topLeftCorner(boxAt, boxAt) =
        elasticity::standingWaveStiffness(interval, harmonic * std::numbers::pi / sectors);
    std::vector<double> inertia(size, w.axleBoxMass / whole);
    for (int i = 0; i < boxAt; ++i) inertia[i] = mass[i / 3];
    std::vector<int> kept;
    for (int n = 0; n < block.nodes; ++n)
      for (int component = 0; component < 3; ++component)
        if (mayMove[3 * n + component] != 0) kept.push_back(3 * n + component);
    if (onSpring && harmonic == 1) {
      addBearing(matrix, bearing, boxAt, w.bearingStiffness / whole);
      kept.push_back(boxAt);
    }
    Eigen::MatrixXd scaled(kept.size(), kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (std::size_t j = 0; j < kept.size(); ++j)
        scaled(i, j) = matrix(kept[i], kept[j]) / std::sqrt(inertia[kept[i]] * inertia[kept[j]]);
    const auto lowest = lowestPairs(scaled, std::pow(2 * std::numbers::pi * highest, 2));
    for (Eigen::Index k = 0; k < lowest.values.size(); ++k) {
      const double frequency = std::sqrt(std::max(0.0, lowest.values[k])) / (2 * std::numbers::pi);
      if (frequency < 1) continue;  // rigid
      ModeShape found;
      found.shape.assign(size, 0.0);
      for (std::size_t i = 0; i < kept.size(); ++i)
        found.shape[kept[i]] = lowest.vectors(static_cast<Eigen::Index>(i), k) / std::sqrt(inertia[kept[i]] * whole);
      found.box = found.shape[boxAt];
      found.shape.resize(boxAt);
      found.mode = {frequency, harmonic, 0, 0, 0, 0, centre};
      if (harmonic > 0) {
        for (int n = 0; n < block.nodes; ++n)
          found.mode.stays -= 2 * whole * mass[n] * found.shape[3 * n] * found.shape[3 * n + 1];
        found.mode.stays += w.axleBoxMass * found.box * found.box;
      }
      if (harmonic == 1) {
        found.mode.boxAmplitude = onSpring ? found.box : ringShare(bearing, found.shape);
        found.mode.wheelAmplitude = ringShare(wheelCentre, found.shape);
      }
      for (std::size_t i = 0; i < tread.nodes.size(); ++i) {
        found.mode.contactAmplitude -= tread.weight[i] * found.shape[3 * tread.nodes[i] + 1];
        found.mode.lateralAmplitude += tread.weight[i] * found.shape[3 * tread.nodes[i] + 2];
      }
      shapes.modes.push_back(std::move(found));
    }
  }
  std::sort(shapes.modes.begin(), shapes.modes.end(),
            [](const auto& a, const auto& b) { return a.mode.frequency < b.mode.frequency; });
  return shapes;
}

std::vector<HarmonicMode> wheelsetModes(const scenario::Scenario& d, double highest, int lastHarmonic, Centre centre) {
  std::vector<HarmonicMode> modes;
  for (const auto& found : wheelsetShapes(d, highest, lastHarmonic, centre).modes) modes.push_back(found.mode);
  return modes;
}

std::vector<HarmonicMode> allWheelsetModes(const scenario::Scenario& d, double highest, int lastHarmonic) {
  auto modes = wheelsetModes(d, highest, lastHarmonic);
  const auto others = wheelsetModes(d, highest, lastHarmonic, Centre::antisymmetric);
  modes.insert(modes.end(), others.begin(), others.end());
  std::stable_sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace squat::model
