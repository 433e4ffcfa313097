#include "loggers/LabviewHeader.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/Errors.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Utf8Text.h"

namespace squat::loggers {
namespace {

constexpr std::string_view lvmHeaderEnd = "***End_of_Header***";
constexpr std::string_view lvmWriteAgain = "Write the file again from LabVIEW";

// "Separator<separator>Tab": the value behind the tag, read before the separator is known.
std::string lvmTagValue(std::string_view line, std::string_view tag) {
  if (!line.starts_with(tag) || line.size() <= tag.size() + 1) return {};
  return std::string(text::trimmed(line.substr(tag.size() + 1), "\r\n"));
}

char lvmSeparator(const std::string& value) {
  const std::string word = text::lowerCase(text::trimmed(value, " "));
  if (word.starts_with("comma") || word.starts_with(',')) return ',';
  if (word.starts_with("semicolon") || word.starts_with(';')) return ';';
  return '\t';
}

LabviewAxis lvmAxis(const std::string& value) {
  const std::string word = text::lowerCase(text::trimmed(value));
  if (word.starts_with("no")) return LabviewAxis::none;
  return word.starts_with("multi") ? LabviewAxis::multi : LabviewAxis::one;
}

using LvmRow = std::vector<std::string>;

// The values of a row of the segment's header, one per channel. With an X for each channel they stand two fields apart,
// which some writers do not do.
LvmRow lvmPerChannel(LvmRow row, std::size_t channels, std::size_t apart) {
  std::size_t used = row.size();
  while (used > 0 && row[used - 1].empty()) --used;
  const bool spread = apart == 2 && (used > channels || (used > 1 && row[1].empty()));
  LvmRow values(channels);
  for (std::size_t i = 0; i < channels; ++i)
    if (const std::size_t at = spread ? 2 * i : i; at < row.size()) values[i] = std::move(row[at]);
  return values;
}

// Numbers in headers come in the file's notation, or with a point where it is not stated.
double lvmHeaderNumber(const std::string& field, char decimal) {
  const auto value = text::numberIn(field, decimal == 0 && field.find(',') != std::string::npos ? ',' : decimal);
  return value.value_or(0);
}

std::vector<std::string> lvmNames(const std::vector<std::string_view>& fields, LabviewAxis axis) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < fields.size(); i += axis == LabviewAxis::multi ? 2 : 1)
    names.push_back(text::asUtf8(text::trimmed(fields[i])));
  return names;
}

}  // namespace

bool nextLabviewRow(text::Lines& lines, std::string_view& line) {
  bool special = false;
  while (lines.next(line)) {
    if (line.starts_with("***Start_Special***")) special = true;
    if (!special && !text::trimmed(line, " \t\r,;").empty()) return true;
    if (line.starts_with("***End_Special***")) special = false;
  }
  return false;
}

LabviewHeader labviewHeader(text::Lines& lines, const std::string& path) {
  LabviewHeader header;
  std::string_view line;
  while (nextLabviewRow(lines, line)) {
    if (line.starts_with(lvmHeaderEnd)) return header;
    if (const auto value = lvmTagValue(line, "Separator"); !value.empty()) header.separator = lvmSeparator(value);
    if (const auto value = lvmTagValue(line, "Decimal_Separator"); !value.empty())
      header.decimal = value.front() == ',' ? ',' : '.';
    if (const auto value = lvmTagValue(line, "X_Columns"); !value.empty()) header.axis = lvmAxis(value);
  }
  throw FileError(path, lines.location(), "ends before its header does (***End_of_Header***)",
                  std::string(lvmWriteAgain));
}

LabviewSegment labviewSegment(text::Lines& lines, std::string_view line, const LabviewHeader& header,
                              const std::string& path) {
  const auto wrong = [&](const std::string& what) {
    return FileError(path, lines.location(), what, std::string(lvmWriteAgain));
  };
  std::optional<std::size_t> stated;
  LvmRow units, dimensions, abscissae, starts, steps;
  std::vector<std::string_view> fields;
  bool more = true;
  for (; more && !line.starts_with(lvmHeaderEnd) && !line.starts_with("X_Value"); more = nextLabviewRow(lines, line)) {
    text::splitFields(line, header.separator, fields);
    LvmRow values;
    for (std::size_t i = 1; i < fields.size(); ++i) values.push_back(text::asUtf8(text::trimmed(fields[i])));
    const std::string_view tag = text::trimmed(fields[0]);
    if (tag == "Channels" && !values.empty()) {
      std::size_t count = 0;
      const auto read = std::from_chars(values[0].data(), values[0].data() + values[0].size(), count);
      if (read.ec != std::errc()) throw wrong("states " + text::shown(values[0]) + " channels");
      stated = count;
    }
    if (tag == "Y_Unit_Label") units = values;
    if (tag == "X_Dimension") dimensions = values;
    if (tag == "X_Unit_Label") abscissae = values;
    if (tag == "X0") starts = values;
    if (tag == "Delta_X") steps = values;
  }
  if (more && line.starts_with(lvmHeaderEnd)) more = nextLabviewRow(lines, line);
  if (!more || !line.starts_with("X_Value")) throw wrong("has no row of names, which begins with X_Value");

  text::splitFields(line, header.separator, fields);
  auto names = lvmNames(fields, header.axis);
  // The last column is that of the comments, and has that name unless it is left out.
  while (!stated && !names.empty() && (names.back().empty() || names.back() == "Comment")) names.pop_back();
  // With an X for each channel the comments stand where another X would, and none of the names is theirs.
  if (stated && names.size() < *stated)
    throw wrong("names " + std::to_string(names.size()) + " channels where " + std::to_string(*stated) + " are stated");
  if (stated) names.resize(*stated);
  constexpr std::size_t most = 10000;  // a row of them is still shorter than the longest line
  if (names.empty()) throw wrong("has no channels");
  if (names.size() > most) throw wrong("has more than 10,000 channels");

  LabviewSegment segment;
  segment.fieldsPerChannel = header.axis == LabviewAxis::multi ? 2 : 1;
  for (auto* row : {&units, &dimensions, &abscissae, &starts, &steps})
    *row = lvmPerChannel(std::move(*row), names.size(), segment.fieldsPerChannel);
  for (std::size_t i = 0; i < names.size(); ++i)
    segment.channels.push_back({names[i], units[i], dimensions[i], abscissae[i], steps[i],
                                lvmHeaderNumber(starts[i], header.decimal), lvmHeaderNumber(steps[i], header.decimal)});
  return segment;
}

}  // namespace squat::loggers
