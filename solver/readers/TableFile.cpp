#include "readers/TableFile.h"

#include "loggers/LoggerFile.h"
#include "text/DelimitedTable.h"

namespace squat::readers {

loggers::LoggerTable readTableFile(const std::string& path, const SignalFileOptions& options) {
  if (loggers::isLoggerFile(path)) return loggers::readLoggerFile(path, options.object);
  if (!loggers::isPacked(path))
    return {text::readDelimitedTable(path, options.delimiter, options.decimal, options.headLine), 0, {}};
  const auto unpacked = loggers::unpackedText(path);
  return {text::parseDelimitedTable(unpacked, path, options.delimiter, options.decimal, options.headLine), 0, {}};
}

}  // namespace squat::readers
