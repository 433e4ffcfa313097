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
constexpr std::size_t possibleSquats = 2000, possibleJointsAndWelds = 1000;

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
  for (const auto& example : exampleJointsAndWelds(possibleJointsAndWelds, seed))
    (example.kind == Kind::joint ? joints : welds).emplace_back(example.defect);
}

ExpectedBySpeed::ExpectedBySpeed(const SizeModel& model, std::vector<const PathSpectrum*> paths)
    : model_(model), paths_(std::move(paths)) {}

const std::vector<BandValues>& ExpectedBySpeed::at(double speed) {
  const long step = std::lround(std::log(speed) / speedStep);
  const auto [found, isNew] = expected_.try_emplace(step);
  if (isNew) {
    const double rounded = std::exp(speedStep * static_cast<double>(step));
    for (const auto* path : paths_) found->second.push_back(model_.expected(pathEnergies(*path, rounded), rounded));
  }
  return found->second;
}

}  // namespace squat::detection
