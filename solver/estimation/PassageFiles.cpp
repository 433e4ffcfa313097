#include "estimation/PassageFiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/Errors.h"
#include "signals/Butterworth.h"
#include "signals/Features.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"

namespace squat::estimation {

namespace {

constexpr double minimumBefore = 0.04;  // [m] of record before the impact
constexpr double minimumBehind = 0.06;  // [m] behind it
constexpr double minimumRatio = 4;      // of peak to noise: a peak of noise alone reaches three

void requireAcceleration(const signals::Record& record) {
  const auto& unit = record.signals.front().unit;
  if (unit == "m/s2") return;
  throw FileError(record.file, record.run,
                  unit.empty() ? std::string("the signal has no unit")
                               : "unit is '" + unit + "', must be an acceleration (m/s2, g)",
                  unit.empty() ? "Write the unit into the header of the column, as in \"aba [m/s2]\""
                               : "Choose the column of the axle box acceleration with --column");
}

double rms(const std::vector<double>& values, std::size_t from, std::size_t to) {
  double mean = 0, sum = 0;
  for (std::size_t i = from; i < to; ++i) mean += values[i] / static_cast<double>(to - from);
  for (std::size_t i = from; i < to; ++i) sum += (values[i] - mean) * (values[i] - mean);
  return std::sqrt(sum / static_cast<double>(to - from));
}

MeasuredPassage passageIn(const signals::Record& record, double speed, double cutoff) {
  requireAcceleration(record);
  MeasuredPassage measured;
  measured.file = record.file, measured.notes = record.notes;
  measured.name = std::filesystem::path(record.file).filename().string() + ": " + record.run;
  if (record.position.empty()) {
    measured.passage = signals::passageAtSpeed(signals::seriesOf(record), speed);
    measured.notes.push_back("holds neither speed nor position: the case's " + text::roundedText(speed) +
                             " m/s is taken");
  } else {
    measured.passage = signals::passageOf(record);
  }
  signals::requireRisingPositions(measured.passage);
  const double rate = measured.passage.series.rate();
  if (!(cutoff < 0.45 * rate))
    throw FileError(record.file, record.run,
                    "is sampled at " + text::roundedText(rate) + " Hz, too slowly for signals up to " +
                        text::roundedText(cutoff) + " Hz",
                    "Give a lower cut-off frequency with --low-pass");
  measured.passage.series = signals::lowPass(measured.passage.series, cutoff);
  findEvent(measured, cutoff);
  return measured;
}

}  // namespace

void findEvent(MeasuredPassage& measured, double cutoff) {
  const auto& values = measured.passage.series.values;
  const auto& x = measured.passage.position;
  signals::requireVarying(measured.passage.series, "an estimate");
  const auto peak = signals::largestSample(values);
  measured.impact = x[peak], measured.peak = std::abs(values[peak]);
  measured.speed = signals::speedAt(measured.passage, measured.passage.series.timeAt(peak), 0.1);
  const auto millimetres = [](double metres) { return text::roundedText(1e3 * metres) + " mm"; };
  if (x[peak] - x.front() < minimumBefore || x.back() - x[peak] < minimumBehind)
    throw FileError(measured.file, measured.name,
                    "the record is too short: it holds " + millimetres(x[peak] - x.front()) + " before and " +
                        millimetres(x.back() - x[peak]) + " behind its peak",
                    "At least " + millimetres(minimumBefore) + " before and " + millimetres(minimumBehind) +
                        " behind it are compared");
  // The event begins where a quarter of the peak is first reached; what stands a period of the cut-off before it is
  // noise, and the vibration of the track that any record has.
  const auto begin = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), x[peak] - 0.3) - x.begin());
  std::size_t onset = begin;
  while (onset < peak && std::abs(values[onset]) < 0.25 * measured.peak) ++onset;
  const auto period = static_cast<std::size_t>(1 / (cutoff * measured.passage.series.step));
  const std::size_t end = onset > period ? onset - period : 0;
  if (end < 3 * period) {  // six independent values
    measured.noise = 0.05 * measured.peak;
    measured.notes.push_back("no undisturbed stretch before the event: a noise of 5 % of the peak is assumed");
    return;
  }
  measured.noise = rms(values, 0, end);
  if (measured.peak < minimumRatio * measured.noise)
    throw FileError(measured.file, measured.name,
                    "no event stands out: the largest value is " + text::roundedText(measured.peak) +
                        " m/s2 where the record before it has a standard deviation of " +
                        text::roundedText(measured.noise) + " m/s2",
                    "Cut the record to the passage over one defect");
  measured.noise = std::max(measured.noise, 1e-3 * measured.peak);
}

std::vector<MeasuredPassage> readPassages(const std::vector<std::string>& files,
                                          const readers::SignalFileOptions& reading, double speed, double cutoff) {
  std::vector<MeasuredPassage> all;
  for (const auto& file : files)
    for (const auto& record : readers::readSignals(file, reading)) {
      try {
        all.push_back(passageIn(record, speed, cutoff));
      } catch (const signals::SignalError& error) {
        throw FileError(file, record.run, error.what());
      }
    }
  return all;
}

}  // namespace squat::estimation
