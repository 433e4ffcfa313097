// solver/signals/Alignment.h - repeated runs over one defect: aligned on the impact, and how far they scatter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "signals/Features.h"
#include "signals/TimeSeries.h"

namespace squat::signals {

// One passage. Position runs with the wheel; where only the speed is known its zero is the first sample.
struct Passage {
  TimeSeries series;
  std::vector<double> position;  // [m] at each sample, strictly rising
};

// A passage at constant speed [m/s], or at a speed given for every sample.
Passage passageAtSpeed(TimeSeries series, double speed);
Passage passageAtSpeed(TimeSeries series, const std::vector<double>& speed);

// Throws SignalError where a passage has not one position for each sample, or one that does not rise.
void requireRisingPositions(const Passage& passage);
// [s] straight line between the samples; the end's beyond.
double timeAtPosition(const Passage& passage, double position);
// [m] straight line between the samples; the end's beyond.
double positionAtTime(const Passage& passage, double time);

// Mean speed [m/s] over the samples within `half` metres of the sample nearest to `time`.
double speedAt(const Passage& passage, double time, double half = 0.5);

struct AlignmentOptions {
  double before = 0.2, after = 0.6;  // [m] of the reference around its anchor that is compared
  double largestShift = 0;           // [s] or [m] between anchors as recorded; 0: any
  std::optional<double> anchor =
      std::nullopt;  // [s] of the first run, moved to its nearest sample; default: by anchorOf
};

// Runs on one axis with its zero at the impact of the first run.
struct AlignedRuns {
  bool inPosition = false;                  // axis in m, else in s
  std::vector<double> axis;                 // equally spaced
  std::vector<std::vector<double>> values;  // one row a run
  std::vector<std::string> names;
  std::vector<double> impact;                 // place on the run's own axis that lies at zero
  std::vector<double> correlation;            // with the first run, over the common length
  std::vector<double> speed;                  // [m/s] at the impact
  std::vector<double> mean, lowest, highest;  // over the runs: the scatter band
};

// The impact of the first run is its anchor; each other run is moved to where its cross-correlation
// with the first is largest, to a fraction of a sample (parabola through three values). In position the runs are first
// put on a common grid of positions, so runs of different speed match. Throws SignalError for fewer than two runs and
// for signals that are constant, not finite or shorter than what is compared.
AlignedRuns alignInTime(const std::vector<Passage>& runs, const AlignmentOptions& options = {});
AlignedRuns alignInPosition(const std::vector<Passage>& runs, const AlignmentOptions& options = {});

// Scatter of one number over the runs.
struct Dispersion {
  std::vector<double> values;
  double mean = 0, standardDeviation = 0;  // of the sample: n - 1
  double range = 0;                        // (maximum - minimum) / mean: the paper's dispersion
};
Dispersion dispersionOf(std::vector<double> values);

struct RunDispersion {
  Dispersion largestPeak;  // [unit] largest absolute value in the window of the spectrum
  Dispersion wavelength;   // [m] mean after the anchor by zero crossings
};
RunDispersion runDispersion(const AlignedRuns& runs, const FeatureOptions& options = {});

// Shift d [s] for which sum_t a(t) b(t + d) is largest, |d| <= largestShift; both series must have the same step.
double shiftBetween(const TimeSeries& a, const TimeSeries& b, double largestShift);

// Pearson's correlation coefficient of two equally long rows.
double correlationOf(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace squat::signals
