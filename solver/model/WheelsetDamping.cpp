#include "model/WheelsetDamping.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/DenseAlgebra.h"
#include "core/ElementaryFunctions.h"
#include "model/WheelsetModes.h"

namespace squat::model {

namespace {

constexpr double kicksInPeriod = 20;  // of the highest damped mode
constexpr Eigen::Index chunk = elasticity::SweptBlock::chunk;
constexpr double pi = 3.14159265358979323846;

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::Index chunksOf(const elasticity::SweptBlock& block) {
  return static_cast<Eigen::Index>(block.size() / block.chunkSize());
}

struct Location {
  int quad = 0;
  double weight[4] = {0, 0, 0, 0};
};

// The quad of a section in which a point lies, with the bilinear weights of its corners; where none holds it, the one
// that misses it least.
Location locate(const geometry::SectionMesh& section, const geometry::Point2& p) {
  Location best;
  double minimum = 1e30;
  for (int q = 0; q < static_cast<int>(section.quads.size()); ++q) {
    const geometry::Point2* corner[4];
    for (int i = 0; i < 4; ++i) corner[i] = &section.nodes[section.quads[q][i]];
    double u = 0.5, v = 0.5;
    for (int k = 0; k < 8; ++k) {
      const double w[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
      const double du[4] = {v - 1, 1 - v, v, -v}, dv[4] = {u - 1, -u, u, 1 - u};
      double at[2] = {-p[0], -p[1]}, au[2] = {0, 0}, av[2] = {0, 0};
      for (int i = 0; i < 4; ++i)
        for (int c = 0; c < 2; ++c)
          at[c] += w[i] * (*corner[i])[c], au[c] += du[i] * (*corner[i])[c], av[c] += dv[i] * (*corner[i])[c];
      const double det = au[0] * av[1] - au[1] * av[0];
      u -= (at[0] * av[1] - at[1] * av[0]) / det, v -= (au[0] * at[1] - au[1] * at[0]) / det;
    }
    const double outside = std::max({0.0, -u, u - 1, -v, v - 1});
    if (outside >= minimum) continue;
    minimum = outside;
    u = std::clamp(u, 0.0, 1.0), v = std::clamp(v, 0.0, 1.0);
    best = {q, {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}};
    if (minimum == 0) break;
  }
  return best;
}

std::vector<double> interpolated(const elasticity::SweptBlock& block, const std::vector<Location>& locations,
                                 const geometry::SectionMesh& section, const std::vector<double>& shape,
                                 const std::vector<double>& freeMask) {
  std::vector<double> values(3 * static_cast<std::size_t>(block.nodes), 0.0);
  for (int n = 0; n < block.nodes; ++n)
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < 3; ++c)
        values[3 * n + c] +=
            freeMask[3 * n + c] * locations[n].weight[i] * shape[3 * section.quads[locations[n].quad][i] + c];
  return values;
}

// Columns of the waves that a vector uses for u_alpha and for u_r, u_y; the sign belongs to u_alpha.
struct WaveUse {
  int alpha = 0, other = 0;
  double sign = 1;
};
WaveUse waveUse(int harmonic, bool turned) {
  if (harmonic == 0) return {0, 0, 1};
  const int cosine = 2 * harmonic - 1, sine = 2 * harmonic;
  return turned ? WaveUse{cosine, sine, -1} : WaveUse{sine, cosine, 1};
}

struct RigidMotion {
  int harmonic = 0;
  std::vector<double> shape;  // as of ModeShape
  double box = 0;
};

// Of symmetric halves: rotation; up and down with its pair along the track. Of antisymmetric ones: sideways; roll about
// the track centre, up by the distance from it and outwards by the height below the axis, with its pair, yaw.
std::vector<RigidMotion> rigidMotions(const scenario::Wheelset& w, const geometry::SectionMesh& section,
                                      Centre centre) {
  const std::size_t nodes = section.nodes.size();
  std::vector<double> around(3 * nodes, 0.0), upwards(3 * nodes, 0.0);
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto [radius, y] = section.nodes[n];
    const bool alike = centre == Centre::symmetric;
    const double lift = alike ? 1 : y + w.trackCentre;
    if (alike)
      around[3 * n] = radius;
    else
      around[3 * n + 2] = 1, upwards[3 * n + 2] = radius;
    upwards[3 * n] = lift, upwards[3 * n + 1] = -lift;
  }
  return {{0, around, 0}, {1, upwards, centre == Centre::symmetric ? 1 : w.bearingCentre + w.trackCentre}};
}

}  // namespace

