#include "receptance/PeriodicTrack.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/Errors.h"

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

VectorXd PeriodicTrack::loading(const Local& place) const {
  const auto direction = static_cast<RailDirection>(place.direction);
  if (wholeSection_ && direction == RailDirection::vertical) return cell_.load(place.position);
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
  if (across.norm() > silent * whole)
    throw RunError(
        "waves do not decay along the endless track: nothing damps them. Set pad.damping, ballast.damping or a "
        "loss factor",
        0, 0, "");
  return {last, first};
}

namespace {

// The ends of cells, counted from the loaded one, as they move when it is loaded.
class MovedCells {
 public:
  // `cell` condensed, `ends` of the loaded one.
  MovedCells(const MatrixXcd& cell, const HalfTracks& halves, VectorXcd ends)
      : n_(cell.rows() / 2),
        across_(cell.topRightCorner(n_, n_)),
        onwards_(cell.bottomRightCorner(n_, n_) + halves.behind),
        backwards_(cell.topLeftCorner(n_, n_) + halves.before),
        behind_{ends},
        before_{std::move(ends)} {}

  // Away from the load, the end towards it moves the other one.
  const VectorXcd& operator[](int cell) {
    while (static_cast<int>(behind_.size()) <= cell) {
      VectorXcd next(2 * n_);
      next.head(n_) = behind_.back().tail(n_);
      next.tail(n_) = -onwards_.solve(across_.transpose() * next.head(n_));
      behind_.push_back(std::move(next));
    }
    while (static_cast<int>(before_.size()) <= -cell) {
      VectorXcd next(2 * n_);
      next.tail(n_) = before_.back().head(n_);
      next.head(n_) = -backwards_.solve(across_ * next.tail(n_));
      before_.push_back(std::move(next));
    }
    return cell < 0 ? before_[static_cast<std::size_t>(-cell)] : behind_[static_cast<std::size_t>(cell)];
  }

 private:
  Index n_;
  MatrixXcd across_;
  Eigen::PartialPivLU<MatrixXcd> onwards_, backwards_;
  std::vector<VectorXcd> behind_, before_;
};

}  // namespace

std::vector<std::vector<std::complex<double>>> PeriodicTrack::response(double omega,
                                                                       const std::vector<PlaceResponse>& wanted) const {
  // One vector for every place that differs from the others within its cell, and for what is struck.
  std::map<std::tuple<long, int, bool>, Index> columns;  // by position to the micrometre, direction, struck
  MatrixXd vectors(cell_.groups().unknowns(), 0);
  const auto columnOf = [&](const RailPlace& place, bool struck) {
    const Local local = localOf(place);
    const auto [entry, fresh] = columns.try_emplace({std::lround(1e6 * local.position), local.direction, struck},
                                                    static_cast<Index>(columns.size()));
    if (fresh) {
      vectors.conservativeResize(Eigen::NoChange, entry->second + 1);
      vectors.col(entry->second) = struck ? loading(local) : reading(local);
    }
    return entry->second;
  };
  for (const auto& one : wanted) {
    columnOf(one.struck, true);
    for (const auto& place : one.read) columnOf(place, false);
  }
  const auto cell = stiffness_.condense(omega, vectors);
  const Index n = cell.stiffness.rows() / 2;
  const auto halves = halfTracks(cell.stiffness);
  MatrixXcd loaded = cell.stiffness;
  loaded.topLeftCorner(n, n) += halves.before, loaded.bottomRightCorner(n, n) += halves.behind;
  const Eigen::PartialPivLU<MatrixXcd> solver(loaded);
  std::vector<std::vector<std::complex<double>>> answers;
  for (const auto& one : wanted) {
    const Index load = columnOf(one.struck, true);
    MovedCells moved(cell.stiffness, halves, solver.solve(cell.loads.col(load)));
    auto& row = answers.emplace_back();
    for (const auto& place : one.read) {
      const Index column = columnOf(place, false);
      const int away = localOf(place).cell - localOf(one.struck).cell;
      const std::complex<double> own = away == 0 ? cell.between(column, load) : 0;
      row.push_back(own + cell.loads.col(column).cwiseProduct(moved[away]).sum());
    }
  }
  return answers;
}

}  // namespace squat::receptance
