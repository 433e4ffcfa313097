#include "statics/CoarseSpace.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/ElementaryFunctions.h"
#include "core/Errors.h"

namespace squat::statics {

namespace {

// Three translations; roll of the rim about its own centre line; turns of its section about the wheel's axis and about
// the radius, without which hats could not bend the rim.
constexpr int rimHats = 24, rimModes = 6;
constexpr int railShapes = 3;  // more of them save no further iterations
constexpr double full = 6.283185307179586;

// The two hats that cover a place on a line of equally spaced knots.
struct Hats {
  int left = 0;
  double leftShare = 1, rightShare = 0;
};
Hats hatsAt(const std::vector<double>& knots, double at) {
  const double spacing = knots[1] - knots[0], position = (at - knots[0]) / spacing;
  const int k = std::clamp(static_cast<int>(std::floor(position)), 0, static_cast<int>(knots.size()) - 2);
  const double t = std::clamp(position - k, 0.0, 1.0);
  return {k, 1 - t, t};
}

double hat(const std::vector<double>& knots, int k, double at) {
  if (at <= knots[k]) return k == 0 ? 1 : std::max(0.0, (at - knots[k - 1]) / (knots[k] - knots[k - 1]));
  if (k + 1 == static_cast<int>(knots.size())) return 1;
  return std::max(0.0, (knots[k + 1] - at) / (knots[k + 1] - knots[k]));
}

// Shares of the hats around the rim at an angle: hat k and k + 1.
Hats rimHatsAt(double angle) {
  double position = std::fmod(angle / full, 1.0);
  if (position < 0) position += 1;
  position *= rimHats;
  const int k = std::min(static_cast<int>(position), rimHats - 1);
  return {k, 1 - (position - k), position - k};
}

bool isIn(const elasticity::SweptBlock& block, std::size_t index) {
  return index >= block.offset && index < block.offset + block.size();
}

}  // namespace

CoarseSpace::CoarseSpace(const model::Model& model, const model::StaticOperator& op)
    : model_(model), free_(op.freeUnknowns()) {
  // Farther apart than any two stations: none stands where no node is, and none reaches a third knot.
  double longest = 0;
  for (const auto& run : model.blocks[model.rail].stations.runs) longest = std::max(longest, run.length);
  const double spacing = std::max(0.1, 1.05 * longest);
  constexpr int reach = 5;  // rail hats reach two knots and a pad
  addLineGroup(model.rail, spacing, railShapes, 0, reach);
  // A rail hat reaches sleepers on either side, over pads that may stand between two stations.
  const double sleeperReach = 2 * (spacing + longest) / model.scenario.track.sleeperSpacing;
  const int apart = 1 + std::max(1, static_cast<int>(std::ceil(sleeperReach)));
  const int colour = reach * lines_[0].modes;
  int ofOneSleeper = 0;
  for (int i = 0; i < model.sleepers; ++i) {
    addLineGroup(model.firstSleeper + i, 0.42, 0, colour + i % apart * ofOneSleeper, 0);
    ofOneSleeper = lines_.back().modes * static_cast<int>(lines_.back().knots.size());
  }
  placeWheelset();
  for (const auto index : model.fixed)
    if (isIn(model.blocks[model.rail], index) || isIn(model.blocks[model.rim], index))
      fixedOnRailAndRim_.push_back(index);
  cosine_.resize(model.blocks.size()), sine_.resize(model.blocks.size()), rimShare_.resize(model.blocks.size());
  const auto& w = model.scenario.wheelset;
  for (const int b : {model.rim, model.body}) {
    const auto& block = model.blocks[b];
    for (int s = 0; s < block.stationCount; ++s)
      cosine_[b].push_back(elementary::cos(block.positions[s])),
          sine_[b].push_back(elementary::sin(block.positions[s]));
    for (const auto& p : block.section.nodes)
      rimShare_[b].push_back(std::clamp((p[0] - w.hubRadius) / (w.rimInnerRadius - w.hubRadius), 0.0, 1.0));
  }
}

// `distance` in knots from one hat to the next of the same colour; 0: every hat has its own.
void CoarseSpace::addLineGroup(int b, double spacing, int shapes, int firstColour, int distance) {
  const auto& block = model_.blocks[b];
  LineGroup group{b, unknowns_, 6 + shapes, {}, 0, 0, {}};
  if (shapes > 0) group.shapes = softestShapes(block, shapes);
  const double from = block.positions.front(), to = block.positions.back();
  const int count = std::max(1, static_cast<int>(std::lround((to - from) / spacing)));
  for (int k = 0; k <= count; ++k) {
    group.knots.push_back(from + (to - from) * k / count);
    const int colour = firstColour + (distance > 0 ? k % distance : k) * group.modes;
    for (int m = 0; m < group.modes; ++m)
      placed_.push_back({Part::track, colour + m, b == model_.rail ? group.knots.back() : block.origin[0]});
  }
  const auto integrals = geometry::sectionIntegrals(block.section);
  group.middleB = integrals.centroidB, group.middleC = integrals.centroidC;
  unknowns_ += group.modes * (count + 1);
  lines_.push_back(std::move(group));
}

// Nothing but the contact, which comes later, joins wheelset and track: they share colours.
void CoarseSpace::placeWheelset() {
  const auto& w = model_.scenario.wheelset;
  axleKnots_ = {
      -w.trackCentre, -0.6 * w.trackCentre, -0.25 * w.trackCentre, 0, 0.5 * (w.hubWidth / 2 + w.bearingCentre),
      w.journalEnd};
  rimMiddle_ = 0.5 * (w.rimInnerRadius + w.radius);
  int colour = 0;
  axleFirst_ = unknowns_;
  for (int i = 0; i < 6 * static_cast<int>(axleKnots_.size()); ++i)
    placed_.push_back({Part::restOfWheelset, colour++, 0});
  // Forces of a hat of the rim reach up to five knots where the wheel has as few sectors as it may.
  constexpr int distance = rimHats / 2;
  rimFirst_ = static_cast<int>(placed_.size());
  for (int knot = 0; knot < rimHats; ++knot)
    for (int m = 0; m < rimModes; ++m)
      placed_.push_back({Part::rim, colour + knot % distance * rimModes + m, static_cast<double>(knot)});
  colour += rimModes * distance;
  sprungFirst_ = static_cast<int>(placed_.size());
  for (const std::size_t index : {model_.sprungX, model_.sprungZ, model_.boxX, model_.boxZ})
    if (free_[index]) sprung_.push_back(index), placed_.push_back({Part::restOfWheelset, colour++, 0});
  unknowns_ = static_cast<int>(placed_.size());
}

// Resultants of stations in local axes: forces a, b, c, moments about the section's middle, forces along the shapes.
void CoarseSpace::projectLine(const LineGroup& group, const double* r, int part, int parts, double* coarse) const {
  const auto& block = model_.blocks[group.block];
  const int first = block.stationCount * part / parts, last = block.stationCount * (part + 1) / parts;
  const int count = last - first;
  std::vector<double> sums(static_cast<std::size_t>(group.modes) * static_cast<std::size_t>(count), 0.0);
  double *fa = sums.data(), *fb = fa + count, *fc = fb + count, *ma = fc + count, *mb = ma + count, *mc = mb + count;
  for (int n = 0; n < block.nodes; ++n) {
    const double lb = block.section.nodes[n][0] - group.middleB, lc = block.section.nodes[n][1] - group.middleC;
    for (int from = first; from < last;) {
      const int to = std::min(last, (from / block.chunk + 1) * block.chunk);
      const double *a = r + block.index(n, 0, from), *b = a + block.chunk, *c = b + block.chunk;
      const int at = from - first, length = to - from;
      for (int s = 0; s < length; ++s) {
        fa[at + s] += a[s], fb[at + s] += b[s], fc[at + s] += c[s];
        ma[at + s] += lb * c[s] - lc * b[s], mb[at + s] += lc * a[s], mc[at + s] -= lb * a[s];
      }
      for (std::size_t k = 0; k < group.shapes.size(); ++k) {
        const auto [alongB, alongC] = group.shapes[k][static_cast<std::size_t>(n)];
        double* shaped = sums.data() + (6 + k) * static_cast<std::size_t>(count) + at;
        for (int s = 0; s < length; ++s) shaped[s] += alongB * b[s] + alongC * c[s];
      }
      from = to;
    }
  }
  for (int s = 0; s < count; ++s) {
    const double at = block.positions[first + s];
    const Hats hats = hatsAt(group.knots, at);
    for (int side = 0; side < 2; ++side) {
      const int k = hats.left + side;
      const double share = side ? hats.rightShare : hats.leftShare, lever = at - group.knots[k];
      double* out = coarse + group.first + group.modes * k;
      out[0] += share * fa[s], out[1] += share * fb[s], out[2] += share * fc[s];
      out[3] += share * ma[s], out[4] += share * (mb[s] - lever * fc[s]), out[5] += share * (mc[s] + lever * fb[s]);
      for (int m = 6; m < group.modes; ++m) out[m] += share * fa[m * count + s];
    }
  }
}

void CoarseSpace::prolongLine(const LineGroup& group, const double* coarse, int part, int parts, double* z) const {
  const auto& block = model_.blocks[group.block];
  const int first = block.stationCount * part / parts, last = block.stationCount * (part + 1) / parts;
  const int count = last - first;
  std::vector<double> sums(static_cast<std::size_t>(group.modes) * static_cast<std::size_t>(count), 0.0);
  double *ta = sums.data(), *tb = ta + count, *tc = tb + count, *ra = tc + count, *rb = ra + count, *rc = rb + count;
  for (int s = 0; s < count; ++s) {
    const double at = block.positions[first + s];
    const Hats hats = hatsAt(group.knots, at);
    for (int side = 0; side < 2; ++side) {
      const int k = hats.left + side;
      const double share = side ? hats.rightShare : hats.leftShare, lever = at - group.knots[k];
      const double* in = coarse + group.first + group.modes * k;
      ta[s] += share * in[0], tb[s] += share * in[1], tc[s] += share * in[2];
      ra[s] += share * in[3], rb[s] += share * in[4], rc[s] += share * in[5];
      tc[s] -= share * lever * in[4], tb[s] += share * lever * in[5];
      for (int m = 6; m < group.modes; ++m) ta[m * count + s] += share * in[m];
    }
  }
  for (int n = 0; n < block.nodes; ++n) {
    const double lb = block.section.nodes[n][0] - group.middleB, lc = block.section.nodes[n][1] - group.middleC;
    for (int from = first; from < last;) {
      const int to = std::min(last, (from / block.chunk + 1) * block.chunk);
      double *a = z + block.index(n, 0, from), *b = a + block.chunk, *c = b + block.chunk;
      const int at = from - first, length = to - from;
      for (int s = 0; s < length; ++s) {
        a[s] += ta[at + s] + lc * rb[at + s] - lb * rc[at + s];
        b[s] += tb[at + s] - lc * ra[at + s];
        c[s] += tc[at + s] + lb * ra[at + s];
      }
      for (std::size_t k = 0; k < group.shapes.size(); ++k) {
        const auto [alongB, alongC] = group.shapes[k][static_cast<std::size_t>(n)];
        const double* shaped = sums.data() + (6 + k) * static_cast<std::size_t>(count) + at;
        for (int s = 0; s < length; ++s) b[s] += alongB * shaped[s], c[s] += alongC * shaped[s];
      }
      from = to;
    }
  }
}

double CoarseSpace::axleHat(int b, int node, int knot) const {
  return hat(axleKnots_, knot, model_.blocks[b].section.nodes[node][1]);
}

void CoarseSpace::projectWheel(int b, const double* r, double* coarse) const {
  const auto& block = model_.blocks[b];
  const int count = block.stationCount;
  const auto &cosine = cosine_[b], &sine = sine_[b];
  std::vector<double> rim(rimModes * static_cast<std::size_t>(count), 0.0);
  for (int n = 0; n < block.nodes; ++n) {
    if (model_.slave[b][n]) continue;
    const auto fa = block.line(r, n, 0), fb = block.line(r, n, 1), fc = block.line(r, n, 2);
    const double radius = block.section.nodes[n][0], y = block.section.nodes[n][1], share = rimShare_[b][n];
    double x = 0, z = 0, lateral = 0, turning = 0, cosLateral = 0, sinLateral = 0;
    for (int s = 0; s < count; ++s) {
      const double atX = cosine[s] * fa[s] + sine[s] * fb[s], atZ = sine[s] * fa[s] - cosine[s] * fb[s];
      x += atX, z += atZ, lateral += fc[s], turning += fa[s];
      cosLateral += cosine[s] * fc[s], sinLateral += sine[s] * fc[s];
      rim[s] += share * atX, rim[count + s] += share * fc[s], rim[2 * count + s] += share * atZ;
      rim[3 * count + s] += share * ((radius - rimMiddle_) * fc[s] - y * fb[s]);
      rim[4 * count + s] += share * (radius - rimMiddle_) * fa[s], rim[5 * count + s] += share * y * fa[s];
    }
    for (int k = 0; k < static_cast<int>(axleKnots_.size()); ++k) {
      const double h = axleHat(b, n, k);
      if (h == 0) continue;
      double* out = coarse + axleFirst_ + 6 * k;
      out[0] += h * x, out[1] += h * lateral, out[2] += h * z;
      out[3] += h * (y * z + radius * cosLateral), out[4] -= h * radius * turning,
          out[5] += h * (radius * sinLateral - y * x);
    }
  }
  for (int s = 0; s < count; ++s) {
    const Hats hats = rimHatsAt(block.positions[s]);
    for (int m = 0; m < rimModes; ++m) {
      coarse[rimFirst_ + rimModes * hats.left + m] += hats.leftShare * rim[m * count + s];
      coarse[rimFirst_ + rimModes * ((hats.left + 1) % rimHats) + m] += hats.rightShare * rim[m * count + s];
    }
  }
}

void CoarseSpace::prolongWheel(int b, const double* coarse, int part, int parts, double* z) const {
  const auto& block = model_.blocks[b];
  const int count = block.stationCount;
  const auto &cosine = cosine_[b], &sine = sine_[b];
  std::vector<double> rim(rimModes * static_cast<std::size_t>(count), 0.0);
  for (int s = 0; s < count; ++s) {
    const Hats hats = rimHatsAt(block.positions[s]);
    for (int m = 0; m < rimModes; ++m)
      rim[m * count + s] = hats.leftShare * coarse[rimFirst_ + rimModes * hats.left + m] +
                           hats.rightShare * coarse[rimFirst_ + rimModes * ((hats.left + 1) % rimHats) + m];
  }
  for (int n = block.nodes * part / parts; n < block.nodes * (part + 1) / parts; ++n) {
    if (model_.slave[b][n]) continue;
    double t[3] = {0, 0, 0}, w[3] = {0, 0, 0};
    for (int k = 0; k < static_cast<int>(axleKnots_.size()); ++k) {
      const double h = axleHat(b, n, k);
      const double* in = coarse + axleFirst_ + 6 * k;
      for (int m = 0; m < 3; ++m) t[m] += h * in[m], w[m] += h * in[3 + m];
    }
    const double radius = block.section.nodes[n][0], y = block.section.nodes[n][1], share = rimShare_[b][n];
    const double mask = model_.freeMask[b][3 * n + 2];
    const auto a = block.line(z, n, 0), radial = block.line(z, n, 1), c = block.line(z, n, 2);
    for (int s = 0; s < count; ++s) {
      const double x = t[0] - y * w[2] + share * rim[s], up = t[2] + y * w[0] + share * rim[2 * count + s];
      const double turned = (radius - rimMiddle_) * rim[4 * count + s] + y * rim[5 * count + s];
      a[s] += cosine[s] * x + sine[s] * up - radius * w[1] + share * turned;
      radial[s] += sine[s] * x - cosine[s] * up - share * y * rim[3 * count + s];
      c[s] += mask * (t[1] + radius * (cosine[s] * w[0] + sine[s] * w[2]) +
                      share * (rim[count + s] + (radius - rimMiddle_) * rim[3 * count + s]));
    }
  }
}

Eigen::VectorXd CoarseSpace::resultantsOf(ThreadTeam& team, const double* r) const {
  const int parts = team.size();
  // Fixed halves of the rail, then everything else: sums do not depend on the number of threads.
  Eigen::VectorXd pieces[4] = {Eigen::VectorXd::Zero(unknowns_), Eigen::VectorXd::Zero(unknowns_),
                               Eigen::VectorXd::Zero(unknowns_), Eigen::VectorXd::Zero(unknowns_)};
  team.run([&](int index) {
    for (int piece = index; piece < 4; piece += parts) {
      double* out = pieces[piece].data();
      if (piece < 2) {
        projectLine(lines_[0], r, piece, 2, out);
      } else if (piece == 2) {
        projectWheel(model_.body, r, out);
        for (std::size_t g = 1; g < lines_.size(); ++g) projectLine(lines_[g], r, 0, 1, out);
      } else {
        projectWheel(model_.rim, r, out);
      }
    }
  });
  Eigen::VectorXd coarse = pieces[0] + pieces[1] + pieces[2] + pieces[3];
  for (std::size_t i = 0; i < sprung_.size(); ++i) coarse[sprungFirst_ + static_cast<int>(i)] = r[sprung_[i]];
  return coarse;
}

void CoarseSpace::prolong(ThreadTeam& team, const Eigen::VectorXd& coarse, double* z, Bodies bodies) const {
  const int parts = team.size();
  const bool withRail = bodies != Bodies::sleepersAndAxle, withCentre = bodies != Bodies::railAndRim;
  team.run([&](int index) {
    if (withRail) prolongLine(lines_[0], coarse.data(), index, parts, z);
    for (std::size_t g = 1; withCentre && g < lines_.size(); ++g)
      if (static_cast<int>(g) % parts == index) prolongLine(lines_[g], coarse.data(), 0, 1, z);
    if (withCentre) prolongWheel(model_.body, coarse.data(), index, parts, z);
    if (withRail) prolongWheel(model_.rim, coarse.data(), index, parts, z);
  });
  for (std::size_t i = 0; withCentre && i < sprung_.size(); ++i)
    z[sprung_[i]] += coarse[sprungFirst_ + static_cast<int>(i)];
  if (bodies == Bodies::all)
    for (const auto index : model_.fixed) z[index] = 0;
  if (bodies == Bodies::railAndRim)
    for (const auto index : fixedOnRailAndRim_) z[index] = 0;
}

int CoarseSpace::sourceFor(int i, const std::vector<int>& ofOneColour) const {
  const bool isOnTrack = placed_[i].part == Part::track;
  const auto distance = [&](int j) {
    const double between = std::abs(placed_[j].place - placed_[i].place);
    return placed_[j].part == Part::rim ? std::min(between, rimHats - between) : between;
  };
  int nearest = -1;
  for (const int j : ofOneColour) {
    if ((placed_[j].part == Part::track) != isOnTrack) continue;
    // Every hat of the rim reaches the axle: their products stand in the columns of the axle's unknowns.
    if (placed_[j].part == Part::rim && placed_[i].part != Part::rim) return -1;
    if (nearest < 0 || distance(j) < distance(nearest)) nearest = j;
  }
  return nearest;
}

bool CoarseSpace::assemble(model::StaticOperator& op, Monitor& monitor) {
  forces::ForceElements kept = std::exchange(op.contactSprings(), forces::ForceElements{});
  const bool isDone = assemble(
      op.team(), [&](double* u, double* result) { op.apply(u, result); }, monitor);
  op.contactSprings() = std::move(kept);
  return isDone;
}

bool CoarseSpace::assemble(ThreadTeam& team, const Product& product, Monitor& monitor, const Known* known) {
  std::vector<std::vector<int>> groups;
  for (int j = 0; j < unknowns_; ++j) {
    if (placed_[j].colour >= static_cast<int>(groups.size())) groups.resize(placed_[j].colour + 1);
    groups[placed_[j].colour].push_back(j);
  }
  matrix_ = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
  AlignedVector u(model_.stateSize, 0.0), result(model_.stateSize, 0.0);
  std::size_t products = 0;
  for (const auto& group : groups) {
    if (group.empty()) continue;
    if (monitor.cancelled()) return false;
    if (const std::size_t here = products++; known && known->isSame[here]) {
      for (int i = 0; i < unknowns_; ++i)
        if (const int j = sourceFor(i, group); j >= 0) matrix_(i, j) = known->space.matrix_(i, j);
      continue;
    }
    Eigen::VectorXd source = Eigen::VectorXd::Zero(unknowns_);
    for (const int j : group) source[j] = 1;
    std::fill(u.begin(), u.end(), 0.0);
    prolong(team, source, u.data());
    product(u.data(), result.data());
    const Eigen::VectorXd coarse = resultantsOf(team, result.data());
    for (int i = 0; i < unknowns_; ++i)
      if (const int j = sourceFor(i, group); j >= 0) matrix_(i, j) = coarse[i];
  }
  for (int j = rimFirst_; j < sprungFirst_; ++j)
    for (int i = 0; i < unknowns_; ++i)
      if (placed_[i].part == Part::restOfWheelset) matrix_(i, j) = matrix_(j, i);
  matrix_ = 0.5 * (matrix_ + matrix_.transpose()).eval();
  return true;
}

Eigen::VectorXd CoarseSpace::projectSparse(const forces::ForceElements& springs, std::size_t i) const {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns_);
  const auto& rail = model_.blocks[model_.rail];
  const auto& group = lines_[0];
  for (std::size_t t = springs.start[i]; t < springs.start[i + 1]; ++t) {
    const std::size_t index = springs.unknown[t];
    if (const auto mass = std::find(sprung_.begin(), sprung_.end(), index); mass != sprung_.end()) {
      g[sprungFirst_ + static_cast<int>(mass - sprung_.begin())] += springs.weight[t];
      continue;
    }
    const int b = index >= rail.offset + rail.size() ? model_.rim : model_.rail;
    const auto& block = model_.blocks[b];
    const auto [n, component, s] = block.unknownAt(index);
    Eigen::Vector3d f = Eigen::Vector3d::Zero();
    f[component] = springs.weight[t];
    const auto& p = block.section.nodes[n];
    if (b == model_.rail) {
      const Hats hats = hatsAt(group.knots, block.positions[s]);
      const double lb = p[0] - group.middleB, lc = p[1] - group.middleC;
      for (int side = 0; side < 2; ++side) {
        const int k = hats.left + side;
        const double share = side ? hats.rightShare : hats.leftShare, lever = block.positions[s] - group.knots[k];
        const double values[6] = {
            f[0], f[1], f[2], lb * f[2] - lc * f[1], lc * f[0] - lever * f[2], lever * f[1] - lb * f[0]};
        double* out = g.data() + group.first + group.modes * k;
        for (int m = 0; m < 6; ++m) out[m] += share * values[m];
        for (int m = 6; m < group.modes; ++m) {
          const auto [alongB, alongC] = group.shapes[static_cast<std::size_t>(m - 6)][static_cast<std::size_t>(n)];
          out[m] += share * (alongB * f[1] + alongC * f[2]);
        }
      }
      continue;
    }
    const double c = cosine_[b][s], sn = sine_[b][s], x = c * f[0] + sn * f[1], z = sn * f[0] - c * f[1];
    for (int k = 0; k < static_cast<int>(axleKnots_.size()); ++k) {
      const double h = axleHat(b, n, k);
      const double values[6] = {x, f[2], z, p[1] * z + p[0] * c * f[2], -p[0] * f[0], p[0] * sn * f[2] - p[1] * x};
      for (int m = 0; m < 6; ++m) g[axleFirst_ + 6 * k + m] += h * values[m];
    }
    const Hats hats = rimHatsAt(block.positions[s]);
    const double values[rimModes] = {
        x, f[2], z, (p[0] - rimMiddle_) * f[2] - p[1] * f[1], (p[0] - rimMiddle_) * f[0], p[1] * f[0]};
    for (int m = 0; m < rimModes; ++m) {
      g[rimFirst_ + rimModes * hats.left + m] += rimShare_[b][n] * hats.leftShare * values[m];
      g[rimFirst_ + rimModes * ((hats.left + 1) % rimHats) + m] += rimShare_[b][n] * hats.rightShare * values[m];
    }
  }
  return g;
}

