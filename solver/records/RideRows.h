// solver/records/RideRows.h - the rows of one ride that a logger has split into several files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "records/RowSource.h"

namespace squat::records {

// Reads the next file where it begins when, or where, the one before ended. Times that start again at the
// first file's are carried on. Lines are counted through all files. Errors as records::openRide says.
class RideRows : public RowSource {
 public:
  RideRows(std::vector<std::string> files, const readers::SignalFileOptions& options, Together together);

  const text::DelimitedTable& head() const override { return head_; }
  std::string structure() const override { return current_->structure(); }
  void choose(std::vector<std::size_t> columns) override;
  bool next(std::size_t maximum, Rows& rows) override;
  double fraction() const override;
  std::size_t rows() const override { return files_.size() == 1 ? current_->rows() : 0; }
  std::string truncation() const override;
  std::vector<std::string> files() const override;
  std::string joined() const override;

 private:
  // The last and last but one values of an axis among the chosen columns.
  struct Axis {
    std::size_t at = static_cast<std::size_t>(-1);  // of the chosen columns; the largest: there is none
    double scale = 1;                               // to s or m
    double first = 0, last = 0, step = 0;           // as in the file
    bool exists() const { return at != static_cast<std::size_t>(-1); }
  };
  enum class Join { none, followingTimes, followingPositions, asStated };

  bool openNext();
  Join joinOf(const text::DelimitedTable& head, double rate);
  Join joinAsStated(bool goesBack, const std::string& file) const;
  void remember(const Rows& rows);
  void carryOn(Rows& rows);

  std::vector<std::string> files_;
  readers::SignalFileOptions options_;
  Together together_;
  std::size_t at_ = 0;  // of the current file
  std::unique_ptr<RowSource> current_;
  text::DelimitedTable head_;
  std::vector<std::size_t> chosen_;
  Axis time_, position_;
  double timeShift_ = 0;  // of the current file, in its unit
  std::uint64_t lines_ = 0, lineShift_ = 0;
  Rows pending_;  // the beginning of the current file
  Join join_ = Join::none;
  std::string truncation_;  // of the files before
};

}  // namespace squat::records
