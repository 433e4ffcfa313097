#include "simulation/RollingStateFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/Errors.h"
#include "results/StateFile.h"
#include "simulation/DivergenceGuard.h"

namespace squat::simulation {

namespace {

constexpr const char* secondPath = "/rolling/second_wheelset";

std::string groupOf(std::size_t side) { return side == 0 ? "/rolling" : "/rolling_right"; }

void saveSide(const dynamics::Rolling& rolling, const std::string& at, results::ArrayTree& tree) {
  const auto& s = rolling.state();
  const auto plain = [](const AlignedVector& v) { return std::vector<double>(v.begin(), v.end()); };
  tree.add(at + "/displaced", plain(s.displaced), "m");
  tree.add(at + "/velocity", plain(s.velocity), "m/s");
  tree.add(at + "/traction", s.friction.traction, "Pa");
  if (!s.plastic.values.empty()) tree.add(at + "/plastic", plain(s.plastic.values), "1");
  tree.add(at + "/closed", std::vector<std::int64_t>(s.friction.closed.begin(), s.friction.closed.end()), "1");
  tree.add(at + "/scalars",
           std::vector<double>{static_cast<double>(s.step), s.time, s.rotation, s.angularVelocity, s.sums.friction,
                               s.sums.damping, s.sums.torqueWork, s.turningMoment, s.addedMoment},
           "1");
}

void requireFittingSide(const StoredState& stored, const dynamics::Rolling& rolling, const std::string& at,
                        long lastStep) {
  const auto& [tree, file, instead] = stored;
  results::ArrayTree own;
  saveSide(rolling, at, own);
  std::vector<std::string> needed{at + "/displaced", at + "/velocity", at + "/traction", at + "/scalars"};
  if (own.find(at + "/plastic")) needed.push_back(at + "/plastic");
  for (const auto& path : needed)
    if (results::valuesOf<double>(tree, path, file).size() != results::valuesOf<double>(own, path, file).size())
      throw FileError(file, path, "has another length than this case and mesh need", results::asSentence(instead));
  const auto points = static_cast<std::int64_t>(results::valuesOf<double>(own, at + "/traction", file).size() / 2);
  std::int64_t before = -1;
  for (const auto point : results::valuesOf<std::int64_t>(tree, at + "/closed", file)) {
    if (point <= before || point >= points)
      throw FileError(file, at + "/closed", "names points of contact that are not there");
    before = point;
  }
  const auto& scalars = results::valuesOf<double>(tree, at + "/scalars", file);
  const double step = scalars[0];
  if (!(step >= 0 && step <= static_cast<double>(lastStep)))
    throw FileError(file, at + "/scalars", "names a step beyond the end of the run");
  const double change = rolling.stepSize() / rolling.model().wheelset.inertia;  // of the angular velocity by a moment
  if (!(std::abs(scalars[1] - step * rolling.stepSize()) < 1e-9) || !(std::abs(scalars[2]) < maximumRotation) ||
      !(std::abs(scalars[3]) < maximumAngularVelocity) ||
      !((std::abs(scalars[7]) + std::abs(scalars[8])) * change < maximumAngularVelocity))
    throw FileError(file, at + "/scalars",
                    "names a time, rotation, angular velocity or moment that no run of this case has");
}

dynamics::RollingState loadSide(const results::ArrayTree& tree, const std::string& at) {
  const std::string file = "checkpoint";
  dynamics::RollingState s;
  const auto& u = results::valuesOf<double>(tree, at + "/displaced", file);
  const auto& v = results::valuesOf<double>(tree, at + "/velocity", file);
  s.displaced.assign(u.begin(), u.end()), s.velocity.assign(v.begin(), v.end());
  s.friction.traction = results::valuesOf<double>(tree, at + "/traction", file);
  if (tree.find(at + "/plastic")) {
    const auto& flow = results::valuesOf<double>(tree, at + "/plastic", file);
    s.plastic.values.assign(flow.begin(), flow.end());
  }
  const auto* closed = tree.find(at + "/closed");
  if (const auto* list = closed ? std::get_if<std::vector<std::int64_t>>(&closed->values) : nullptr)
    s.friction.closed.assign(list->begin(), list->end());
  const auto& scalars = results::valuesOf<double>(tree, at + "/scalars", file);
  s.step = static_cast<long>(scalars.at(0)), s.time = scalars.at(1), s.rotation = scalars.at(2),
  s.angularVelocity = scalars.at(3);
  s.sums = {scalars.at(4), scalars.at(5), scalars.at(6)};
  s.turningMoment = scalars.at(7), s.addedMoment = scalars.at(8);
  return s;
}

}  // namespace

void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree) {
  for (std::size_t i = 0; i < rolling.sides().size(); ++i) saveSide(*rolling.sides()[i], groupOf(i), tree);
  if (const auto* second = rolling.second()) tree.add(secondPath, second->packed(), "1");
}

void requireFittingState(const StoredState& stored, const dynamics::Rolling& rolling, long lastStep) {
  const auto turnOf = [&](std::size_t side) {
    const auto& numbers = results::valuesOf<double>(stored.tree, groupOf(side) + "/scalars", stored.file);
    return std::array<double, 4>{numbers[0], numbers[1], numbers[2], numbers[3]};
  };
  for (std::size_t i = 0; i < rolling.sides().size(); ++i) {
    requireFittingSide(stored, *rolling.sides()[i], groupOf(i), lastStep);
    if (turnOf(i) != turnOf(0))
      throw FileError(stored.file, groupOf(i) + "/scalars", "names another step or rotation than the left side has");
  }
  if (!rolling.second()) return;
  constexpr double largest = 1e9;  // beyond any force [N], displacement or velocity; not a number is not below it
  const auto& values = results::valuesOf<double>(stored.tree, secondPath, stored.file);
  if (values.size() != rolling.second()->packed().size() ||
      !std::all_of(values.begin(), values.end(), [](double value) { return std::abs(value) < largest; }))
    throw FileError(stored.file, secondPath, "is not a state of this case's second wheelset",
                    results::asSentence(stored.instead));
}

void restoreRolling(const results::ArrayTree& tree, dynamics::Rolling& rolling) {
  for (std::size_t i = 0; i < rolling.sides().size(); ++i) rolling.sides()[i]->restore(loadSide(tree, groupOf(i)));
  if (rolling.second()) rolling.restoreSecond(results::valuesOf<double>(tree, secondPath, "checkpoint"));
}

}  // namespace squat::simulation
