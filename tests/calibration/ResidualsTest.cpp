#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <numbers>

#include "calibration/ReceptanceResiduals.h"
#include "calibration/SignalResiduals.h"
#include "calibration/StatementResiduals.h"
#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::calibration {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::HasSubstr;

statements::Statement range(double low, double high) {
  statements::Statement statement;
  statement.low = low, statement.high = high;
  return statement;
}

TEST(StatementResidual, IsOneAtTheLimits) {
  auto peak = range(83, 147);
  peak.expected = 115;
  EXPECT_NEAR(statementResidual(peak, 115), 0, 1e-12);
  EXPECT_NEAR(statementResidual(peak, 147), 1, 1e-12);
  EXPECT_NEAR(statementResidual(peak, 83), -1, 1e-12);
  EXPECT_NEAR(statementResidual(range(250, 400), 250), -1, 1e-12);
  auto atLimit = range(100, 150);
  atLimit.expected = 100;
  EXPECT_EQ(statementResidual(atLimit, 100), 0);
  EXPECT_LT(statementResidual(atLimit, 99), -1);  // broken
  EXPECT_NEAR(statementResidual(atLimit, 150), 1, 1e-12);
  EXPECT_NEAR(statementResidual(range(2, INFINITY), 2), -1, 1e-12);
  EXPECT_NEAR(statementResidual(range(2, INFINITY), 2.5), 0, 1e-12);  // a quarter inside
  EXPECT_NEAR(statementResidual(range(2, INFINITY), 1.5), -2, 1e-12);
  EXPECT_NEAR(statementResidual(range(-INFINITY, 5), 6.25), 2, 1e-12);
}

// The wave after an impact that a calibration compares: 30 m/s, from 0.6 m before to 0.6 m behind it.
results::RunResult wave(double height, double frequency) {
  results::RunResult result;
  result.speed = 30;
  signals::Channel aba{"aba", "m/s2", "", {}};
  for (int i = 0; i < 1000; ++i) {
    const double time = i / 25000.0, after = time - 0.02;
    result.time.push_back(time);
    result.position.push_back(30 * after);
    aba.values.push_back(
        after < 0 ? 0 : height * std::exp(-after / 0.004) * std::sin(2 * std::numbers::pi * frequency * after));
  }
  result.signals.push_back(aba);
  return result;
}

std::string writeMeasured(const std::string& path, const results::RunResult& result) {
  std::ofstream file(path);
  file << "time [s],position [m],aba [m/s2]\n";
  for (std::size_t i = 0; i < result.time.size(); ++i)
    file << result.time[i] << "," << result.position[i] + 0.05 << "," << result.signals[0].values[i] << "\n";
  return path;
}

MeasuredSignal measured(const std::string& path, double noise) {
  SignalTarget target;
  target.name = "measured", target.files = {path}, target.noise = noise;
  return readMeasured(target);
}

TEST(SignalResidual, VanishesForTheSameSignalElsewhere) {
  const TemporaryFolder folder;
  const auto value = signalValue(measured(writeMeasured(folder / "a.csv", wave(100, 600)), 0.1), wave(100, 600));
  ASSERT_TRUE(value.value);
  EXPECT_LT(*value.value, 0.05);  // text with six digits, positions 50 mm off
  EXPECT_TRUE(value.isMet);
  // 0.38 m at two samples a period of 2 kHz, 7.5 mm.
  EXPECT_NEAR(static_cast<double>(value.residuals.size()), 0.38 / 0.0075, 2);
}

