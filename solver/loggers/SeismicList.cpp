#include "loggers/SeismicList.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/Lines.h"
#include "text/Moments.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::loggers {
namespace {

constexpr std::size_t largestSeismicList = std::size_t{4} << 30;

struct SeismicStretch {
  std::string channel, unit, location;
  double rate = 0, start = 0;  // [Hz], [s]
  std::size_t samples = 0;     // as the heading says
  std::vector<double> values;
};

SeismicStretch seismicHeading(std::string_view line, const std::string& path, const std::string& location) {
  const auto parts = text::split(std::string(line), ',');
  const auto numberOf = [&](const std::string& part) {
    return text::numberIn(part.substr(0, part.find(' ')), '.').value_or(0);
  };
  SeismicStretch stretch;
  stretch.location = location;
  if (parts.size() >= 5) {
    stretch.channel = text::split(parts[0], ' ').back();
    stretch.samples = static_cast<std::size_t>(std::clamp(numberOf(parts[1]), 0.0, 1e12));
    stretch.rate = numberOf(parts[2]);
    if (const auto start = text::momentIn(parts[3])) stretch.start = start->seconds;
    if (parts.size() >= 7) stretch.unit = parts[6];
  }
  if (!(stretch.rate > 0) || parts.size() < 5 || parts[4] != "SLIST")
    throw FileError(path, location, "is no heading of a list of samples",
                    "Such as: TIMESERIES NAME, 1000 samples, 5000.0 sps, 2026-11-27T09:30:00, SLIST, FLOAT, m/s2");
  return stretch;
}

void addSeismicLine(std::string_view line, const std::string& path, const std::string& location,
                    std::vector<double>& values) {
  std::vector<std::string_view> fields;
  text::splitFields(line, ' ', fields);
  for (const auto field : fields) {
    const auto number = text::numberIn(field, '.');
    if (!number) throw FileError(path, location, text::shown(field) + " is not a number", "Correct the line");
    values.push_back(*number);
  }
}

std::vector<SeismicStretch> seismicStretches(std::string_view bytes, const std::string& path) {
  std::vector<SeismicStretch> stretches;
  text::Lines lines(bytes, path, "Export the samples as text");
  std::string_view line;
  while (lines.nextRow(line)) {
    if (line.starts_with("TIMESERIES"))
      stretches.push_back(seismicHeading(line, path, lines.location()));
    else if (stretches.empty())
      throw FileError(path, lines.location(), "stands before the first heading");
    else
      addSeismicLine(line, path, lines.location(), stretches.back().values);
  }
  return stretches;
}

// Later stretches of a channel that begin a step behind the one before belong to it.
void joinSeismicStretches(std::vector<SeismicStretch>& stretches) {
  std::vector<SeismicStretch> joined;
  for (auto& stretch : stretches) {
    const auto before =
        std::find_if(joined.begin(), joined.end(), [&](const auto& one) { return one.channel == stretch.channel; });
    if (before == joined.end() || before->rate != stretch.rate ||
        std::abs(before->start + static_cast<double>(before->values.size()) / before->rate - stretch.start) >
            0.5 / stretch.rate) {
      joined.push_back(std::move(stretch));
      continue;
    }
    before->samples += stretch.samples;
    before->values.insert(before->values.end(), stretch.values.begin(), stretch.values.end());
  }
  stretches = std::move(joined);
}

}  // namespace

bool isSeismicList(std::string_view head) {
  const auto line = head.substr(0, head.find('\n'));
  return line.starts_with("TIMESERIES ") && line.find("SLIST") != std::string_view::npos;
}

LoggerTable parseSeismicList(std::string_view bytes, const std::string& path) {
  auto stretches = seismicStretches(bytes, path);
  joinSeismicStretches(stretches);
  if (stretches.empty()) throw FileError(path, "", "holds no samples");
  LoggerTable result;
  const std::size_t samples = stretches.front().values.size();
  result.rate = stretches.front().rate;
  result.table.path = path, result.table.rowWord = "sample";
  std::size_t left = 0;
  for (auto& stretch : stretches) {
    if (stretch.values.size() != stretch.samples)
      throw FileError(path, stretch.location,
                      "says " + std::to_string(stretch.samples) + " samples, but " +
                          std::to_string(stretch.values.size()) + " follow",
                      "Copy the file again from where it was recorded");
    if (stretch.values.size() != samples || stretch.rate != result.rate) {
      ++left;
      continue;
    }
    auto& column = result.table.columns.emplace_back();
    column.name = stretch.channel, column.unit = stretch.unit, column.values = std::move(stretch.values);
  }
  if (left > 0)
    result.notes.push_back(std::to_string(left) + " stretches of another length or rate than the first are left out");
  for (std::size_t i = 0; i < samples; ++i) result.table.lines.push_back(static_cast<std::uint32_t>(i + 1));
  return result;
}

LoggerTable readSeismicList(const std::string& path) {
  return parseSeismicList(readWholeFile(path, largestSeismicList), path);
}

}  // namespace squat::loggers
