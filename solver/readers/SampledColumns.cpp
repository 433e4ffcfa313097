#include "readers/SampledColumns.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "signals/Resample.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"

namespace squat::readers {
namespace {

double medianStep(const std::vector<double>& values) {
  std::vector<double> steps(values.size() - 1);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) steps[i] = values[i + 1] - values[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

class Builder {
 public:
  Builder(SampledColumns columns, const SignalFileOptions& options) : in_(std::move(columns)), options_(options) {}

  signals::Record build() {
    out_.file = in_.file;
    out_.run = in_.run;
    out_.origin = signals::Origin::measured;
    series_.name = in_.name;
    series_.unit = in_.unit;
    trimEnd();
    if (in_.signal.size() < 2)
      fail("", "has " + std::to_string(in_.signal.size()) + " samples of '" + in_.name + "'; at least 2 are needed");
    requireUsable(in_.signal, in_.name);
    requireUsable(in_.time, "time");
    requireUsable(in_.position, "position");
    requireUsable(in_.speed, "speed");
    for (std::size_t i = 0; i < in_.speed.size(); ++i)
      if (in_.speed[i] <= 0)
        fail(in_.location(i), "the speed is " + text::roundedText(in_.speed[i]) + " m/s, not a positive number",
             "Remove standstill and reversing");
    smoothPosition();
    if (options_.rate > 0)
      rateGiven();
    else if (!in_.time.empty())
      rateFromTime();
    else if (!in_.position.empty() && (options_.speed > 0 || !in_.speed.empty()))
      rateFromPosition();
    else
      fail("", "has no time column that is known as one, so the sampling rate is not known",
           "Give the rate, name the time column, or give the speed where the positions are equally spaced");
    constexpr double fastest = 1e7;  // [Hz]: beyond it the unit of the time is wrong, and spectra outgrow the memory
    if (!(series_.step * fastest >= 1))
      fail("", "is sampled at " + text::roundedText(1 / series_.step) + " Hz",
           "Up to 1e7 Hz is read; check the unit of time");
    if (series_.values.empty()) series_.values = std::move(in_.signal);
    addPosition();
    addSignal();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& what, const std::string& advice = {}) const {
    throw FileError(in_.file, where, what, advice);
  }

  // Runs side by side in one table may differ in length: missing values at the end are no gap.
  void trimEnd() {
    std::size_t n = in_.signal.size();
    while (n > 0 && std::isnan(in_.signal[n - 1])) --n;
    if (n < in_.signal.size() && n > 0)
      out_.notes.push_back(std::to_string(in_.signal.size() - n) + " rows without a value at the end were left out");
    for (auto* column : {&in_.signal, &in_.time, &in_.position, &in_.speed})
      if (!column->empty()) column->resize(n);
  }

  void requireUsable(const std::vector<double>& values, const std::string& name) const {
    const auto bad = std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
    if (bad != values.end())
      fail(in_.location(static_cast<std::size_t>(bad - values.begin())),
           "'" + name + "' has no number here (a gap, not-a-number or text)",
           "Fill the gap, cut the file there, or choose another column");
    // Densities are squares over short times: these still stay within the range of double.
    constexpr double largest = 1e100;
    const auto huge =
        std::find_if(values.begin(), values.end(), [](double value) { return std::abs(value) > largest; });
    if (huge != values.end())
      fail(in_.location(static_cast<std::size_t>(huge - values.begin())),
           "'" + name + "' is " + text::roundedText(*huge) + " here, too large to compute with",
           "Values up to 1e100 are read; mend the sample, or check the unit");
  }

  // Turns a falling chainage round and draws straight lines through repeated values (a coarse encoder).
  void smoothPosition() {
    auto& x = in_.position;
    if (x.empty()) return;
    if (x.back() < x.front()) {
      out_.falling = true;
      for (double& value : x) value = -value;
      out_.notes.push_back("the chainage falls along the run: position is its negative");
    }
    std::size_t anchor = 0;
    bool repeated = false;
    for (std::size_t i = 1; i < x.size(); ++i) {
      if (x[i] < x[i - 1]) fail(in_.location(i), "the position goes back", "Remove standstill and reversing");
      if (x[i] == x[i - 1]) {
        repeated = true;
        continue;
      }
      const double from = x[anchor], rise = (x[i] - from) / static_cast<double>(i - anchor);
      for (std::size_t k = anchor + 1; k < i; ++k) x[k] = from + rise * static_cast<double>(k - anchor);
      anchor = i;
    }
    if (anchor == 0) fail("", "the position does not change along the run", "Choose another column as position");
    // Behind the last change go on with the rise before it.
    const double rise = (x[anchor] - x[0]) / static_cast<double>(anchor);
    for (std::size_t k = anchor + 1; k < x.size(); ++k) x[k] = x[anchor] + rise * static_cast<double>(k - anchor);
    if (repeated) out_.notes.push_back("repeated positions were spread evenly between their changes");
  }

  void rateGiven() {
    if (!std::isfinite(options_.rate)) fail("", "the sampling rate given is not a number");
    series_.step = 1 / options_.rate;
    if (in_.time.empty()) return;
    series_.start = in_.time.front();
    // The clock of the file may be coarse; jumps of more than its own resolution and a step are gaps.
    double resolution = HUGE_VAL;
    for (std::size_t i = 1; i < in_.time.size(); ++i)
      if (in_.time[i] > in_.time[i - 1]) resolution = std::min(resolution, in_.time[i] - in_.time[i - 1]);
    for (std::size_t i = 1; i < in_.time.size(); ++i) {
      const double step = in_.time[i] - in_.time[i - 1];
      if (step < 0) fail(in_.location(i), "the time goes back by " + text::roundedText(-step) + " s");
      if (step > 1.6 * std::max(series_.step, resolution)) gap(i, step);
    }
  }

  [[noreturn]] void gap(std::size_t row, double step) const {
    fail(in_.location(row),
         "a gap of " + text::roundedText(step * 1000) + " ms before this sample, where the step is " +
             text::roundedText(series_.step * 1000) + " ms",
         "Cut the file at the gap, or leave the time column out by giving the rate and naming no time column");
  }

  void rateFromTime() {
    const auto& t = in_.time;
    for (std::size_t i = 1; i < t.size(); ++i)
      if (!(t[i] > t[i - 1]))
        fail(in_.location(i), t[i] == t[i - 1] ? "the time does not advance" : "the time goes back",
             "Where the time is written with too few digits, give the sampling rate");
    series_.step = medianStep(t);
    for (std::size_t i = 1; i < t.size(); ++i) {
      const double step = t[i] - t[i - 1];
      if (std::abs(step - series_.step) <= 0.5 * series_.step) continue;
      if (step > series_.step) gap(i, step);
      fail(in_.location(i),
           "the time step is " + text::roundedText(step * 1000) + " ms here, elsewhere " +
               text::roundedText(series_.step * 1000) + " ms",
           "Samples must be equally spaced");
    }
    series_.start = t.front();
    const double mean = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
    if (t.size() < 8 || isEven(mean))
      series_.step = mean;
    else
      putOnEqualSteps(std::min(series_.step, mean));
  }

  // Whether the times are those of equal steps, but for the digits that they are written with and a little jitter.
  bool isEven(double mean) const {
    const auto& t = in_.time;
    constexpr double jitter = 0.05;  // of a step: a sine at a quarter of the rate is off by a twelfth of its size
    double farthest = 0;
    for (std::size_t i = 0; i < t.size(); ++i)
      farthest = std::max(farthest, std::abs(t[i] - t.front() - mean * static_cast<double>(i)));
    return farthest <= std::max(jitter * mean, 1.01 * roundingOf(t, mean));
  }

  // The last digit that times are written with, where all are whole numbers of it; 0: none within a step is.
  static double roundingOf(const std::vector<double>& t, double mean) {
    for (double unit = 1; unit > 1e-9; unit /= 10) {
      if (unit > mean) continue;
      const bool all = std::all_of(t.begin(), t.end(), [&](double time) {
        return std::abs(time / unit - std::round(time / unit)) < 1e-3 + 2.3e-16 * std::abs(time) / unit;
      });
      if (all) return unit;
    }
    return 0;
  }

  // A rate that changes, or jitters: the values at equal steps, between the samples at their stated times.
  void putOnEqualSteps(double step) {
    series_.step = step;
    const auto t = in_.time;
    std::vector<double> row(t.size());
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<double>(i);
    const auto count = static_cast<std::size_t>((t.back() - t.front()) / series_.step * (1 + 1e-12)) + 1;
    series_.values = signals::onEqualSteps(t, in_.signal, series_.start, series_.step, count);
    std::vector<double> position, speed;
    for (std::size_t i = 0; i < count; ++i) {
      const double at = signals::interpolateLinear(t, row, series_.timeAt(i));
      if (!in_.position.empty()) position.push_back(signals::interpolateLinear(row, in_.position, at));
      if (!in_.speed.empty()) speed.push_back(signals::interpolateLinear(row, in_.speed, at));
    }
    in_.position = std::move(position), in_.speed = std::move(speed);
    out_.notes.push_back("the samples are not equally spaced in time: put on equal steps of " +
                         text::roundedText(series_.step * 1000) + " ms by their stated times");
  }

  // Sampled by the way run: time is its integral over the speed; the signal is put on equal steps of time.
  void rateFromPosition() {
    const auto& x = in_.position;
    const double step = medianStep(x);
    for (std::size_t i = 1; i < x.size(); ++i)
      if (std::abs(x[i] - x[i - 1] - step) > 0.5 * step)
        fail(in_.location(i),
             "a gap: the position steps by " + text::roundedText(x[i] - x[i - 1]) + " m, elsewhere by " +
                 text::roundedText(step) + " m",
             "Give the sampling rate where the samples are equally spaced in time");
    const double meanStep = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
    if (in_.speed.empty()) {
      series_.step = meanStep / options_.speed;
      return;
    }
    std::vector<double> time(x.size(), 0.0), row(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      row[i] = static_cast<double>(i);
      if (i > 0) time[i] = time[i - 1] + (x[i] - x[i - 1]) * 2 / (in_.speed[i] + in_.speed[i - 1]);
    }
    series_.step = time.back() / static_cast<double>(x.size() - 1);
    const signals::TimeSeries byRow{0, 1, in_.signal, in_.name, in_.unit};
    const signals::Interpolator value(byRow);
    std::vector<double> position;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double at = signals::interpolateLinear(time, row, series_.timeAt(i));
      series_.values.push_back(value(at));
      position.push_back(signals::interpolateLinear(row, x, at));
    }
    position.back() = x.back();
    in_.position = std::move(position);
    out_.notes.push_back("samples equally spaced along the track were put on equal steps of time by the speed column");
  }

  void addPosition() {
    if (!in_.position.empty()) {
      out_.position = std::move(in_.position);
      out_.chainage = true;
      return;
    }
    try {
      if (!in_.speed.empty())
        out_.position = signals::passageAtSpeed(series_, in_.speed).position;
      else if (options_.speed > 0)
        out_.position = signals::passageAtSpeed(series_, options_.speed).position;
    } catch (const signals::SignalError& error) {
      fail(error.sample() ? in_.location(*error.sample()) : "", error.what());
    }
  }

  void addSignal() {
    const std::size_t n = series_.values.size();
    out_.time.resize(n);
    for (std::size_t i = 0; i < n; ++i) out_.time[i] = series_.timeAt(i);
    if (out_.position.size() == n && n > 1 && series_.step > 0)
      out_.speed = (out_.position.back() - out_.position.front()) / (static_cast<double>(n - 1) * series_.step);
    out_.signals.push_back({series_.name, series_.unit, "measured", std::move(series_.values)});
  }

  SampledColumns in_;
  const SignalFileOptions& options_;
  signals::TimeSeries series_;
  signals::Record out_;
};

}  // namespace

signals::Record toRecord(SampledColumns columns, const SignalFileOptions& options) {
  return Builder(std::move(columns), options).build();
}

}  // namespace squat::readers
