// solver/records/RowSource.h - the rows of a long table, block by block, whatever the file: numbers as they stand
// there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "records/RecordStream.h"
#include "text/DelimitedTable.h"

namespace squat::records {

inline constexpr std::size_t headRows = 200;  // rows that are read to see what a file holds

struct Rows {
  std::vector<std::vector<double>> columns;  // those chosen, in that order; not-a-number where the file has no number
  std::vector<std::uint64_t> lines;          // of the rows in the file, from 1; empty where a row is its sample
  std::vector<std::pair<std::size_t, std::string>> mistakes;  // row and what is wrong in it; only the first ones

  std::size_t size() const { return columns.empty() ? 0 : columns.front().size(); }
};

class RowSource {
 public:
  virtual ~RowSource() = default;
  virtual const text::DelimitedTable& head() const = 0;       // names, units and the first rows
  virtual std::string structure() const = 0;                  // of the file, for people: what it is, how it is laid out
  virtual void choose(std::vector<std::size_t> columns) = 0;  // once, before next()
  virtual bool next(std::size_t maximum, Rows& rows) = 0;     // the following rows; false: the end
  virtual double fraction() const = 0;                        // of the file that has been read, 0..1
  virtual std::size_t rows() const { return 0; }              // in the file; 0: not known
  virtual std::string truncation() const { return {}; }       // what is cut off at the end of the file; empty: nothing
  virtual std::vector<std::string> files() const = 0;         // that have been read, or begun
  virtual std::string joined() const { return {}; }           // why several files are one ride; empty: there is one

  // What the file says beside its columns.
  double rate = 0;           // [Hz]; 0: nothing
  double speed = 0;          // [m/s]; 0: nothing
  std::string signalColumn;  // empty: nothing
  std::vector<std::string> notes;
};

// Text, HDF5 and MATLAB files, by what they hold. Throws FileError.
std::unique_ptr<RowSource> openRows(const std::string& path, const readers::SignalFileOptions& options);

}  // namespace squat::records
