#include "render/SyntheticResult.h"

#include <cmath>
#include <cstdint>
#include <memory>

#include "render/SyntheticSurface.h"

namespace squat::tests {
namespace {

constexpr double speed = 30, rate = 25000, runUp = 0.2, beyond = 0.3;

// Response to an impact at time zero: two decaying tones (300 Hz and 1 kHz), quiet before.
double ringing(double t, double low, double high) {
  const double smooth = 1 / (1 + std::exp(-t / 1.5e-4));
  const double late = std::max(t, 0.0);
  return smooth * (low * std::exp(-late / 0.006) * std::sin(2 * M_PI * 300 * t) +
                   high * std::exp(-late / 0.003) * std::sin(2 * M_PI * 1000 * t));
}

// One-sided spectrum of a decaying tone, up to a factor.
double line(double frequency, double centre, double decay) {
  const double detuning = 2 * M_PI * (frequency - centre) * decay;
  return 1 / (1 + detuning * detuning);
}

// The wheel passes the sensors beside the defect: the rail answers at once, the sleeper later and less.
void addTrackside(results::RunResult& result) {
  results::Channel rail{"rail_acceleration", "m/s2", "rail foot", {}};
  results::Channel sleeper{"sleeper_acceleration", "m/s2", "nearest sleeper", {}};
  for (const double time : result.time) {
    const double since = time - runUp / speed;
    rail.values.push_back(ringing(since, 220, 350));
    sleeper.values.push_back(ringing(since - 0.5e-3, 60, 10));
  }
  result.signals.push_back(rail);
  result.signals.push_back(sleeper);
}

void addSignals(results::RunResult& result) {
  const auto count = static_cast<int>((runUp + beyond) / speed * rate) + 1;
  results::Channel box{"aba_filtered", "m/s2", "axle box, vertical, low-passed", {}};
  results::Channel wheel{"wheel_acceleration_filtered", "m/s2", "wheel centre", {}};
  results::Channel force{"contact_force", "N", "vertical", {}}, creep{"creep_force", "N", "longitudinal", {}};
  for (int i = 0; i < count; ++i) {
    const double time = i / rate, since = time - runUp / speed;
    result.time.push_back(time);
    result.position.push_back(-runUp + speed * time);
    const double hum = 1.5 * std::sin(2 * M_PI * 420 * time);
    box.values.push_back(ringing(since, 70, 60) + hum);
    wheel.values.push_back(ringing(since, 55, 40) + 0.5 * hum);
    force.values.push_back(87.8e3 + 420 * ringing(since, 60, 90));
    creep.values.push_back(std::min(0.3 * force.values.back(), 26e3 * std::min(1.0, time / 0.004)));
  }
  results::Channel raw = box;
  raw.name = "aba";
  result.signals = {raw, box, wheel, force, creep};
  addTrackside(result);
}

void addSpectra(results::RunResult& result) {
  for (int i = 0; i < 400; ++i) {
    const double frequency = 12500.0 * i / 400 * 0.25;
    result.frequency.push_back(frequency);
    result.psd.push_back(3.2 * line(frequency, 300, 0.006) + 1.4 * line(frequency, 1000, 0.003) +
                         0.5 * line(frequency, 640, 0.004));
    result.psdWheel.push_back(2.0 * line(frequency, 300, 0.006) + 0.9 * line(frequency, 1000, 0.003));
  }
  result.psdFrom = -0.1;
  result.psdTo = 0.28;
  result.psdWindow = "Hann";
  for (int row = 0; row < 60; ++row) result.scalogramFrequency.push_back(40 * std::pow(2.0, row / 9.0));
  result.scalogramTime = result.time;
  result.scalogramPosition = result.position;
  const double end = result.time.back();
  for (double time : result.time) result.coneOfInfluence.push_back(1.35 / std::max(2e-4, std::min(time, end - time)));
  for (double frequency : result.scalogramFrequency) {
    for (double time : result.time) {
      const double since = time - runUp / speed, width = 6.0 / (2 * M_PI * frequency);
      const double envelope = since < 0 ? std::exp(-std::pow(since / width, 2)) : 1.0;
      const double low =
          std::exp(-std::pow(std::log(frequency / 300) / 0.2, 2)) * std::exp(-std::max(since, 0.0) / 0.004);
      const double high =
          std::exp(-std::pow(std::log(frequency / 1000) / 0.2, 2)) * std::exp(-std::max(since, 0.0) / 0.002);
      result.scalogramPower.push_back(envelope * (4200 * low + 2600 * high));
    }
  }
}

void addProfile(results::RunResult& result) {
  for (int i = 0; i <= 200; ++i) {
    const double x = -0.05 + 0.15 * i / 200;
    double height = 0;
    if (std::abs(x) < 0.025) height = -75e-6 * (1 + std::cos(2 * M_PI * x / 0.05));
    if (x >= 0.025 && x < 0.065) height = -20e-6 * (1 - std::cos(2 * M_PI * (x - 0.025) / 0.04));
    result.profilePosition.push_back(x);
    result.profileHeight.push_back(height);
  }
  // Path of the lowest point of a rigid wheel: the highest that the rail holds it up within its reach.
  for (double at : result.profilePosition) {
    double path = -1;
    for (std::size_t i = 0; i < result.profilePosition.size(); ++i)
      path = std::max(path, result.profileHeight[i] - std::pow(result.profilePosition[i] - at, 2) / (2 * 0.46));
    result.wheelPath.push_back(path);
  }
}

// A groove of 2 um, 3 um deep behind the dip, with compression below it.
void addPermanent(results::RunResult& result) {
  auto& change = result.permanent;
  for (int i = -8; i <= 8; ++i) change.lateral.push_back(1.3e-3 * i);
  for (int i = 0; i <= 16; ++i) change.depth.push_back(1.25e-3 * i);
  for (int i = 0; i <= 120; ++i) {
    const double x = -0.1 + 0.2 * i / 120, bump = std::exp(-std::pow((x - 0.03) / 0.008, 2));
    change.position.push_back(x);
    for (const double y : change.lateral)
      change.height.push_back(-1e-6 * (2 + bump) * std::exp(-y * y / 2e-5) +
                              0.3e-6 * std::exp(-std::pow(std::abs(y) - 7e-3, 2) / 5e-6));
    for (const double z : change.depth) {
      change.equivalentStrain.push_back(1e-3 * (1 + bump) * std::exp(-std::pow((z - 3e-3) / 2e-3, 2)));
      change.stressAlong.push_back(-3e8 * std::exp(-std::pow(z / 5e-3, 2)) +
                                   4e7 * std::exp(-std::pow((z - 9e-3) / 4e-3, 2)));
      change.stressAcross.push_back(0.6 * change.stressAlong.back());
      change.stressVertical.push_back(0);
      change.vonMises.push_back(std::abs(change.stressAlong.back()));
    }
  }
}

// Hertz's pressure over an ellipse of 14 x 10 mm, slipping in its rear third.
void addPatch(results::RunResult& result) {
  results::PatchSnapshot patch;
  patch.name = "impact";
  constexpr double along = 7e-3, across = 5e-3, size = 1.3e-3, highest = 1.2e9;
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j) {
      const double x = size * i, y = size * j;
      const double left = 1 - x * x / (along * along) - y * y / (across * across);
      patch.x.push_back(static_cast<float>(x));
      patch.y.push_back(static_cast<float>(y));
      patch.pressure.push_back(static_cast<float>(highest * std::sqrt(std::max(left, 0.0))));
      patch.tractionX.push_back(0.3f * patch.pressure.back());
      patch.tractionY.push_back(0);
      patch.slipping.push_back(x < -along / 3);
      patch.area.push_back(static_cast<float>(size * size));
    }
  result.patches.push_back(patch);
}

}  // namespace

