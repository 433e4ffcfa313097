#include <memory>

#include "core/Errors.h"
#include "loggers/LoggerFile.h"
#include "readers/ArrayFile.h"
#include "records/ArrayRows.h"
#include "records/LoggerRows.h"
#include "records/RecordReader.h"
#include "records/RecordStream.h"
#include "records/RideRows.h"
#include "records/SignalFaults.h"
#include "records/TextRows.h"

namespace squat::records {

std::unique_ptr<RowSource> openRows(const std::string& path, const readers::SignalFileOptions& options) {
  if (readers::isArrayFile(path)) return std::make_unique<ArrayRows>(path, options);
  if (loggers::isLoggerFile(path)) return std::make_unique<LoggerRows>(path, options);
  return std::make_unique<TextRows>(path, options);
}

std::unique_ptr<RecordStream> openRecord(const std::string& path, const RecordOptions& options) {
  return openRide({path}, options, Together::passes);
}

std::unique_ptr<RecordStream> openRide(std::vector<std::string> files, const RecordOptions& options,
                                       Together together) {
  readers::requireOptions(options.columns);
  const auto path = files.front();
  auto rows = files.size() == 1 || together == Together::passes
                  ? openRows(path, options.columns)
                  : std::make_unique<RideRows>(std::move(files), options.columns, together);
  return std::make_unique<CheckedRecord>(std::make_unique<RecordReader>(path, std::move(rows), options));
}

}  // namespace squat::records
