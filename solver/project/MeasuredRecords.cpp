#include "project/MeasuredRecords.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "text/Numbers.h"

namespace squat::project {
namespace {

constexpr double alignmentCutoff = 2000;  // [Hz] peaks are compared below it
constexpr double kept = 5;                // [m] on both sides of the impact: records may be kilometres long

// Index of the largest absolute value; 0 for an empty list.
std::size_t largest(const std::vector<double>& values) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i]) > std::abs(values[at])) at = i;
  return at;
}

// Times link to positions by `speed` where the file gives none.
void givePositions(signals::Record& record, double speed) {
  if (!record.position.empty()) return;
  record.speed = speed;
  record.position = signals::passageAtSpeed(signals::seriesOf(record), speed).position;  // as the reader would
}

void multiply(std::vector<double>& values, double gain) {
  for (double& value : values) value *= gain;
}

constexpr double largestMove = 0.15;  // [m] several waves: the largest value may be that of any of the first few

// The part of a signal within `reach` of a place [m], with positions that count from there.
signals::Passage partAround(const signals::Record& record, double place, double reach) {
  const auto& x = record.position;
  const auto first = std::lower_bound(x.begin(), x.end(), place - reach) - x.begin();
  const auto last = std::upper_bound(x.begin(), x.end(), place + reach) - x.begin();
  auto passage = signals::passageOf(record, signals::names::axleBoxFiltered);
  auto& values = passage.series.values;
  passage.series.start = passage.series.timeAt(static_cast<std::size_t>(first));
  values.erase(values.begin() + last, values.end()), values.erase(values.begin(), values.begin() + first);
  passage.position.assign(x.begin() + first, x.begin() + last);
  for (double& position : passage.position) position -= place;
  return passage;
}

std::string noteOf(const Match& match) {
  constexpr const char* byLargest = ": the largest values lie at the same place";
  if (!match.correlation) return std::string("cannot be compared with the run") + byLargest;
  const auto correlation = text::roundedText(*match.correlation);
  if (!match.isAlike()) return "unlike the run (correlation " + correlation + ")" + byLargest;
  return "aligned with the run by cross-correlation (" + correlation + "), " +
         text::roundedText(std::abs(1e3 * match.shift)) + " mm from where the largest values would meet";
}

// With positions, gain and filtered partner.
signals::Record prepared(signals::Record record, const std::string& path, double speed, double gain) {
  auto& raw = record.signals.front();
  if (!raw.unit.empty() && raw.unit != "m/s2")
    throw FileError(path, raw.name, "is in " + raw.unit + ", not an acceleration", "overlay a signal in m/s2 or g");
  givePositions(record, speed);
  multiply(raw.values, gain);
  signals::Channel filtered{signals::names::axleBoxFiltered, "m/s2", "measured, low-passed", raw.values};
  raw = {signals::names::axleBox, "m/s2", "measured", std::move(raw.values)};
  if (record.time.size() > 1)
    filtered.values = signals::filteredPartner(signals::seriesOf(record), alignmentCutoff).values;
  record.signals.push_back(std::move(filtered));
  return record;
}

// Its largest value at `impact`.
RecordPointer laid(signals::Record record, double impact) {
  const double shift = impact - record.position[largest(record.signals[1].values)];
  for (double& position : record.position) position += shift;
  // Positions rise: what lies near the impact is one stretch.
  const auto& x = record.position;
  const auto first = std::lower_bound(x.begin(), x.end(), impact - kept) - x.begin();
  const auto last = std::upper_bound(x.begin(), x.end(), impact + kept) - x.begin();
  for (auto* values : {&record.time, &record.position, &record.signals[0].values, &record.signals[1].values}) {
    values->erase(values->begin() + last, values->end());
    values->erase(values->begin(), values->begin() + first);
  }
  return std::make_shared<const signals::Record>(std::move(record));
}

}  // namespace

std::string nameWithGain(const std::string& name, const MeasuredReading& reading) {
  return reading.gain == 1 ? name : name + " × " + text::roundedText(reading.gain);
}

double impactOf(const signals::Record* run) {
  const auto* values = run ? run->signal(signals::names::axleBoxFiltered) : nullptr;
  if (!values || values->empty() || values->size() != run->position.size()) return 0;
  return run->position[largest(*values)];
}

Match matchBeside(const signals::Record& run, const signals::Record& measured) {
  Match match{impactOf(&run), std::nullopt, 0};
  const auto* values = measured.signal(signals::names::axleBoxFiltered);
  const auto* own = run.signal(signals::names::axleBoxFiltered);
  if (!own || own->size() != run.position.size() || run.position.empty() || !values || values->empty()) return match;
  const double length = run.position.back() - run.position.front();
  const double place = match.impact;
  try {
    const auto reference = partAround(run, place, length);
    const auto other = partAround(measured, measured.position[largest(*values)], length + 2 * largestMove);
    signals::AlignmentOptions options{place - run.position.front(), run.position.back() - place, largestMove,
                                      signals::timeAtPosition(reference, 0)};
    const auto aligned = signals::alignInPosition({reference, other}, options);
    match.correlation = aligned.correlation[1];
    if (match.isAlike()) match.shift = aligned.impact[0] - aligned.impact[1];
  } catch (const signals::SignalError&) {
    // Constant, or too short to be compared: the largest values meet.
  }
  match.impact = place + match.shift;
  return match;
}

std::vector<MeasuredRecord> measuredRecords(const std::string& path, double speed, const MeasuredReading& reading,
                                            const signals::Record* beside) {
  auto read = readers::readSignals(path, reading.options);
  if (read.empty()) throw FileError(path, "", "contains no signal");
  std::vector<MeasuredRecord> records;
  for (auto& record : read) {
    MeasuredReading used = reading;
    if (record.position.empty()) {
      used.options.speed = speed;
      record.notes.push_back("no speed in file; using the case's speed (" + text::roundedText(speed) + " m/s)");
    }
    record = prepared(std::move(record), path, speed, reading.gain);
    if (beside) {
      const Match match = matchBeside(*beside, record);
      used.impact = match.impact;
      record.notes.insert(match.isAlike() ? record.notes.end() : record.notes.begin(), noteOf(match));
    }
    records.push_back({laid(std::move(record), used.impact), used});
  }
  return records;
}

MeasuredRecord realigned(const MeasuredRecord& measured, const MeasuredReading& reading,
                         const signals::Record* beside) {
  const auto& record = *measured.record;
  for (auto& each : measuredRecords(record.file, reading.options.speed, reading, beside))
    if (each.record->run == record.run) return std::move(each);
  throw FileError(record.file, record.run, "is no longer in the file", "Open the file again");
}

RecordPointer moved(const signals::Record& record, double metres) {
  auto copy = std::make_shared<signals::Record>(record);
  for (double& position : copy->position) position += metres;
  return copy;
}

signals::Record wholeRecord(const MeasuredRecord& measured) {
  const auto& [record, reading] = measured;
  for (auto& each : readers::readSignals(record->file, reading.options))
    if (each.run == record->run) {
      for (auto& channel : each.signals) multiply(channel.values, reading.gain);
      return std::move(each);
    }
  throw FileError(record->file, record->run, "is no longer in the file", "Open the file again");
}

}  // namespace squat::project
