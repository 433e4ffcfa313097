#include "studio/runs/MeasuredLook.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "core/Errors.h"
#include "signals/SignalCatalogue.h"
#include "text/Numbers.h"

namespace squat::studio {
namespace {

constexpr std::size_t maximumCurves = 8;
constexpr std::size_t stretchesOfACurve = 600;  // about one a pixel

// ", run 2" of "left box, run 2".
std::string numberOf(const std::string& run) {
  const std::size_t at = run.rfind(", run ");
  return at == std::string::npos ? std::string() : run.substr(at);
}

// The one that takes the place of the record `run`, whose column may have had another name.
project::MeasuredRecord sameRun(std::vector<project::MeasuredRecord> records, const MeasuredChoice& choice) {
  if (records.size() == 1) return std::move(records.front());
  const std::string number = numberOf(choice.run);
  for (auto& each : records)
    if (!number.empty() && each.record->run.ends_with(number)) return std::move(each);
  throw FileError(choice.path, "", "has " + std::to_string(records.size()) + " runs with these columns",
                  "Overlay the file again to see all of them");
}

std::vector<project::MeasuredRecord> recordsOf(const MeasuredChoice& choice) {
  const double gain = choice.reading.gain;
  if (gain < project::minimumGain || gain > project::maximumGain)
    throw FileError(choice.path, "",
                    "would have a gain of " + text::roundedText(gain) + ", that of the alignment and the unit together",
                    "Values from 0.001 to 1000 are taken: choose another unit, or change the gain first");
  const double own = choice.reading.options.speed;
  auto records =
      project::measuredRecords(choice.path, own > 0 ? own : choice.speed, choice.reading, choice.beside.get());
  if (choice.run.empty()) return records;
  std::vector<project::MeasuredRecord> one;
  one.push_back(sameRun(std::move(records), choice));
  return one;
}

}  // namespace

PreviewCurve thinned(const std::vector<double>& position, const std::vector<double>& value, std::size_t stretches) {
  PreviewCurve curve;
  const std::size_t n = std::min(position.size(), value.size());
  const std::size_t length = std::max<std::size_t>(1, (n + stretches - 1) / stretches);
  const auto add = [&](std::size_t at) {
    curve.position.push_back(position[at]);
    curve.value.push_back(value[at]);
  };
  for (std::size_t from = 0; from < n; from += length) {
    const auto begin = value.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = value.begin() + static_cast<std::ptrdiff_t>(std::min(from + length, n));
    const auto [least, most] = std::minmax_element(begin, end);
    const auto [first, last] = std::minmax({least - value.begin(), most - value.begin()});
    add(static_cast<std::size_t>(first));
    if (last != first) add(static_cast<std::size_t>(last));
  }
  return curve;
}

MeasuredLook lookAt(const MeasuredChoice& choice, const MeasuredHead& head) {
  MeasuredLook look;
  try {
    if (head.isArrays() && head.rows.empty()) look.rows = firstRows(head);
  } catch (const std::exception&) {
    // What is wrong comes from the reader.
  }
  try {
    look.records = recordsOf(choice);
    for (std::size_t i = 0; i < std::min(look.records.size(), maximumCurves); ++i) {
      const auto& record = *look.records[i].record;
      look.curves.push_back(thinned(record.position, *record.signal(signals::names::axleBox), stretchesOfACurve));
    }
    return look;
  } catch (const std::bad_alloc&) {
    look.problem = "There is not enough memory to read it";
  } catch (const std::exception& error) {
    look.problem = error.what();
  }
  look.records.clear();
  return look;
}

}  // namespace squat::studio