void CoarseSpace::factorise(const forces::ForceElements& contact) {
  const forces::ForceElements* only = &contact;
  factorise(std::span(&only, 1));
}

void CoarseSpace::factorise(std::span<const forces::ForceElements* const> contacts) {
  Eigen::MatrixXd whole = matrix_;
  for (const auto* contact : contacts)
    for (std::size_t i = 0; i < contact->size(); ++i) {
      const Eigen::VectorXd g = projectSparse(*contact, i);
      for (int j = 0; j < unknowns_; ++j)
        if (g[j] != 0) whole.col(j) += contact->stiffness[i] * g[j] * g;
    }
  // Hats of the wheelset overlap and are nearly dependent: a little relative stiffness keeps the factor definite.
  whole.diagonal() *= 1 + 1e-10;
  for (int j = 0; j < unknowns_; ++j)  // fixed, or out of reach of every node
    if (!(whole(j, j) > 0)) whole.col(j).setZero(), whole.row(j).setZero(), whole(j, j) = 1;
  const double negligible = 1e-14 * whole.diagonal().maxCoeff();
  factor_.compute(whole.sparseView(negligible, 1.0));
  if (factor_.info() != Eigen::Success)
    throw RunError("the coarse stiffness of the equilibrium has no factor: a part of the model is not supported", 0, 0,
                   "");
}

CoarseSpace::Correction CoarseSpace::correctionOf(ThreadTeam& team, const double* r) const {
  return correctionOf(resultantsOf(team, r));
}

CoarseSpace::Correction CoarseSpace::correctionOf(const Eigen::VectorXd& resultants) const {
  Correction correction{factor_.solve(resultants)};
  correction.product = resultants.dot(correction.y);
  return correction;
}

}  // namespace squat::statics
