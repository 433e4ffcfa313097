#include "project/MeasuredRecords.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "signals/SignalCatalogue.h"
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

RecordPointer shown(signals::Record record, const std::string& path, double speed, const MeasuredReading& reading) {
  const double impact = reading.impact;
  auto& raw = record.signals.front();
  if (!raw.unit.empty() && raw.unit != "m/s2")
    throw FileError(path, raw.name, "is in " + raw.unit + ", not an acceleration", "overlay a signal in m/s2 or g");
  givePositions(record, speed);
  multiply(raw.values, reading.gain);
  signals::Channel filtered{signals::names::axleBoxFiltered, "m/s2", "measured, low-passed", raw.values};
  raw = {signals::names::axleBox, "m/s2", "measured", std::move(raw.values)};
  if (record.time.size() > 1)
    filtered.values = signals::filteredPartner(signals::seriesOf(record), alignmentCutoff).values;
  const double shift = impact - record.position[largest(filtered.values)];
  for (double& position : record.position) position += shift;
  // Positions rise: what lies near the impact is one stretch.
  const auto& x = record.position;
  const auto first = std::lower_bound(x.begin(), x.end(), impact - kept) - x.begin();
  const auto last = std::upper_bound(x.begin(), x.end(), impact + kept) - x.begin();
  record.signals.push_back(std::move(filtered));
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

std::vector<MeasuredRecord> measuredRecords(const std::string& path, double speed, const MeasuredReading& reading) {
  auto read = readers::readSignals(path, reading.options);
  if (read.empty()) throw FileError(path, "", "contains no signal");
  std::vector<MeasuredRecord> records;
  for (auto& record : read) {
    MeasuredReading used = reading;
    if (record.position.empty()) {
      used.options.speed = speed;
      record.notes.push_back("no speed in file; using the case's speed (" + text::roundedText(speed) + " m/s)");
    }
    records.push_back({shown(std::move(record), path, speed, reading), used});
  }
  return records;
}

MeasuredRecord realigned(const MeasuredRecord& measured, const MeasuredReading& reading) {
  const auto& record = *measured.record;
  for (auto& each : measuredRecords(record.file, reading.options.speed, reading))
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
