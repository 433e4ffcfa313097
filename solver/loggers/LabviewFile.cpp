#include "loggers/LabviewFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "loggers/LabviewHeader.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::loggers {
namespace {

constexpr double lvmMissing = std::numeric_limits<double>::quiet_NaN();

struct LvmTable {
  std::vector<LabviewChannel> channels;
  std::vector<std::vector<double>> axes;  // X: none, one, or one for each channel
  std::vector<text::TableColumn> columns;
  struct Start {
    std::size_t row;
    std::vector<double> x0;  // of each channel
  };
  std::vector<Start> starts;  // of the segments that were joined
  std::size_t rows = 0;
};

bool lvmSameChannels(const std::vector<LabviewChannel>& a, const std::vector<LabviewChannel>& b, LabviewAxis axis) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& one, const auto& other) {
    return one.name == other.name && one.unit == other.unit && (axis != LabviewAxis::none || one.step == other.step);
  });
}

LvmTable::Start lvmStart(std::size_t row, const std::vector<LabviewChannel>& channels) {
  LvmTable::Start start{row, {}};
  for (const auto& channel : channels) start.x0.push_back(channel.x0);
  return start;
}

void lvmAddRow(LvmTable& table, const std::vector<std::string_view>& fields, const LabviewHeader& header) {
  const auto number = [&](std::size_t at) -> std::optional<double> {
    return at < fields.size() ? text::numberIn(fields[at], header.decimal) : std::nullopt;
  };
  const std::size_t apart = header.axis == LabviewAxis::multi ? 2 : 1;
  for (std::size_t i = 0; i < table.axes.size(); ++i) table.axes[i].push_back(number(apart * i).value_or(lvmMissing));
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    auto& column = table.columns[i];
    const std::size_t at = apart * i + 1;
    const auto value = number(at);
    if (!value && column.badText.empty() && at < fields.size() && !text::isMissing(fields[at])) {
      column.badRow = table.rows;
      column.badText = text::shown(text::trimmed(fields[at]));
    }
    column.values.push_back(value.value_or(lvmMissing));
  }
  ++table.rows;
}

// Before LabVIEW 8.6 the decimal separator is not stated: a comma in a field of the first row is one.
char lvmDecimalOf(const std::vector<std::string_view>& fields, std::size_t used) {
  for (std::size_t i = 0; i < std::min(fields.size(), used); ++i)
    if (text::numberIn(fields[i], ',') && !text::numberIn(fields[i], '.')) return ',';
  return '.';
}

