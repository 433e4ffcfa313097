#include <memory>

#include "core/Errors.h"
#include "readers/ArrayFile.h"
#include "records/ArrayRows.h"
#include "records/RecordReader.h"
#include "records/RecordStream.h"
#include "records/SignalFaults.h"
#include "records/TextRows.h"

namespace squat::records {

std::unique_ptr<RecordStream> openRecord(const std::string& path, const RecordOptions& options) {
  readers::requireOptions(options.columns);
  if (!readers::isArrayFile(path))
    return std::make_unique<CheckedRecord>(
        std::make_unique<RecordReader>(path, std::make_unique<TextRows>(path, options.columns), options));
  auto rows = std::make_unique<ArrayRows>(path, options.columns);
  auto own = options;
  own.columns.column = rows->column();
  return std::make_unique<CheckedRecord>(std::make_unique<RecordReader>(path, std::move(rows), own));
}

}  // namespace squat::records