// A fifth larger: every residual is a fifth of the sample over the noise, whose root mean square is known.
TEST(SignalResidual, IsTheDifferenceOverTheNoise) {
  const TemporaryFolder folder;
  const auto target = measured(writeMeasured(folder / "a.csv", wave(100, 600)), 0.1);
  const auto value = signalValue(target, wave(120, 600));
  double squares = 0;
  const auto sample = signalValue(target, wave(200, 600));  // twice as large: the signal itself over the noise
  for (const double residual : sample.residuals) squares += residual * residual;
  ASSERT_TRUE(value.value);
  EXPECT_NEAR(*value.value, 0.2 * std::sqrt(squares / static_cast<double>(sample.residuals.size())), 0.02);
  // Analytically: rms of h exp(-t/tau) sin(wt) over 0.38 m / 30 m/s is h sqrt(tau / 4 / T) where tau << T.
  EXPECT_NEAR(*value.value * target.noise, 20 * std::sqrt(0.004 / 4 / (0.38 / 30)), 1.0);
}

TEST(SignalResidual, AnotherFrequencyIsNotMet) {
  const TemporaryFolder folder;
  const auto target = measured(writeMeasured(folder / "a.csv", wave(100, 600)), 0.1);
  const auto near = signalValue(target, wave(100, 630)), far = signalValue(target, wave(100, 900));
  EXPECT_FALSE(far.isMet);
  EXPECT_LT(near.misfit, far.misfit);
}

TEST(SignalResidual, OtherUnitsAreRefused) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.csv") << "time [s],speed [m/s],aba [kN]\n0,30,1\n0.001,30,2\n0.002,30,3\n";
  try {
    measured(folder / "a.csv", 0.1);
    FAIL() << "taken";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("must be an acceleration"));
  }
}

// A mass on a spring with a damper.
receptance::TrackReceptance computed(double scale = 1) {
  receptance::TrackReceptance result;
  receptance::PointReceptance point;
  point.name = "over a sleeper";
  for (double f = 50; f <= 1500; f += 1) {
    const std::complex<double> w(0, 2 * std::numbers::pi * f);
    result.frequency.push_back(f);
    point.receptance.push_back(scale / (1e8 + 3e4 * w + 100.0 * w * w));
  }
  result.points.push_back(point);
  return result;
}

MeasuredReceptance measuredReceptance(const std::string& folder, const std::string& head, double unit, double scale) {
  const auto path = folder + "/h.csv";
  std::ofstream file(path);
  file.precision(12);
  file << head << "\n";
  const auto truth = computed(scale);
  for (std::size_t i = 0; i < truth.frequency.size(); ++i) {
    const auto h = truth.points[0].receptance[i] / unit;
    file << truth.frequency[i] << "," << std::abs(h);
    if (head.find("phase") != std::string::npos) file << "," << std::arg(h) * 180 / std::numbers::pi;
    file << "\n";
  }
  file.close();
  ReceptanceTarget target;
  target.name = "hammer", target.file = path, target.point = "over a sleeper";
  return readMeasuredReceptance(target);
}

TEST(ReceptanceResidual, OneDecibelIsOneResidual) {
  const TemporaryFolder folder;
  const auto louder = measuredReceptance(folder.path(), "frequency [Hz],magnitude [m/N]", 1, std::pow(10, 1.0 / 20));
  const auto value = receptanceValue(louder, computed());
  EXPECT_LE(value.residuals.size(), 61u);
  EXPECT_THAT(value.residuals, Each(DoubleNear(-1, 1e-6)));
  EXPECT_TRUE(value.isMet);
}

TEST(ReceptanceResidual, UnitsAndPhaseAreRead) {
  const TemporaryFolder folder;
  const auto other = measuredReceptance(folder.path(), "frequency [Hz],magnitude [mm/kN],phase [deg]", 1e-6, 1);
  ASSERT_TRUE(other.hasPhase);
  EXPECT_THAT(receptanceValue(other, computed()).residuals, Each(DoubleNear(0, 1e-6)));
  // A quarter of a circle ahead: 90 / 6.6 at every frequency, magnitudes as they are.
  auto turned = computed();
  for (auto& h : turned.points[0].receptance) h *= std::complex<double>(0, 1);
  EXPECT_NEAR(receptanceValue(other, turned).residuals[1], 90 / 6.6, 1e-6);
}