WheelsetDamping::WheelsetDamping(const Model& model, double step, Centre centre) : model_(model) {
  const auto& w = model.scenario.wheelset;
  if (w.dampingRatio <= 0) return;
  WheelsetShapes shapes;
  int harmonics = 0;
  // Up to the harmonic that has no mode below the limit; plates and rings get stiffer with each.
  for (harmonics = 3;; ++harmonics) {
    shapes = wheelsetShapes(model.scenario, w.dampingLimit, harmonics, centre);
    if (std::none_of(shapes.modes.begin(), shapes.modes.end(),
                     [&](const ModeShape& m) { return m.mode.harmonic == harmonics; }))
      break;
  }
  if (shapes.modes.empty()) return;
  // Kicks come faster than the samples of the output, so that none of their lines falls among the signals.
  const double rate = std::max(kicksInPeriod * w.dampingLimit, 2 * model.scenario.output.rate);
  every_ = std::max(1L, static_cast<long>(1 / rate / step));
  const double between = static_cast<double>(every_) * step;

  const int indices[2] = {model.rim, model.body};
  std::vector<Location> locations[2];
  for (int b = 0; b < 2; ++b) {
    const auto& block = model.blocks[indices[b]];
    blocks_[b] = {indices[b], MatrixXd::Zero(chunk * chunksOf(block), 2 * harmonics + 1)};
    for (int s = 0; s < block.stationCount; ++s) {
      blocks_[b].waves(s, 0) = 1;
      for (int n = 1; n <= harmonics; ++n) {
        blocks_[b].waves(s, 2 * n - 1) = elementary::cos(n * block.positions[s]);
        blocks_[b].waves(s, 2 * n) = elementary::sin(n * block.positions[s]);
      }
    }
    for (const auto& p : block.section.nodes) locations[b].push_back(locate(shapes.section, p));
  }
  std::vector<double> masks[2];
  for (int b = 0; b < 2; ++b)
    masks[b] = centreMask(w, model.blocks[indices[b]], indices[b] == model.body ? centre : Centre::shared);
  const auto vectorOf = [&](int harmonic, const std::vector<double>& shape, double box) {
    Vector vector{harmonic, false, box, {}};
    for (int b = 0; b < 2; ++b)
      vector.amplitude[b] = interpolated(model.blocks[indices[b]], locations[b], shapes.section, shape, masks[b]);
    return vector;
  };
  for (const auto& rigid : rigidMotions(w, shapes.section, centre))
    addPair(vectorOf(rigid.harmonic, rigid.shape, rigid.box));
  const auto rigid = static_cast<Eigen::Index>(vectors_.size());
  for (const auto& m : shapes.modes) {
    addPair(vectorOf(m.mode.harmonic, m.shape, m.box));
    const double taken = 1 - elementary::exp(-2 * w.dampingRatio * 2 * pi * m.mode.frequency * between);
    rate_.resize(vectors_.size() - static_cast<std::size_t>(rigid), taken);
    frequency_.resize(rate_.size(), m.mode.frequency);
  }

  // Gram matrix of all vectors in the masses of this model; the modes are freed of rigid motion and made orthonormal
  // with the least change (Loewdin 1950).
  const auto all = static_cast<Eigen::Index>(vectors_.size()), flexible = all - rigid;
  MatrixXd gram(all, all);
  AlignedVector field(model.stateSize, 0.0);
  for (Eigen::Index j = 0; j < all; ++j) {
    std::fill(field.begin(), field.end(), 0.0);
    double boxX = 0, boxZ = 0;
    add(VectorXd::Unit(all, j), field.data(), boxX, boxZ);
    gram.col(j) = project(field.data(), boxX, boxZ);
  }
  gram = (0.5 * (gram + gram.transpose())).eval();
  const MatrixXd removal = algebra::solveSymmetric(MatrixXd(gram.topLeftCorner(rigid, rigid)),
                                                   MatrixXd(gram.topRightCorner(rigid, flexible)));
  const MatrixXd own = gram.bottomRightCorner(flexible, flexible) - gram.bottomLeftCorner(flexible, rigid) * removal;
  const MatrixXd root = algebra::inverseSquareRoot(own);
  MatrixXd freed(all, flexible);  // columns: modes without rigid motion, in vectors
  freed << -removal, MatrixXd::Identity(flexible, flexible);
  toKick_ = freed * root;
  toModes_ = toKick_.transpose();
}

void WheelsetDamping::addPair(const Vector& first) {
  vectors_.push_back(first);
  if (first.harmonic == 0) return;
  vectors_.push_back(first);
  vectors_.back().turned = true;
}

