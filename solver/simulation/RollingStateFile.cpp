#include "simulation/RollingStateFile.h"

#include <cmath>
#include <vector>

#include "core/Errors.h"
#include "results/StateFile.h"
#include "simulation/DivergenceGuard.h"

namespace squat::simulation {

void saveRolling(const dynamics::Rolling& rolling, results::ArrayTree& tree) {
  const auto& s = rolling.state();
  const auto plain = [](const AlignedVector& v) { return std::vector<double>(v.begin(), v.end()); };
  tree.add("/rolling/displaced", plain(s.displaced), "m");
  tree.add("/rolling/velocity", plain(s.velocity), "m/s");
  tree.add("/rolling/traction", s.friction.traction, "Pa");
  if (!s.plastic.values.empty()) tree.add("/rolling/plastic", plain(s.plastic.values), "1");
  tree.add("/rolling/closed", std::vector<std::int64_t>(s.friction.closed.begin(), s.friction.closed.end()), "1");
  tree.add("/rolling/scalars",
           std::vector<double>{static_cast<double>(s.step), s.time, s.rotation, s.angularVelocity, s.sums.friction,
                               s.sums.damping, s.sums.torqueWork, s.turningMoment, s.addedMoment},
           "1");
}

void requireFittingState(const StoredState& stored, const dynamics::Rolling& rolling, long lastStep) {
  const auto& [tree, file, instead] = stored;
  results::ArrayTree own;
  saveRolling(rolling, own);
  std::vector<std::string> needed{"/rolling/displaced", "/rolling/velocity", "/rolling/traction", "/rolling/scalars"};
  if (own.find("/rolling/plastic")) needed.push_back("/rolling/plastic");
  for (const auto& path : needed)
    if (results::valuesOf<double>(tree, path, file).size() != results::valuesOf<double>(own, path, file).size())
      throw FileError(file, path, "has another length than this case and mesh need", results::asSentence(instead));
  const auto points = static_cast<std::int64_t>(results::valuesOf<double>(own, "/rolling/traction", file).size() / 2);
  std::int64_t before = -1;
  for (const auto point : results::valuesOf<std::int64_t>(tree, "/rolling/closed", file)) {
    if (point <= before || point >= points)
      throw FileError(file, "/rolling/closed", "names points of contact that are not there");
    before = point;
  }
  const auto& scalars = results::valuesOf<double>(tree, "/rolling/scalars", file);
  const double step = scalars[0];
  if (!(step >= 0 && step <= static_cast<double>(lastStep)))
    throw FileError(file, "/rolling/scalars", "names a step beyond the end of the run");
  const double change = rolling.stepSize() / rolling.model().wheelset.inertia;  // of the angular velocity by a moment
  if (!(std::abs(scalars[1] - step * rolling.stepSize()) < 1e-9) || !(std::abs(scalars[2]) < maximumRotation) ||
      !(std::abs(scalars[3]) < maximumAngularVelocity) ||
      !((std::abs(scalars[7]) + std::abs(scalars[8])) * change < maximumAngularVelocity))
    throw FileError(file, "/rolling/scalars",
                    "names a time, rotation, angular velocity or moment that no run of this case has");
}

dynamics::RollingState loadRolling(const results::ArrayTree& tree) {
  dynamics::RollingState s;
  const auto& u = results::valuesOf<double>(tree, "/rolling/displaced", "checkpoint");
  const auto& v = results::valuesOf<double>(tree, "/rolling/velocity", "checkpoint");
  s.displaced.assign(u.begin(), u.end()), s.velocity.assign(v.begin(), v.end());
  s.friction.traction = results::valuesOf<double>(tree, "/rolling/traction", "checkpoint");
  if (tree.find("/rolling/plastic")) {
    const auto& flow = results::valuesOf<double>(tree, "/rolling/plastic", "checkpoint");
    s.plastic.values.assign(flow.begin(), flow.end());
  }
  const auto* closed = tree.find("/rolling/closed");
  if (const auto* list = closed ? std::get_if<std::vector<std::int64_t>>(&closed->values) : nullptr)
    s.friction.closed.assign(list->begin(), list->end());
  const auto& scalars = results::valuesOf<double>(tree, "/rolling/scalars", "checkpoint");
  s.step = static_cast<long>(scalars.at(0)), s.time = scalars.at(1), s.rotation = scalars.at(2),
  s.angularVelocity = scalars.at(3);
  s.sums = {scalars.at(4), scalars.at(5), scalars.at(6)};
  s.turningMoment = scalars.at(7), s.addedMoment = scalars.at(8);
  return s;
}

}  // namespace squat::simulation