// A row begins with a number or nothing, a header with a word.
bool lvmBeginsHeader(std::string_view line) {
  const char first = line.front();
  return (first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z') || first == '*';
}

LvmTable lvmRead(std::string_view bytes, const std::string& path, LabviewHeader& header,
                 std::vector<std::string>& notes) {
  text::Lines lines(bytes, path, "Name a LabVIEW measurement file");
  header = labviewHeader(lines, path);
  LvmTable table;
  std::string_view line;
  std::vector<std::string_view> fields;
  bool skipped = false;  // the segment has other channels
  std::size_t segments = 0, left = 0;
  while (nextLabviewRow(lines, line)) {
    // "nan" is a value, though a word.
    if (lvmBeginsHeader(line) && !text::isMissing(line.substr(0, line.find(header.separator)))) {
      const auto segment = labviewSegment(lines, line, header, path);
      if (++segments == 1) {
        table.channels = segment.channels;
        table.columns.resize(segment.channels.size());
        table.axes.resize(header.axis == LabviewAxis::none  ? 0
                          : header.axis == LabviewAxis::one ? 1
                                                            : segment.channels.size());
      }
      skipped = !lvmSameChannels(table.channels, segment.channels, header.axis);
      if (skipped)
        ++left;
      else
        table.starts.push_back(lvmStart(table.rows, segment.channels));
      continue;
    }
    if (segments == 0)
      throw FileError(path, lines.location(), "is no row of the header", "Write the file again from LabVIEW");
    if (skipped) continue;
    text::splitFields(line, header.separator, fields);
    const std::size_t used = (header.axis == LabviewAxis::multi ? 2 : 1) * table.columns.size() +
                             (header.axis == LabviewAxis::multi ? 0 : 1);
    if (header.decimal == 0) header.decimal = lvmDecimalOf(fields, used);
    if (fields.size() < used && line.data() + line.size() == bytes.data() + bytes.size()) {
      notes.push_back("the last row is cut short: left out");
      break;
    }
    lvmAddRow(table, fields, header);
    // Short rows must not make a table that is much larger than its file.
    if (table.rows * table.columns.size() > bytes.size())
      throw FileError(path, lines.location(), "has fewer fields than there are channels",
                      "Write the file again from LabVIEW");
  }
  if (table.rows == 0) throw FileError(path, lines.location(), "has no rows of numbers", "Name another file");
  if (left > 0)
    notes.push_back(std::to_string(left) + " of " + std::to_string(segments) +
                    " segments have other channels or another Delta_X: left out");
  return table;
}

void lvmNoteGaps(const LvmTable& table, std::vector<std::string>& notes) {
  std::size_t gaps = 0;
  for (std::size_t i = 1; i < table.starts.size(); ++i) {
    const auto &before = table.starts[i - 1], &here = table.starts[i];
    const double step = table.channels[0].step;
    if (std::abs(before.x0[0] + static_cast<double>(here.row - before.row) * step - here.x0[0]) > 0.5 * step) ++gaps;
  }
  if (gaps > 0)
    notes.push_back(std::to_string(gaps) + " of " + std::to_string(table.starts.size()) +
                    " segments do not follow on in X: joined without a gap");
}

// Earlier versions write Delta_X with six decimals as well: 51.2 kHz as 0.000020, which is 50 kHz.
void lvmNoteDigits(const LabviewChannel& channel, std::vector<std::string>& notes) {
  const std::size_t point = channel.stepText.find_first_of(".,");
  if (point == std::string::npos || channel.stepText.find_first_of("eE") != std::string::npos) return;
  constexpr std::size_t decimals = 6;
  const double percent = 100 * 0.5e-6 / channel.step;
  if (channel.stepText.size() - point - 1 == decimals && percent > 0.1)
    notes.push_back("Delta_X is written as " + channel.stepText + ": the sampling rate may be off by " +
                    text::roundedText(percent) + " %");
}

// X as it was before LabVIEW rounded it to six decimals: at 51.2 kHz these are steps of 19 and 20 us.
void lvmUndoRounding(std::vector<double>& axis, std::size_t channel, const LvmTable& table) {
  constexpr double rounding = 0.6e-6;
  const double step = table.channels[channel].step;
  std::vector<double> exact(axis.size());
  for (std::size_t s = 0; s < table.starts.size(); ++s) {
    const auto& from = table.starts[s];
    const std::size_t end = s + 1 < table.starts.size() ? table.starts[s + 1].row : axis.size();
    for (std::size_t row = from.row; row < end; ++row) {
      exact[row] = from.x0[channel] + static_cast<double>(row - from.row) * step;
      if (!(std::abs(exact[row] - axis[row]) < rounding)) return;
    }
  }
  if (step > 0) axis = std::move(exact);
}

bool lvmIsTime(const LabviewChannel& channel) {
  return channel.dimension.empty() || text::lowerCase(channel.dimension) == "time";
}

text::TableColumn lvmAxisColumn(std::vector<double> values, const LabviewChannel& channel) {
  text::TableColumn column;
  column.name = lvmIsTime(channel) ? "time" : "X_Value";
  column.unit = channel.abscissa;
  if (lvmIsTime(channel)) {
    const auto* unit = text::findUnit(text::bareUnit(channel.abscissa));
    if (!unit || unit->si != "s") column.unit = "s";
  }
  column.values = std::move(values);
  return column;
}

// Rows that X has: in longer ones of other channels it is empty.
std::size_t lvmLength(const std::vector<double>& axis) {
  std::size_t length = axis.size();
  while (length > 0 && std::isnan(axis[length - 1])) --length;
  return length;
}

bool lvmSameAxis(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double one, double other) { return one == other || (std::isnan(one) && std::isnan(other)); });
}

