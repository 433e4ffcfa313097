// Roughness back from a record that the model computed: explicit finite elements in time on one side, receptances in
// the frequency domain on the other.
//
// A wheel with damped modes rolls at 20 m/s over two metres of rail, whose heights of 25 to 400 mm begin and end within
// the record: the wheel starts at rest and rings out, so that no window needs to shorten the waves. What comes back is
// compared with the heights that were rolled over, third octave by third octave.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "FixtureCase.h"
#include "case/PointsText.h"
#include "case/Resolve.h"
#include "roughness/RecordRoughness.h"
#include "simulation/RunCase.h"

namespace squat::roughness {
namespace {

constexpr double speed = 20;  // [m/s]

std::vector<scenario::ProfilePoint> heightsThatEnd() {
  scenario::Irregularity options;
  options.seed = 5, options.offset = 6, options.shortest = 0.02, options.longest = 0.4;
  const auto endless =
      scenario::IrregularSurface::ofSpectrum({{0.003, -11}, {0.02, -6.2}, {0.1, 5}, {0.4, 17}}, options, -1.2);
  const auto grown = [](double along) { return 0.5 - 0.5 * std::cos(M_PI * std::clamp(along, 0.0, 1.0)); };
  std::vector<scenario::ProfilePoint> points;
  for (int i = 0; i <= 880; ++i) {
    const double x = -1 + 0.0025 * i;
    points.push_back({x, endless.height(x) * grown((x + 1) / 0.15) * grown((0.6 - x) / 0.15)});
  }
  return points;
}

cases::CaseDescription roughCase() {
  return cases::loadCase(tests::fixtureCase("smooth-rail"),
                         {"tiny",
                          {{"mesh.contact_size", "5"},
                           {"mesh.rolling_size", "5"},
                           {"mesh.section_size", "16"},
                           {"mesh.wheel_sectors", "48"},
                           {"motion.run_up", "1"},
                           {"motion.beyond", "1.2"},
                           {"motion.speed", "20"},
                           {"motion.torque", "0"},
                           {"track.length", "10"},
                           {"track.rail_ends", "absorbing"},
                           {"wheelset.damping_ratio", "0.05"},
                           {"wheelset.damping_limit", "3000"},
                           {"rail.irregularity", "heights"},
                           {"rail.irregularity_points", cases::formatPoints(heightsThatEnd(), -3)}}});
}

TEST(RoughnessOfAComputedRecord, ComesBack) {
  const auto description = roughCase();
  simulation::RunOptions run;
  run.wheelsetModes = run.snapshots = false;
  Monitor silent;
  const auto result = simulation::runCase(description, run, silent);
  TransferOptions options;
  const auto transfer = transferFunction(cases::resolve(description), options, silent);
  ASSERT_TRUE(transfer.complete);
  const double rate = 1 / (result.time[1] - result.time[0]);
  GaugeOptions gauge;
  // 80 to 630 Hz. Below lies the notch of the tilting wheel, where the box feels little (3.8 dB off at 0.32 m); above,
  // sleepers under the wheel change the response by 10 dB (pinned-pinned mode).
  gauge.shortest = 0.0315, gauge.longest = 0.26, gauge.filter = ContactFilter::uniform;
  gauge.stretch = 100, gauge.quietEnds = true;
  const auto found =
      roughnessOf({{0, 1 / rate, *result.signal("aba"), "aba", "m/s2"}, result.position}, transfer, gauge);
  const auto bands = wavelengthBands(gauge.shortest, gauge.longest);
  const auto squares = bandSquares(quietSpectrumOf(*result.signal("irregularity"), rate), bands, speed);
  ASSERT_EQ(found.levels.size(), bands.size());
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const double difference = found.levels[i].level - levelOfSquare(squares[i]);
    std::printf("%6.1f mm  %5.1f dB  %+.1f dB, track %.1f dB, pads %.1f dB\n", 1e3 * bands[i].middle,
                levelOfSquare(squares[i]), difference, found.levels[i].track, found.levels[i].pads);
    // Seen: 1.4 dB. Half the difference between over a sleeper and midspan is up to 1.8 dB here.
    EXPECT_LT(std::abs(difference), 2) << bands[i].middle;
  }
}

}  // namespace
}  // namespace squat::roughness
