// Irregularities that are no squats, and squats close behind each other: heights of the rail along the track.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "detection/ExampleDefects.h"
#include "detection/Shares.h"

namespace squat::detection {
namespace {

using Height = std::function<double(double x)>;  // [m] of [m]

scenario::Defect profileOf(const Height& height, double half, double step) {
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

double bell(double x, double length) {
  return std::abs(x) < 0.5 * length ? 0.5 * (1 + std::cos(2 * std::numbers::pi * x / length)) : 0.0;
}

// Two sides that dip to each other, each bent as x^power. They meet at one depth: slope times reach is the same.
struct Ends {
  double angle = 0;  // [rad] between both sides
  double before = 0, behind = 0, power = 1.5;
  double step = 0;  // [m] by which the end behind is higher

  double depth() const { return angle * before * behind / (before + behind) / power; }
  double height(double x) const {
    if (x < 0) return -depth() * std::pow(std::max(0.0, 1 + x / before), power);
    return -depth() * std::pow(std::max(0.0, 1 - x / behind), power) + step * std::max(0.0, 1 - x / behind);
  }
  double half() const { return std::max(before, behind) + 0.02; }
};

Ends endsWith(Shares& shares, Range angle, Range reach, double step) {
  Ends ends;
  ends.angle = shares.within(angle), ends.power = shares.between(1.2, 3);
  ends.before = shares.within(reach), ends.behind = ends.before * shares.between(0.7, 1.4);
  ends.step = shares.between(-step, step);
  return ends;
}

ExampleDefect irregularity(Kind kind, const Height& height, double half, double step = 1e-3) {
  return {kind, 0, 0, profileOf(height, half, step), 0, 0};
}

// Impacts crush the ballast below a joint.
double crushed(Shares& shares, double often) {
  const double rest = shares.between(0.15, 0.6);
  return shares() < often ? rest : 1.0;
}

// A gap between rail ends that dip to it, one higher than the other, the far one worn by impacts.
ExampleDefect joint(Shares& shares) {
  const auto ends = endsWith(shares, {5e-3, 20e-3}, {0.08, 0.40}, 0.3e-3);
  const double gap = shares.within({5e-3, 20e-3}), batter = shares.within({0.02e-3, 0.3e-3});
  const double worn = shares.between(0.04, 0.12);
  const auto surface = [=](double x) { return ends.height(x) - (x > 0 ? batter * std::max(0.0, 1 - x / worn) : 0.0); };
  // A wheel of 0.46 m reaches 0.1 mm into a gap of 20 mm: its floor is lower, and no steeper than the contact can take.
  const double floor = 0.05e-3 + 0.01 * gap;
  const auto height = [=](double x) {
    if (std::abs(x) >= 0.5 * gap) return surface(x);
    const double share = x / gap + 0.5;
    return std::lerp(surface(-0.5 * gap), surface(0.5 * gap), share) - 4 * floor * share * (1 - share);
  };
  auto example = irregularity(Kind::joint, height, ends.half());
  example.support = crushed(shares, 0.4);
  return example;
}

// Ends held by glued bars: a narrow filled gap, little dip.
ExampleDefect insulatedJoint(Shares& shares) {
  const auto ends = endsWith(shares, {1e-3, 6e-3}, {0.06, 0.25}, 0.1e-3);
  const double gap = shares.between(4e-3, 8e-3), low = shares.within({0.03e-3, 0.2e-3});
  const auto height = [=](double x) {
    if (std::abs(x) >= 0.5 * gap) return ends.height(x);
    const double share = x / gap + 0.5;
    return std::lerp(ends.height(-0.5 * gap), ends.height(0.5 * gap), share) - 4 * low * share * (1 - share);
  };
  auto example = irregularity(Kind::joint, height, ends.half());
  example.support = crushed(shares, 0.2);
  return example;
}

// A smooth dip or hump, wavy or peaked inside. Short ones are low: their slopes stay below 10 mrad.
ExampleDefect weldOf(Shares& shares, Range lengths) {
  const double length = shares.within(lengths), steepest = shares.within({1e-3, 10e-3});
  const double size = std::min(0.5e-3, steepest * length / std::numbers::pi) * (shares() < 0.6 ? -1 : 1);
  // Two and a half waves at most: from three on it would be corrugation.
  const double wave = length / shares.between(1.2, 2.5), ripple = shares.between(0, 0.03e-3);
  const bool isPeaked = shares() < 0.4;
  const auto height = [=](double x) {
    if (std::abs(x) >= 0.5 * length) return 0.0;
    const double form = isPeaked ? std::pow(1 - 2 * std::abs(x) / length, 1.3) : bell(x, length);
    return form * size + bell(x, length) * ripple * std::sin(2 * std::numbers::pi * x / wave);
  };
  return irregularity(Kind::weld, height, 0.5 * length + 0.02, length < 0.1 ? 0.5e-3 : 2e-3);
}
ExampleDefect longWeld(Shares& shares) { return weldOf(shares, {0.1, 1.0}); }
ExampleDefect shortWeld(Shares& shares) { return weldOf(shares, {0.02, 0.1}); }

// The wheel goes down on the wing rail and is lifted by the nose: a kink, often with a step down onto the nose.
ExampleDefect crossing(Shares& shares) {
  auto ends = endsWith(shares, {5e-3, 20e-3}, {0.12, 0.50}, 0);
  ends.step = -shares.between(0, 0.4e-3), ends.power = shares.between(1, 1.6);
  const double worn = shares.within({0.05e-3, 0.4e-3}), length = shares.between(0.05, 0.15), gap = 6e-3;
  const auto height = [=](double x) {
    const double share = std::clamp(x / gap + 0.5, 0.0, 1.0);  // the wheel passes from one to the other over this
    return std::lerp(ends.height(std::min(x, -1e-9)), ends.height(std::max(x, 0.0)), share) -
           worn * bell(x - 0.5 * length, length);
  };
  return irregularity(Kind::other, height, ends.half());
}

// Waves that swell and fade.
ExampleDefect corrugation(Shares& shares) {
  constexpr double longest = 1.2;  // [m]: what is farther off, no event sees, and it would be computed
  const double wave = shares.within({25e-3, 80e-3});
  const double waves = std::floor(std::min(shares.within({3, 21}), longest / wave));
  const double size = shares.within({0.02e-3, 0.12e-3}), half = 0.5 * waves * wave, fade = shares.between(0.15, 0.5);
  const double uneven = shares.between(0, 0.4), turn = shares.between(0, 6);
  const auto height = [=](double x) {
    const double toEnd = std::min(1.0, (half - std::abs(x)) / (fade * half));
    if (toEnd <= 0) return 0.0;
    const double swell = std::sin(0.5 * std::numbers::pi * toEnd), now = 1 + uneven * std::sin(turn + 7 * x / half);
    return 0.5 * size * swell * now * std::sin(2 * std::numbers::pi * x / wave);
  };
  return irregularity(Kind::corrugation, height, half + 0.02);
}

// Two or three dips, as squats on a stretch that slips stand.
ExampleDefect closeSquats(Shares& shares) {
  struct Dip {
    double place = 0, length = 0, depth = 0;
  };
  std::array<Dip, 3> dips;
  const std::size_t count = shares() < 0.6 ? 2 : 3;
  double place = 0;
  ExampleDefect example{Kind::squat, 0, 0, {}, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const double length = shares.within({0.02, 0.07});
    const double depth = std::min(shares.within({0.05e-3, 0.35e-3}), length * length / (8 * 0.46));
    dips[i] = {place, length, depth};
    if (depth > example.depth) example.length = length, example.depth = depth;
    place += 0.5 * length + shares.within({0.05, 0.25});
  }
  const double middle = 0.5 * place;
  example.defect = profileOf(
      [=](double x) {
        double height = 0;
        for (std::size_t i = 0; i < count; ++i)
          height = std::min(height, -dips[i].depth * bell(x + middle - dips[i].place, dips[i].length));
        return height;
      },
      middle + 0.06, 1e-3);
  return example;
}

// Between chord and what rolling rounds it to: -depth (1 - (2 s/length)^2)^power, with slopes up to 4 depth/length at
// the ends of the fresh one.
ExampleDefect flat(Shares& shares) {
  constexpr double radius = 0.46;
  const double chord = shares.within({15e-3, 60e-3}), worn = shares();
  const double depth = chord * chord / (8 * radius) * (1 - 0.4 * worn);
  const double length = chord * (1 + worn), power = 1 + worn;
  const auto height = [=](double s) {
    return -depth * std::pow(std::max(0.0, 1 - 4 * s * s / (length * length)), power);
  };
  return irregularity(Kind::flat, height, 0.5 * length + 5e-3, 1e-3);
}

double deepestOf(const scenario::Defect& defect) {
  const auto lowest = std::min_element(defect.points.begin(), defect.points.end(),
                                       [](const auto& a, const auto& b) { return a.height < b.height; });
  return lowest->position;
}

void takeReach(ExampleDefect& example) {
  const double deepest = deepestOf(example.defect);
  example.before = deepest - example.defect.points.front().position;
  example.behind = example.defect.points.back().position - deepest;
}

}  // namespace

std::vector<ExampleDefect> exampleOthers(std::size_t count, std::uint32_t seed) {
  constexpr std::array makers{joint, longWeld, corrugation, insulatedJoint, crossing, closeSquats, shortWeld, joint};
  Shares shares(seed);
  std::vector<ExampleDefect> examples;
  for (std::size_t i = 0; i < count; ++i) {
    examples.push_back(makers[i % makers.size()](shares));
    takeReach(examples.back());
  }
  return examples;
}

std::vector<ExampleDefect> exampleFlats(std::size_t count, std::uint32_t seed) {
  Shares shares(seed);
  std::vector<ExampleDefect> examples;
  for (std::size_t i = 0; i < count; ++i) {
    examples.push_back(flat(shares));
    takeReach(examples.back());
  }
  return examples;
}

}  // namespace squat::detection
