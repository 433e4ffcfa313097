#include "receptance/PeriodicTrack.h"

#include <cmath>
#include <map>
#include <utility>

namespace squat::receptance {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

std::vector<int> bothEnds(const TrackSystem& cell) {
  auto ends = cell.firstStation();
  const auto last = cell.lastStation();
  ends.insert(ends.end(), last.begin(), last.end());
  return ends;
}

}  // namespace

PeriodicTrack::PeriodicTrack(const TrackSystem& cell, double bay, bool wholeSection)
    : cell_(cell), bay_(bay), wholeSection_(wholeSection), stiffness_(cell.terms(), bothEnds(cell)) {}

PeriodicTrack::Local PeriodicTrack::localOf(const RailPlace& place) const {
  Local local;
  local.cell = static_cast<int>(std::lround(place.position / bay_));
  local.position = place.position - local.cell * bay_;
  local.direction = static_cast<int>(place.direction);
  return local;
}

VectorXd PeriodicTrack::reading(const Local& place) const {
  const auto direction = static_cast<RailDirection>(place.direction);
  if (wholeSection_ && direction == RailDirection::vertical) return cell_.sectionMean(place.position);
  return cell_.headMean(place.position, direction);
}

HalfTracks halfTracks(const MatrixXcd& cell) {
  constexpr int doublings = 24;
  constexpr double silent = 1e-10;  // of the coupling: nothing comes back
  const Index n = cell.rows() / 2;
  MatrixXcd first = cell.topLeftCorner(n, n), last = cell.bottomRightCorner(n, n), across = cell.topRightCorner(n, n);
  const double whole = across.norm();
  for (int i = 0; i < doublings && across.norm() > silent * whole; ++i) {
    // The shared end: (last + first) m = -(across^T u_first + across u_last).
    const Eigen::PartialPivLU<MatrixXcd> shared(last + first);
    MatrixXcd sides(n, 2 * n);
    sides << across.transpose(), across;
    const MatrixXcd solved = shared.solve(sides);
    first -= across * solved.leftCols(n);
    last -= across.transpose() * solved.rightCols(n);
    across = -(across * solved.rightCols(n)).eval();
  }
  return {last, first};
}

std::vector<std::complex<double>> PeriodicTrack::response(double omega, const RailPlace& struck,
                                                          const std::vector<RailPlace>& read) const {
  // The load first, then every reading that differs from the others within its cell.
  const Local load = localOf(struck);
  std::vector<Local> places;
  std::map<std::pair<long, int>, Index> columns;  // by position to the micrometre, and direction
  const auto keyOf = [](const Local& p) { return std::pair{std::lround(1e6 * p.position), p.direction}; };
  MatrixXd vectors(cell_.groups().unknowns(), 1);
  const auto columnOf = [&](const Local& place) {
    const auto [entry, fresh] = columns.try_emplace(keyOf(place), static_cast<Index>(columns.size()));
    if (fresh) {
      vectors.conservativeResize(Eigen::NoChange, entry->second + 1);
      vectors.col(entry->second) = reading(place);
    }
    return entry->second;
  };
  columnOf(load);
  for (const auto& place : read) places.push_back(localOf(place)), columnOf(places.back());

  const auto cell = stiffness_.condense(omega, vectors);
  const Index n = cell.stiffness.rows() / 2;
  const auto halves = halfTracks(cell.stiffness);
  MatrixXcd loaded = cell.stiffness;
  loaded.topLeftCorner(n, n) += halves.before, loaded.bottomRightCorner(n, n) += halves.behind;
  const VectorXcd ends = loaded.partialPivLu().solve(cell.loads.col(0));
  // A cell away from the load: the end towards it moves the other one.
  const MatrixXcd across = cell.stiffness.topRightCorner(n, n);
  const Eigen::PartialPivLU<MatrixXcd> onwards(cell.stiffness.bottomRightCorner(n, n) + halves.behind),
      backwards(cell.stiffness.topLeftCorner(n, n) + halves.before);

  std::map<int, VectorXcd> moved{{0, ends}};  // both ends of a cell, counted from the loaded one
  const auto endsOf = [&](int k) -> const VectorXcd& {
    for (int i = 1; i <= k; ++i)
      if (!moved.count(i)) {
        VectorXcd next(2 * n);
        next.head(n) = moved.at(i - 1).tail(n);
        next.tail(n) = -onwards.solve(across.transpose() * next.head(n));
        moved[i] = std::move(next);
      }
    for (int i = -1; i >= k; --i)
      if (!moved.count(i)) {
        VectorXcd next(2 * n);
        next.tail(n) = moved.at(i + 1).head(n);
        next.head(n) = -backwards.solve(across * next.tail(n));
        moved[i] = std::move(next);
      }
    return moved.at(k);
  };
  std::vector<std::complex<double>> answers;
  for (const auto& place : places) {
    const Index column = columns.at(keyOf(place));
    const int away = place.cell - load.cell;
    std::complex<double> answer = cell.loads.col(column).cwiseProduct(endsOf(away)).sum();
    if (away == 0) answer += cell.between(column, 0);
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace squat::receptance
