#include <memory>

#include "core/Errors.h"
#include "records/RecordReader.h"
#include "records/RecordStream.h"
#include "records/TextRows.h"

namespace squat::records {

std::unique_ptr<RecordStream> openRecord(const std::string& path, const RecordOptions& options) {
  readers::requireOptions(options.columns);
  return std::make_unique<RecordReader>(path, std::make_unique<TextRows>(path, options.columns), options);
}

}  // namespace squat::records
