#include "detection/PossibleDefects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "detection/ExampleDefects.h"

namespace squat::detection {
namespace {

constexpr double speedStep = 0.02;  // of the logarithm: energies are computed for speeds this far apart
// With 700 squats the rarer sizes lie so far apart that some severe ones look more like joints.
constexpr std::size_t possibleSquats = 2000, possibleOthers = 1600, possibleFlats = 200;

long stepOf(double speed) { return std::lround(std::log(speed) / speedStep); }

}  // namespace

PossibleSquats::PossibleSquats(std::size_t count, const SeverityLimits& limits) {
  constexpr std::uint32_t seed = 999;
  std::array<double, 3> members{};
  for (const auto& example : exampleSquats(count, seed)) {
    const auto severity = severityOf(example.length, example.depth, limits);
    squats_.push_back({example.length, example.depth, severity, 0, PathSpectrum(example.defect)});
    members[static_cast<std::size_t>(severity)] += 1;
  }
  const auto classes =
      static_cast<double>(std::count_if(members.begin(), members.end(), [](double n) { return n > 0; }));
  for (auto& squat : squats_) squat.weight = 1 / (classes * members[static_cast<std::size_t>(squat.severity)]);
}

std::vector<const PathSpectrum*> PossibleSquats::paths() const {
  std::vector<const PathSpectrum*> paths;
  for (const auto& squat : squats_) paths.push_back(&squat.path);
  return paths;
}

PossibleDefects::PossibleDefects(const SeverityLimits& limits) : squats(possibleSquats, limits) {
  constexpr std::uint32_t seed = 998;
  for (const auto& example : exampleOthers(possibleOthers, seed))
    if (example.kind != Kind::squat) others[example.kind].emplace_back(example.defect);
  for (const auto& example : exampleFlats(possibleFlats, seed)) others[example.kind].emplace_back(example.defect);
}

ExpectedBySpeed::ExpectedBySpeed(const SizeModel& model, const std::vector<const PathSpectrum*>& paths,
                                 const std::vector<EventFeatures>& events, ThreadTeam& team, Monitor& monitor) {
  for (const auto& event : events) expected_.try_emplace(stepOf(event.speed), paths.size());
  for (auto& [step, expected] : expected_) {
    const double speed = std::exp(speedStep * static_cast<double>(step));
    if (monitor.cancelled()) return;
    team.forEach(paths.size(), [&, &values = expected](std::size_t i) {
      values[i] = model.expected(pathEnergies(*paths[i], speed), speed);
    });
    auto& moments = moments_[step];
    for (const auto& each : expected) {
      moments.sum += each, moments.squares += each * each.transpose();
      moments.count += 1;
    }
  }
}

const std::vector<BandValues>& ExpectedBySpeed::at(double speed) const { return expected_.at(stepOf(speed)); }
const ExpectedBySpeed::Moments& ExpectedBySpeed::momentsAt(double speed) const { return moments_.at(stepOf(speed)); }

}  // namespace squat::detection
