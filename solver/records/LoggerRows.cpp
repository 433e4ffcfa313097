#include "records/LoggerRows.h"

#include <algorithm>
#include <utility>

#include "loggers/LoggerFile.h"

namespace squat::records {

LoggerRows::LoggerRows(std::string path, const readers::SignalFileOptions& options)
    : path_(std::move(path)), logger_(loggers::readLoggerFile(path_, options.object)) {
  rate = logger_.rate, notes = logger_.notes;
  head_.path = path_, head_.rowWord = logger_.table.rowWord;
  for (const auto& column : logger_.table.columns) {
    auto& own = head_.columns.emplace_back();
    own.name = column.name, own.unit = column.unit, own.moments = column.moments;
    const auto count = std::min(column.values.size(), headRows);
    own.values.assign(column.values.begin(), column.values.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

std::string LoggerRows::structure() const {
  return "file of a measuring program, " + std::to_string(rows()) + " rows" +
         (rate > 0 ? ", sampled at its stated rate" : "");
}

bool LoggerRows::next(std::size_t maximum, Rows& rows) {
  const std::size_t end = std::min(read_ + maximum, this->rows());
  rows.columns.resize(chosen_.size());
  rows.lines.clear();
  rows.mistakes.clear();
  for (std::size_t c = 0; c < chosen_.size(); ++c) {
    const auto& values = logger_.table.columns[chosen_[c]].values;
    rows.columns[c].assign(values.begin() + static_cast<std::ptrdiff_t>(read_),
                           values.begin() + static_cast<std::ptrdiff_t>(end));
  }
  const bool any = end > read_;
  read_ = end;
  return any;
}

double LoggerRows::fraction() const {
  return rows() > 0 ? static_cast<double>(read_) / static_cast<double>(rows()) : 1.0;
}

}  // namespace squat::records
