#include "loggers/TdmsFile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "loggers/TdmsChannels.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::loggers {
namespace {

constexpr std::size_t tdmsLargestFile = std::size_t{4} << 30;     // [bytes]
constexpr std::uint64_t tdmsMostValues = std::uint64_t{1} << 30;  // in one table
constexpr std::size_t tdmsNotChosen = ~std::size_t{0};

// Counts the values of each object. A channel that is sometimes a number and sometimes not has no meaning.
TdmsContents tdmsCountedContents(std::string_view bytes, const std::string& path, std::vector<TdmsCount>& counts) {
  std::vector<bool> mixed;
  auto contents = walkTdms(bytes, path, [&](std::size_t object, const TdmsRun& run) {
    if (object >= counts.size()) {
      counts.resize(object + 1);
      mixed.resize(object + 1);
    }
    auto& count = counts[object];
    count.values += run.count;
    if (!count.type) count.type = run.type;
    if (count.type->kind != run.type->kind) mixed[object] = true;
  });
  counts.resize(contents.objects.size());
  for (std::size_t i = 0; i < mixed.size(); ++i)
    if (mixed[i]) contents.objects[i].refusal = "its values change their type";
  return contents;
}

// The first not-a-number of a column is noted there; infinity becomes one, as it would in a table of text.
void tdmsNoteBadValues(text::TableColumn& column) {
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    double& value = column.values[i];
    if (std::isfinite(value)) continue;
    if (column.badText.empty()) {
      column.badRow = i;
      column.badText = std::isnan(value) ? "not a number" : "infinity";
    }
    value = std::nan("");
  }
}

}  // namespace

bool isTdmsFile(std::string_view head) { return head.substr(0, 4) == "TDSm"; }

LoggerTable parseTdms(std::string_view bytes, const std::string& path, const std::string& object) {
  if (bytes.substr(0, 4) == "TDSh")
    throw FileError(path, "", "is the index of a TDMS file, without its values", "Name the file .tdms beside it");
  if (!isTdmsFile(bytes)) throw FileError(path, "", "is not a TDMS file", tdmsDamagedAdvice);
  std::vector<TdmsCount> counts;
  const auto contents = tdmsCountedContents(bytes, path, counts);
  auto choice = chooseTdmsChannels(contents, counts, path, object);
  const std::uint64_t rows = counts[choice.channels.front().object].values;
  if (rows > tdmsMostValues / choice.channels.size())
    throw FileError(path, "",
                    "has " + std::to_string(rows) + " values in each of " + std::to_string(choice.channels.size()) +
                        " channels, more than are read",
                    "Save it in parts");

  LoggerTable read;
  read.rate = choice.rate;
  read.table.path = path;
  read.table.rowWord = "sample";
  read.table.lines.resize(static_cast<std::size_t>(rows));
  std::iota(read.table.lines.begin(), read.table.lines.end(), 1U);
  std::vector<std::size_t> columnOf(contents.objects.size(), tdmsNotChosen);
  for (const auto& channel : choice.channels) {
    columnOf[channel.object] = read.table.columns.size();
    const auto& found = contents.objects[channel.object];
    auto& column = read.table.columns.emplace_back();
    column.name = found.channel;
    column.unit = text::trimmed(tdmsText(found.properties, "unit_string"));
    column.values.reserve(static_cast<std::size_t>(rows));
  }
  std::vector<TdmsMoment> origins(choice.channels.size());
  walkTdms(bytes, path, [&](std::size_t number, const TdmsRun& run) {
    if (columnOf[number] == tdmsNotChosen) return;
    auto& column = read.table.columns[columnOf[number]];
    if (run.type->kind == TdmsKind::number) return appendTdmsNumbers(run, column.values);
    auto& origin = origins[columnOf[number]];
    if (!column.moments) {
      column.moments = text::MomentKind::dateTime;
      column.unit = "s";
      origin = tdmsMomentAt(run.first, run.bigEndian);
      if (const auto date = tdmsMomentText(origin); !date.empty())
        choice.notes.push_back(text::shown(column.name) + " counts from " + date);
    }
    appendTdmsMoments(run, origin, column.values);
  });
  for (std::size_t i = 0; i < choice.channels.size(); ++i) {
    applyTdmsScaling(choice.channels[i].scaling, read.table.columns[i].values);
    tdmsNoteBadValues(read.table.columns[i]);
  }
  read.notes = std::move(choice.notes);
  return read;
}

LoggerTable readTdmsFile(const std::string& path, const std::string& object) {
  return parseTdms(readWholeFile(path, tdmsLargestFile), path, object);
}

}  // namespace squat::loggers
