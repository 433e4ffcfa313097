#include "verification/ReceptanceComparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "case/Resolve.h"
#include "model/Model.h"
#include "verification/SectionFlexibility.h"
#include "verification/Seen.h"
#include "verification/TrackBeam.h"

namespace squat::verification {

namespace {

using Complexes = std::vector<std::complex<double>>;

double level(const std::complex<double>& value) { return 20 * std::log10(std::abs(value)); }

using Quantity = double (*)(const std::complex<double>&);

double interpolated(const std::vector<double>& frequency, const Complexes& values, double at, Quantity quantity) {
  const double step = frequency[1] - frequency[0], location = (at - frequency[0]) / step;
  const auto i =
      static_cast<std::size_t>(std::clamp(std::floor(location), 0.0, static_cast<double>(frequency.size()) - 2.0));
  const double t = location - static_cast<double>(i);
  return (1 - t) * quantity(values[i]) + t * quantity(values[i + 1]);
}

// The receptance at the place of the force lags by 0 to 180 degrees: nothing drives it.
double lag(const std::complex<double>& value) { return -std::arg(value) * 180 / std::numbers::pi; }

// How far `expected` lies outside the solid's values within 4 % of a frequency.
double outside(const receptance::TrackReceptance& solid, const Complexes& values, double frequency, double expected,
               Quantity quantity) {
  double lowest = 1e9, highest = -1e9;
  for (int k = -20; k <= 20; ++k) {
    const double at = std::clamp(frequency * (1 + kShift * k / 20), solid.frequency.front(), solid.frequency.back());
    const double found = interpolated(solid.frequency, values, at, quantity);
    lowest = std::min(lowest, found), highest = std::max(highest, found);
  }
  return expected < lowest ? lowest - expected : expected > highest ? expected - highest : 0.0;
}

TrackBeam beamOf(const cases::CaseDescription& description) {
  return verification::beamOf(model::buildModel(receptance::receptanceCase(cases::resolve(description))));
}

// Whether a frequency is at least 4 % away from every one of a list.
bool awayFrom(const std::vector<double>& resonances, double frequency) {
  return std::none_of(resonances.begin(), resonances.end(),
                      [&](double f) { return std::abs(f - frequency) < kShift * f; });
}

}  // namespace

// What the section gives way between its mean and the pads is computed from a slice by itself (SectionFlexibility.h).
TrackBeam beamOf(const model::Model& model) {
  const auto& own = model.scenario;
  const auto& rail = model.blocks[model.rail];
  auto section = beamSection(rail.section);
  std::vector<double> across;
  for (const double location : {-0.375, -0.125, 0.125, 0.375}) across.push_back(location * own.pad.width);
  section.footFlexibility =
      footFlexibility(rail.section, own.rail.material, across, own.pad.stiffness / own.pad.length);
  return {own, section, rail.positions.front(), model.sleeperPositions};
}

double levelDifference(const receptance::TrackReceptance& solid, const std::vector<std::complex<double>>& values,
                       double frequency, double expected) {
  return outside(solid, values, frequency, expected, level);
}

receptance::TrackReceptance solidTrack(const cases::CaseDescription& d, receptance::ReceptanceOptions options) {
  options.wheelset = false;
  options.threads = 1;
  Monitor quiet;
  return receptance::trackReceptance(cases::resolve(d), options, quiet);
}

void compareWithBeam(const cases::CaseDescription& d, double step, const receptance::ReceptanceOptions& options) {
  const auto solid = solidTrack(d, options);
  ASSERT_TRUE(solid.complete);
  EXPECT_TRUE(solid.notes.empty());
  const auto beam = beamOf(d);
  std::vector<double> frequency;
  for (double f = options.lowest; f <= options.highest; f += step) frequency.push_back(f);
  std::vector<Complexes> expected(solid.points.size());
  for (const double f : frequency) {
    const auto values = beam.receptance({solid.points[0].read, solid.points[1].read}, f);
    for (std::size_t p = 0; p < expected.size(); ++p) expected[p].push_back(values[p]);
  }
  for (std::size_t p = 0; p < expected.size(); ++p) {
    const auto& point = solid.points[p];
    // What stands out less than levels may differ may also vanish.
    const auto theory = receptance::resonances(frequency, expected[p], kDecibels);
    const auto found = receptance::resonances(solid.frequency, point.receptance);
    double worst = 0, at = 0, shift = 0, worstLag = 0, lagAt = 0;
    for (std::size_t i = 0; i < frequency.size(); ++i) {
      if (!awayFrom(theory, frequency[i])) continue;
      const double off = levelDifference(solid, point.receptance, frequency[i], level(expected[p][i]));
      if (off > worst) worst = off, at = frequency[i];
      if (frequency[i] * (1 + kShift) > options.highest) continue;  // no room for the shift
      const double late = outside(solid, point.receptance, frequency[i], lag(expected[p][i]), lag);
      if (late > worstLag) worstLag = late, lagAt = frequency[i];
    }
    EXPECT_LT(worst, kDecibels) << point.name << " at " << at << " Hz";
    EXPECT_LT(worstLag, kDegrees) << point.name << " at " << lagAt << " Hz";
    for (const double f : theory) {
      const auto nearest = std::min_element(found.begin(), found.end(),
                                            [f](double a, double b) { return std::abs(a - f) < std::abs(b - f); });
      ASSERT_NE(nearest, found.end());
      EXPECT_NEAR(*nearest, f, kShift * f) << point.name;
      shift = std::max(shift, std::abs(*nearest / f - 1));
    }
    seen("resonances", 100 * shift, "%");
    seen("levels", worst, "dB");
    seen("phases", worstLag, "degrees");
    std::printf("%s: largest difference of level at %.0f Hz, of phase at %.0f Hz\n", point.name.c_str(), at, lagAt);
  }
}

}  // namespace squat::verification