results::RunResult syntheticResult() {
  results::RunResult result;
  result.stem = "light-defect";
  result.title = "Light defect of 50 mm over a sleeper (made up)";
  result.caseHash = "1a2b3c4d";
  result.codeVersion = "0.1.0";
  result.complete = true;
  result.stopReason = "done";
  result.created = "2026-01-01T00:00:00Z";
  result.speed = speed;
  addSignals(result);
  addSpectra(result);
  addProfile(result);
  addPermanent(result);
  addPatch(result);
  result.equilibrium.push_back({"contact_force", "N", "vertical", 87.8e3});
  result.surface = syntheticSurface(-runUp);
  result.snapshots.push_back(syntheticSnapshot(result.surface, -runUp, runUp + 0.004));
  return result;
}

results::RunResult withoutCutFaces(results::RunResult result) {
  auto& mesh = result.surface;
  const results::SurfaceMesh all = mesh;
  mesh.quads.clear(), mesh.part.clear();
  for (std::size_t quad = 0; quad < all.part.size(); ++quad) {
    if (all.partNames[all.part[quad]].ends_with(" cut")) continue;
    mesh.part.push_back(all.part[quad]);
    for (std::size_t corner = 0; corner < 4; ++corner) mesh.quads.push_back(all.quads[4 * quad + corner]);
  }
  return result;
}

results::RunResult syntheticWhole(double rightStress) {
  constexpr float trackCentre = -0.75f;
  const auto factor = static_cast<float>(rightStress);
  auto result = syntheticResult();
  auto& mesh = result.surface;
  const results::SurfaceMesh half = mesh;
  const auto count = static_cast<std::int32_t>(half.points.size() / 3);
  for (std::size_t i = 0; i < half.points.size(); ++i)
    mesh.points.push_back(i % 3 == 1 ? 2 * trackCentre - half.points[i] : half.points[i]);
  for (std::size_t quad = 0; quad < half.part.size(); ++quad) {
    if (half.partNames[half.part[quad]].ends_with(" cut")) continue;
    mesh.part.push_back(half.part[quad]);
    for (std::size_t corner = 4; corner-- > 0;) mesh.quads.push_back(count + half.quads[4 * quad + corner]);
  }
  for (auto& snapshot : result.snapshots) {
    const auto stress = snapshot.vonMises, displacement = snapshot.displacement;
    for (const float each : stress) snapshot.vonMises.push_back(factor * each);
    for (std::size_t i = 0; i < displacement.size(); ++i)
      snapshot.displacement.push_back(i % 3 == 1 ? -displacement[i] : displacement[i]);
  }
  for (auto& patch : result.patches) {
    auto right = patch;
    for (float& pressure : right.pressure) pressure *= factor;
    patch.right = std::make_shared<const results::PatchSnapshot>(right);
  }
  return result;
}

}  // namespace squat::tests