VectorXd WheelsetDamping::project(const double* velocity, double boxX, double boxZ) {
  VectorXd components = VectorXd::Zero(static_cast<Eigen::Index>(vectors_.size()));
  for (int b = 0; b < 2; ++b) {
    const auto& block = model_.blocks[blocks_[b].index];
    const auto& mass = model_.mass[blocks_[b].index];
    field_.setZero(blocks_[b].waves.cols(), 3 * block.nodes);
    weighed_.setZero(chunk, 3 * block.nodes);
    for (Eigen::Index k = 0; k < chunksOf(block); ++k) {
      const Map<const MatrixXd> v(velocity + block.offset + static_cast<std::size_t>(k) * block.chunkSize(), chunk,
                                  3 * block.nodes);
      const Eigen::Index rows = std::min(chunk, static_cast<Eigen::Index>(block.stride) - k * chunk);
      for (int n = 0; n < block.nodes; ++n) {
        const Map<const VectorXd> m(mass.data() + static_cast<std::size_t>(n) * block.stride + k * chunk, rows);
        for (int c = 0; c < 3; ++c) weighed_.col(3 * n + c).head(rows) = v.col(3 * n + c).head(rows).cwiseProduct(m);
      }
      field_.noalias() += blocks_[b].waves.middleRows(k * chunk, rows).transpose() * weighed_.topRows(rows);
    }
    for (std::size_t j = 0; j < vectors_.size(); ++j) {
      const auto& vector = vectors_[j];
      const auto use = waveUse(vector.harmonic, vector.turned);
      const auto& f = vector.amplitude[b];
      double sum = 0;
      for (int n = 0; n < block.nodes; ++n)
        sum += use.sign * f[3 * n] * field_(use.alpha, 3 * n) + f[3 * n + 1] * field_(use.other, 3 * n + 1) +
               f[3 * n + 2] * field_(use.other, 3 * n + 2);
      components[static_cast<Eigen::Index>(j)] += sum;
    }
  }
  if (model_.boxOnSpring())
    for (std::size_t j = 0; j < vectors_.size(); ++j)
      components[static_cast<Eigen::Index>(j)] +=
          model_.scenario.wheelset.axleBoxMass * vectors_[j].box * (vectors_[j].turned ? -boxX : boxZ);
  return components;
}

void WheelsetDamping::add(const VectorXd& amounts, double* velocity, double& boxX, double& boxZ) {
  for (int b = 0; b < 2; ++b) {
    const auto& block = model_.blocks[blocks_[b].index];
    field_.setZero(blocks_[b].waves.cols(), 3 * block.nodes);
    for (std::size_t j = 0; j < vectors_.size(); ++j) {
      const auto& vector = vectors_[j];
      const auto use = waveUse(vector.harmonic, vector.turned);
      const double amount = amounts[static_cast<Eigen::Index>(j)];
      const auto& f = vector.amplitude[b];
      for (int n = 0; n < block.nodes; ++n) {
        field_(use.alpha, 3 * n) += use.sign * amount * f[3 * n];
        field_(use.other, 3 * n + 1) += amount * f[3 * n + 1];
        field_(use.other, 3 * n + 2) += amount * f[3 * n + 2];
      }
    }
    for (Eigen::Index k = 0; k < chunksOf(block); ++k) {
      Map<MatrixXd> v(velocity + block.offset + static_cast<std::size_t>(k) * block.chunkSize(), chunk,
                      3 * block.nodes);
      v.noalias() += blocks_[b].waves.middleRows(k * chunk, chunk) * field_;
    }
  }
  for (std::size_t j = 0; j < vectors_.size(); ++j)
    (vectors_[j].turned ? boxX : boxZ) +=
        (vectors_[j].turned ? -1 : 1) * amounts[static_cast<Eigen::Index>(j)] * vectors_[j].box;
}

void WheelsetDamping::addMode(int mode, double amount, double* velocity) {
  double boxX = 0, boxZ = 0;
  add(amount * toKick_.col(mode), velocity, boxX, boxZ);
  if (model_.boxOnSpring()) velocity[model_.boxX] += boxX, velocity[model_.boxZ] += boxZ;
}

double WheelsetDamping::apply(double rotation, double* velocity) {
  // The modes turn with the wheel: the box's velocity in axes that turn as well.
  const double c = elementary::cos(rotation), s = elementary::sin(rotation);
  double boxX = 0, boxZ = 0;
  if (model_.boxOnSpring()) {
    const double x = velocity[model_.boxX], z = velocity[model_.boxZ];
    boxX = c * x - s * z, boxZ = s * x + c * z;
  }
  VectorXd modal = toModes_ * project(velocity, boxX, boxZ);
  double energy = 0;
  for (Eigen::Index k = 0; k < modal.size(); ++k) {
    const double taken = rate_[static_cast<std::size_t>(k)];
    energy += 0.5 * taken * (2 - taken) * modal[k] * modal[k];
    modal[k] *= -taken;
  }
  boxX = boxZ = 0;
  add(toKick_ * modal, velocity, boxX, boxZ);
  if (model_.boxOnSpring()) velocity[model_.boxX] += c * boxX + s * boxZ, velocity[model_.boxZ] += c * boxZ - s * boxX;
  return energy;
}

}  // namespace squat::model
