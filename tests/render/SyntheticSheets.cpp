#include "render/SyntheticSheets.h"

#include <cmath>
#include <complex>

#include "analysis/Analysis.h"
#include "analysis/FileComparison.h"
#include "estimation/Estimation.h"
#include "plots/AnalysisFigures.h"
#include "plots/ComparisonFigures.h"
#include "plots/EstimateFigure.h"
#include "plots/PaperFigures.h"
#include "plots/ReceptanceFigures.h"
#include "plots/StudyFigures.h"
#include "render/SyntheticResult.h"

namespace squat::tests {
namespace {

constexpr double rate = 25000;

// A kick at `impact` [s] that rings at 300 and `high` Hz; a little hum, so that nothing is constant.
signals::Record passing(const std::string& name, double impact, double speed, double size, double high) {
  signals::Record signal;
  signal.origin = signals::Origin::measured;
  signal.file = name + ".csv";
  signal.run = name;
  signal.signals = {{name, "m/s2", "", {}}};
  for (int i = 0; i < 2000; ++i) {
    const double t = i / rate, since = t - impact, late = std::max(since, 0.0);
    const double smooth = 1 / (1 + std::exp(-since / 1.5e-4));
    const double tones = 70 * std::exp(-late / 0.006) * std::sin(2 * M_PI * 300 * since) +
                         60 * std::exp(-late / 0.003) * std::sin(2 * M_PI * high * since);
    signal.time.push_back(t);
    signal.signals[0].values.push_back(size * smooth * tones + 1.5 * std::sin(2 * M_PI * 420 * t));
    signal.position.push_back(speed * t);
  }
  return signal;
}

analysis::Analysis twoRuns() {
  analysis::Analysis analysis;
  std::vector<signals::Passage> passages;
  for (const auto& signal : {passing("run 1", 0.030, 30, 1.0, 1000), passing("run 2", 0.034, 28, 1.2, 1020)}) {
    analysis.signals.push_back(analysis::analyseSignal(signal, {}));
    passages.push_back({analysis.signals.back().filtered, signal.position});
    passages.back().series.name = signal.run;
  }
  analysis.inTime = signals::alignInTime(passages);
  analysis.inPosition = signals::alignInPosition(passages);
  analysis.dispersion = signals::runDispersion(*analysis.inTime);
  return analysis;
}

analysis::FileComparison pairOf(const signals::Record& first, const signals::Record& second, bool smooth) {
  signals::ComparisonOptions options;
  options.align = !smooth;
  options.inPosition = smooth;
  return {
      first.file, second.file, signals::compare(signals::passageOf(first), signals::passageOf(second), options), {}};
}

studies::StudyTable severity() {
  auto table = studies::emptyTable(
      {"class-c-squat",
       "12345678",
       {studies::variationFromText("defect.length=20:80:4"), studies::variationFromText("defect.depth=0.05:0.3:4")}});
  for (auto& row : table.rows) {
    const double length = std::stod(row.point.values[0]), depth = std::stod(row.point.values[1]);
    row.state = studies::RowState::done;
    if (row.point.index == 5) {
      row.state = studies::RowState::failed;  // a hole in the curves
      row.message = "contact lost";
      continue;
    }
    const double peak = 1000 * depth * length / (20 + length);
    row.features = {{"peak [m/s2]", peak},
                    {"largest moving rms [m/s2]", 0.4 * peak},
                    {"wavelength by ridge [m]", 0.03 + 1e-4 * length},
                    {"power 130-320 Hz [(m/s2)2]", 0.2 * peak * peak},
                    {"power 200-400 Hz [(m/s2)2]", 0.3 * peak * peak},
                    {"power 1000-1200 Hz [(m/s2)2]", 0.01 * peak * peak},
                    {"free vibration 1000-1200 Hz [s]", 0.004},
                    {"peak 1 frequency [Hz]", 330 - length},
                    {"largest contact force [N]", 9e4 + 300 * peak}};
  }
  return table;
}

// Two masses on springs, each by itself, and three modes.
receptance::TrackReceptance oneMassTrack() {
  receptance::TrackReceptance track;
  track.points = {{{"over a sleeper", 0, 0}, {}}, {{"midspan", -0.3, -0.3}, {}}};
  for (double f = 50; f <= 2000; f += 2) track.frequency.push_back(f);
  const double natural[] = {530, 1020};  // [Hz]
  for (std::size_t p = 0; p < 2; ++p)
    for (const double f : track.frequency) {
      const double r = f / natural[p];
      track.points[p].receptance.push_back(2e-9 / std::complex<double>(1 - r * r, 0.1 * r));
    }
  track.modes = {{380, 1, 0.04, 0.02, 0.02}, {750, 1, 0.01, 0.015, 0.02}, {1960, 1, 0, 0, 0.08}};
  return track;
}

// A dip of 100 um whose bottom the wheel does not touch, and a passage that it explains but for a tenth.
estimation::Estimate dip() {
  estimation::Estimate estimate;
  for (int i = -25; i <= 25; ++i) {
    const double x = 2e-3 * i, height = std::abs(i) < 15 ? -50e-6 * (1 + std::cos(M_PI * i / 15.0)) : 0;
    estimate.profile.push_back({x, height, height - 12e-6, height + 8e-6, std::abs(i) > 4});
  }
  const auto signal = passing("run 1", 0.030, 30, 1.0, 1000);
  estimation::ExplainedPassage passage;
  passage.name = "run 1";
  for (std::size_t i = 0; i < signal.time.size(); ++i) {
    const double x = signal.position[i] - 0.9;
    if (x < -0.1 || x > 0.13) continue;
    passage.position.push_back(x);
    passage.measured.push_back(signal.signals[0].values[i]);
    passage.computed.push_back(0.9 * signal.signals[0].values[i]);
  }
  estimate.passages = {passage};
  return estimate;
}

}  // namespace

std::vector<plots::FigureSheet> syntheticSheets() {
  const auto style = plots::lightStyle();
  std::vector<plots::FigureSheet> all;
  const auto add = [&](std::vector<plots::FigureSheet> sheets) {
    for (auto& sheet : sheets) all.push_back(std::move(sheet));
  };
  add(plots::analysisFigures(twoRuns(), style));
  const auto computed = passing("computed", 0.030, 30, 1.0, 1000);
  add(plots::comparisonFigures({pairOf(computed, passing("measured", 0.033, 29, 1.2, 1020), false)}, false, style));
  add(plots::comparisonFigures({pairOf(computed, passing("smooth", 0.030, 30, 0.02, 1000), true)}, true, style));
  add(plots::studyFigures(severity(), style));
  const auto light = syntheticResult();
  auto squat = light, modified = light;
  squat.stem = "class-c-squat";
  modified.stem = "class-c-squat-modified";
  for (double& height : modified.profileHeight) height *= 1.5;
  add(plots::paperFigures({&light, &squat, &modified}, style));
  all.push_back(plots::receptanceFigures(oneMassTrack(), "track_receptance", "One mass", "12345678", style));
  all.push_back(plots::estimateFigure(dip(), style));
  return all;
}

}  // namespace squat::tests
