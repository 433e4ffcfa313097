#include "records/Inspection.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "readers/TableRoles.h"
#include "records/ChosenColumns.h"
#include "records/RowSource.h"

namespace squat::records {
namespace {

constexpr std::size_t inspectedRows = 4;

void nameUses(Inspection& result, const text::DelimitedTable& table, const RecordOptions& options) {
  const auto chosen = chooseColumns(table, options.columns, options.everyAcceleration);
  const auto name = [&](const std::vector<ChosenColumn>& columns, const char* use) {
    for (const auto& column : columns) result.columns[column.column].use = use;
  };
  for (auto& column : result.columns) column.use = "passed over";
  name(chosen.channels, "signal");
  name(chosen.time, "time"), name(chosen.position, "position"), name(chosen.speed, "speed"), name(chosen.run, "run");
  name(chosen.latitude, "latitude"), name(chosen.longitude, "longitude");
}

// The record with its speed, or one with a speed that stands for any: what else the file says is seen all the same.
std::unique_ptr<RecordStream> openAnyway(const std::string& path, RecordOptions options, bool& knowsWay) {
  try {
    return openRecord(path, options);
  } catch (const CaseError&) {
    if (options.columns.speed > 0) throw;
    options.columns.speed = 1, knowsWay = false;
    return openRecord(path, options);
  }
}

void readThrough(Inspection& result, const RecordOptions& options, Monitor& monitor) {
  bool knowsWay = true;
  const auto stream = openAnyway(result.path, options, knowsWay);
  RecordBlock block;
  double way = 0;
  while (stream->next(block)) {
    result.read += block.size();
    for (const double speed : block.speed) way += std::max(0.0, speed) / stream->layout().rate;
    Progress progress;
    progress.phase = "reading";
    progress.fraction = stream->fraction();
    monitor.report(progress);
    if ((result.cancelled = monitor.cancelled())) break;
  }
  result.layout = stream->layout();
  result.duration = static_cast<double>(result.read) / result.layout->rate;
  if (knowsWay) result.way = way;
  result.faults = stream->faults();
  result.doubts = result.layout->notes;
  if (!knowsWay)
    result.doubts.emplace_back("neither a position nor a speed is known: searching needs --speed, or their columns");
}

}  // namespace

Inspection inspectRecord(const std::string& path, const RecordOptions& options, Monitor& monitor) {
  readers::requireOptions(options.columns);
  Inspection result;
  result.path = path;
  {
    const auto rows = openRows(path, options.columns);
    result.structure = rows->structure();
    auto table = rows->head();
    readers::setUnits(table, options.columns);
    for (const auto& column : table.columns) {
      auto& seen = result.columns.emplace_back(InspectedColumn{column.name, column.unit, "", column.values});
      seen.first.resize(std::min(seen.first.size(), inspectedRows));
    }
    auto chosen = options;
    if (!rows->signalColumn.empty()) chosen.columns.column = rows->signalColumn;
    try {
      nameUses(result, table, chosen);
    } catch (const FileError& error) {
      result.refusal = error.what();
      return result;
    }
  }
  try {
    readThrough(result, options, monitor);
  } catch (const FileError& error) {
    result.refusal = error.what();
  } catch (const CaseError& error) {
    result.refusal = error.what();
  }
  return result;
}

}  // namespace squat::records
