#include "detection/ExampleDefects.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace squat::detection {
namespace {

// Numbers in [0, 1) that are the same on every machine.
class Shares {
 public:
  explicit Shares(std::uint32_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_()) / 4294967296.0; }
  double between(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  std::mt19937 engine_;
};

struct Range {
  double low, high;
};
// Light, moderate, severe: a squat belongs to the class of the worse of its two measures.
constexpr Range severityLengths[] = {{0.012, 0.035}, {0.035, 0.060}, {0.060, 0.095}};
constexpr Range severityDepths[] = {{0.03e-3, 0.10e-3}, {0.10e-3, 0.25e-3}, {0.25e-3, 0.50e-3}};

double within(const Range& range, Shares& shares) { return range.low * std::pow(range.high / range.low, shares()); }

// Depth to which a wheel of 0.46 m reaches into a gap of this length.
double felt(double length) { return length * length / (8 * 0.46); }

scenario::Defect profileOf(const std::function<double(double)>& height, double half, double step) {
  scenario::Defect defect;
  defect.shape = scenario::DefectShape::profile;
  defect.lateral = scenario::LateralShape::uniform;
  defect.heightScale = 1;
  const auto count = static_cast<int>(std::lround(2 * half / step));
  for (int i = 0; i <= count; ++i) {
    const double x = -half + 2 * half * i / count;
    defect.points.push_back({x, height(x)});
  }
  return defect;
}

double deepestOf(const scenario::Defect& defect) {
  const auto lowest = std::min_element(defect.points.begin(), defect.points.end(),
                                       [](const auto& a, const auto& b) { return a.height < b.height; });
  return lowest->position;
}

ExampleDefect jointWith(Shares& shares) {
  const double gap = shares.between(5e-3, 9e-3), dip = shares.between(0.1e-3, 0.8e-3);
  const double reach = shares.between(0.12, 0.35), step = shares.between(-0.2e-3, 0.2e-3);
  const auto height = [=](double x) {
    const double ends = -dip * std::pow(std::max(0.0, 1 - std::abs(x) / reach), 1.5);
    const double kink = x > 0 ? step * std::max(0.0, 1 - x / reach) : 0.0;
    return ends + kink - (std::abs(x) < 0.5 * gap ? 0.3e-3 : 0.0);
  };
  return {Kind::joint, 0, 0, profileOf(height, reach + 0.02, 1e-3), 0, 0};
}

ExampleDefect weldWith(Shares& shares) {
  const double length = shares.between(0.12, 0.6), size = shares.between(0.08e-3, 0.4e-3);
  const double sign = shares() < 0.67 ? -1 : 1, wave = shares.between(0.06, 0.15), ripple = shares.between(0, 0.03e-3);
  const auto height = [=](double x) {
    if (std::abs(x) >= 0.5 * length) return 0.0;
    const double bell = 0.5 * (1 + std::cos(2 * std::numbers::pi * x / length));
    return bell * (sign * size + ripple * std::sin(2 * std::numbers::pi * x / wave));
  };
  return {Kind::weld, 0, 0, profileOf(height, 0.5 * length + 0.02, 2e-3), 0, 0};
}

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
    const double length = within(severityLengths[byLength ? severity : other], shares);
    const double depth = within(severityDepths[byLength ? other : severity], shares);
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

std::vector<ExampleDefect> exampleJointsAndWelds(std::size_t count, std::uint32_t seed) {
  Shares shares(seed);
  std::vector<ExampleDefect> examples;
  for (std::size_t i = 0; i < count; ++i) {
    auto example = i % 2 == 0 ? jointWith(shares) : weldWith(shares);
    const double deepest = deepestOf(example.defect);
    example.before = deepest - example.defect.points.front().position;
    example.behind = example.defect.points.back().position - deepest;
    examples.push_back(std::move(example));
  }
  return examples;
}

}  // namespace squat::detection
