// solver/records/LoggerRows.h - the file of a measuring program as rows; it is held in memory.
#pragma once

#include <string>
#include <vector>

#include "loggers/LoggerTable.h"
#include "records/RowSource.h"

namespace squat::records {

class LoggerRows : public RowSource {
 public:
  LoggerRows(std::string path, const readers::SignalFileOptions& options);

  const text::DelimitedTable& head() const override { return head_; }
  std::string structure() const override;
  void choose(std::vector<std::size_t> columns) override { chosen_ = std::move(columns); }
  bool next(std::size_t maximum, Rows& rows) override;
  double fraction() const override;
  std::size_t rows() const override { return logger_.table.rows(); }
  std::vector<std::string> files() const override { return {path_}; }

 private:
  std::string path_;
  loggers::LoggerTable logger_;
  text::DelimitedTable head_;
  std::vector<std::size_t> chosen_;
  std::size_t read_ = 0;
};

}  // namespace squat::records
