#include "detection/ExampleDefects.h"

#include <cmath>

#include "detection/Shares.h"

namespace squat::detection {
namespace {

// Light, moderate, severe: a squat belongs to the class of the worse of its two measures.
constexpr Range severityLengths[] = {{0.012, 0.035}, {0.035, 0.060}, {0.060, 0.095}};
constexpr Range severityDepths[] = {{0.03e-3, 0.10e-3}, {0.10e-3, 0.25e-3}, {0.25e-3, 0.50e-3}};

// Depth to which a wheel of 0.46 m reaches into a gap of this length.
double felt(double length) { return length * length / (8 * 0.46); }

}  // namespace

SquatForm ExampleDefect::form() const {
  if (kind != Kind::squat) return {};
  return {defect.shape, defect.middleHeight, defect.waveLength, defect.waveDepth, defect.waveCount};
}

std::vector<ExampleDefect> exampleSquats(std::size_t count, std::uint32_t seed) {
  using enum scenario::DefectShape;
  constexpr scenario::DefectShape shapes[] = {cosine, wshape, dipWithWave};
  Shares shares(seed);
  std::vector<ExampleDefect> examples;
  for (std::size_t i = 0; examples.size() < count; ++i) {
    const std::size_t severity = i % 3;
    const auto other = static_cast<std::size_t>(shares() * static_cast<double>(severity + 1));
    const bool byLength = shares() < 0.5;
    const double length = shares.within(severityLengths[byLength ? severity : other]);
    const double depth = shares.within(severityDepths[byLength ? other : severity]);
    if (depth > 1.5 * felt(length)) continue;
    ExampleDefect example{Kind::squat, length, depth, {}, 0, 0};
    auto& defect = example.defect;
    defect.shape = shapes[examples.size() / 3 % 3];
    defect.lateral = scenario::LateralShape::uniform;
    defect.length = length, defect.depth = depth;
    defect.middleHeight = shares.between(0.1, 0.5);
    if (defect.shape == dipWithWave) {
      defect.waveLength = shares.between(0.02, 0.04);
      defect.waveDepth = depth * shares.between(0.1, 0.4);
      defect.waveCount = 1 + std::floor(shares() * 3);
    }
    example.before = 0.5 * length;
    example.behind = 0.5 * length + defect.waveLength * defect.waveCount;
    examples.push_back(std::move(example));
  }
  return examples;
}

}  // namespace squat::detection
