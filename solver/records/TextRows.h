// solver/records/TextRows.h - delimited text as rows, through one buffer of a few megabytes.
#pragma once

#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "readers/SignalFile.h"
#include "records/RowSource.h"
#include "text/TableLayout.h"

namespace squat::records {

// The dialects of readers::readSignals. A row with another number of fields than the table is a row without numbers; a
// last line that is cut off is left out. Throws FileError for a file without a table and for lines above 1 MB.
class TextRows : public RowSource {
 public:
  TextRows(std::string path, const readers::SignalFileOptions& options);

  const text::DelimitedTable& head() const override { return head_; }
  std::string structure() const override;
  void choose(std::vector<std::size_t> columns) override;
  bool next(std::size_t maximum, Rows& rows) override;
  double fraction() const override;
  std::string truncation() const override { return truncation_; }
  std::vector<std::string> files() const override { return {path_}; }

 private:
  bool fill();      // more whole lines behind `at_`; false: there are none
  bool quickRow();  // values_ of the line at `at_`, where it holds plain numbers alone
  bool quickMetres(const char*& at, double& value) const;
  bool slowRow(std::string& mistake);  // any other line; false: it is no row
  void readHead();

  std::string path_;
  std::unique_ptr<std::istream> file_;  // what it holds: of a packed one, the text
  std::size_t fileBytes_ = 0, readBytes_ = 0;
  std::vector<char> buffer_;
  const char* at_ = nullptr;     // what is not read yet
  const char* whole_ = nullptr;  // end of the last whole line in the buffer
  const char* end_ = nullptr;    // of what is in the buffer
  bool open_ = false;            // the last line of the file has no line end
  std::uint64_t line_ = 0;       // of the row before `at_`
  text::TableLayout layout_;
  text::DelimitedTable head_;
  std::vector<std::size_t> chosen_;
  std::vector<char> wanted_;
  std::vector<double> values_;  // of one row, all columns
  std::vector<std::string_view> fields_;
  std::string truncation_;
};

}  // namespace squat::records