// The channels that are kept: with one X or none, those of the step that most have; else those of the longest X.
std::vector<std::size_t> lvmKept(const LvmTable& table, LabviewAxis axis) {
  std::vector<std::size_t> kept(table.channels.size());
  std::iota(kept.begin(), kept.end(), 0);
  if (axis == LabviewAxis::one) return kept;
  std::size_t best = 0;
  if (axis == LabviewAxis::none) {
    std::map<double, std::size_t> counts;
    for (const auto& channel : table.channels) ++counts[channel.step];
    for (std::size_t i = 1; i < kept.size(); ++i)
      if (counts[table.channels[i].step] > counts[table.channels[best].step]) best = i;
    std::erase_if(kept, [&](std::size_t i) { return table.channels[i].step != table.channels[best].step; });
  } else {
    for (std::size_t i = 1; i < kept.size(); ++i)
      if (lvmLength(table.axes[i]) > lvmLength(table.axes[best])) best = i;
    std::erase_if(kept, [&](std::size_t i) { return !lvmSameAxis(table.axes[i], table.axes[best]); });
  }
  return kept;
}

}  // namespace

bool isLabviewFile(std::string_view head) {
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  return head.starts_with("LabVIEW Measurement");
}

LoggerTable parseLabviewFile(std::string_view bytes, const std::string& path) {
  if (!isLabviewFile(bytes))
    throw FileError(path, "", "is not a LabVIEW measurement file", "Its first words must be LabVIEW Measurement");
  LoggerTable result;
  LabviewHeader header;
  LvmTable table = lvmRead(bytes, path, header, result.notes);
  const auto kept = lvmKept(table, header.axis);
  const auto& first = table.channels[kept[0]];
  std::size_t rows = table.rows;
  auto& columns = result.table.columns;
  if (header.axis != LabviewAxis::none) {
    auto axis = std::move(table.axes[header.axis == LabviewAxis::one ? 0 : kept[0]]);
    lvmUndoRounding(axis, kept[0], table);
    if (header.axis == LabviewAxis::multi) rows = lvmLength(axis);
    if (rows == 0) throw FileError(path, "column X_Value", "contains no numbers", "Name another file");
    axis.resize(rows);
    columns.push_back(lvmAxisColumn(std::move(axis), first));
  } else {
    lvmNoteGaps(table, result.notes);
    if (!(first.step > 0) || !std::isfinite(1 / first.step)) {
      result.notes.emplace_back("the file states no Delta_X: give the sampling rate");
    } else if (lvmIsTime(first)) {
      result.rate = 1 / first.step;
      lvmNoteDigits(first, result.notes);
    } else {
      std::vector<double> axis(rows);
      for (std::size_t i = 0; i < rows; ++i) axis[i] = first.x0 + static_cast<double>(i) * first.step;
      columns.push_back(lvmAxisColumn(std::move(axis), first));
    }
  }
  for (const std::size_t i : kept) {
    auto& column = columns.emplace_back(std::move(table.columns[i]));
    column.name = table.channels[i].name;
    column.unit = table.channels[i].unit;
    column.values.resize(rows);
  }
  if (const std::size_t out = table.channels.size() - kept.size(); out > 0)
    result.notes.push_back(std::to_string(out) + (out == 1 ? " channel has" : " channels have") +
                           (header.axis == LabviewAxis::none ? " another Delta_X" : " another X") + ": left out");
  result.table.path = path;
  result.table.rowWord = "sample";
  result.table.lines.resize(rows);
  std::iota(result.table.lines.begin(), result.table.lines.end(), 1U);
  return result;
}

LoggerTable readLabviewFile(const std::string& path) {
  return parseLabviewFile(readWholeFile(path, std::size_t{4} << 30), path);
}

}  // namespace squat::loggers