// The same response, H = 1e-8 (1 - 0.5 i) / (1 + f / 1000 Hz), as hammer tests write it: velocity is i w, acceleration
// -w^2 times the displacement.
TEST(ReceptanceResidual, FormsOfHammerTestsAreOne) {
  const TemporaryFolder folder;
  ReceptanceTarget target;
  target.file = folder / "h.csv", target.point = "over a sleeper", target.lowest = 50, target.highest = 2000;
  const auto response = [](double f) { return std::complex<double>(1e-8, -0.5e-8) / (1 + f / 1000); };
  const auto read = [&](const std::string& head, const std::function<std::string(double, std::complex<double>)>& row) {
    std::ofstream file(target.file);
    file << head << "\n";
    for (const double f : {100.0, 250.0, 600.0, 1500.0}) file << f << "," << row(f, response(f)) << "\n";
    file.close();
    return readMeasuredReceptance(target);
  };
  const auto two = [](double a, double b) {
    char text[80];
    std::snprintf(text, sizeof text, "%.12e,%.12e", a, b);
    return std::string(text);
  };
  const auto parts = [&](double, std::complex<double> h) { return two(h.real(), h.imag()); };
  const auto inRadians = [&](double, std::complex<double> h) { return two(std::abs(h), std::arg(h)); };
  const auto derived = [](int times, double f) {
    return std::pow(std::complex<double>(0, 2 * std::numbers::pi * f), times);
  };
  const std::vector<MeasuredReceptance> forms{
      read("Frequency [Hz],Re [m/N],Im [m/N]", parts), read("frequency [Hz],magnitude [m/N],phase [Rad]", inRadians),
      read("frequency [Hz],magnitude [m/N],angle [radians]", inRadians),
      read("frequency [Hz],real [(m/s)/N],imag [(m/s)/N]",
           [&](double f, std::complex<double> h) { return parts(f, h * derived(1, f)); }),
      read("frequency [Hz],accelerance [m/s^2/kN],phase [deg],coherence", [&](double f, std::complex<double> h) {
        const auto a = h * derived(2, f) * 1e3;
        return two(std::abs(a), std::arg(a) * 180 / std::numbers::pi) + ",0.98";
      })};
  for (const auto& form : forms) {
    ASSERT_EQ(form.frequency.size(), 4u);
    ASSERT_TRUE(form.hasPhase);
    for (std::size_t i = 0; i < 4; ++i)  // twelve digits are written
      EXPECT_LT(std::abs(form.receptance[i] - response(form.frequency[i])), 1e-10 * std::abs(form.receptance[i]));
  }
  EXPECT_THROW(read("frequency [Hz],magnitude [m/N],phase", inRadians), FileError);
  EXPECT_THROW(read("frequency [Hz],magnitude,phase [rad]", inRadians), FileError);
}

TEST(ReceptanceResidual, CoherenceIsNoMagnitude) {
  const TemporaryFolder folder;
  std::ofstream(folder / "h.csv") << "Frequency,magnitude [m/N],coherence\n100,1e-8,0.9\n200,2e-8,0.9\n300,3e-8,0.9\n";
  ReceptanceTarget target;
  target.file = folder / "h.csv", target.point = "over a sleeper";
  const auto measured = readMeasuredReceptance(target);
  EXPECT_EQ(measured.receptance.at(1), std::complex<double>(2e-8));
  EXPECT_FALSE(measured.hasPhase);
}

TEST(ReceptanceResidual, AWrongUnitIsDoubted) {
  const TemporaryFolder folder;
  const auto wrong = measuredReceptance(folder.path(), "frequency [Hz],magnitude [m/N]", 1e-6, 1);
  EXPECT_THAT(unitDoubt(wrong, computed()), HasSubstr("1.0e+06 times"));
  EXPECT_EQ(unitDoubt(measuredReceptance(folder.path(), "frequency [Hz],magnitude [m/N]", 1, 3), computed()), "");
  try {
    measuredReceptance(folder.path(), "frequency [Hz],magnitude [N/m]", 1, 1);
    FAIL() << "taken";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'N/m', must be m/N"));
  }
}

}  // namespace
}  // namespace squat::calibration
