// solver/loggers/UniversalText.h - lines and fields of fixed width in universal files, whose datasets may hold bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Errors.h"

namespace squat::loggers {

// Walks through a file in memory, which must outlive it.
class UniversalCursor {
 public:
  UniversalCursor(std::string_view bytes, std::string path) : bytes_(bytes), path_(std::move(path)) {}

  bool next(std::string_view& line);  // without its line end
  std::string_view rest() const { return bytes_.substr(at_); }
  void skipBytes(std::size_t count);  // of a dataset in binary; lines are no longer counted
  // Beyond the closing line of the dataset; whether there was one. `more`: whether text stood before it.
  bool close(bool* more = nullptr);
  void openDataset() { ++dataset_; }
  std::size_t dataset() const { return dataset_; }  // the number of datasets that were opened

  FileError error(const std::string& what, const std::string& advice = "Write the file again") const;

 private:
  std::string_view bytes_;
  std::string path_;
  std::size_t at_ = 0, line_ = 0, dataset_ = 0;
  bool binary_ = false;
};

// "    -1" and nothing else: opens and closes a dataset.
bool isUniversalMark(std::string_view line);

// A field by its columns from 0; empty where the line is shorter.
std::string_view universalField(std::string_view line, std::size_t from, std::size_t width);

// Nothing for text and empty fields.
std::optional<long> universalInteger(std::string_view field);

// Fortran's notation: exponents after D, and without a letter where they have three digits. Not-a-number for "NaN" and
// stars; nothing for other text.
std::optional<double> universalNumber(std::string_view field);

// Appends the numbers of a line; `widths` repeat. Fields that are parted by blanks need not keep to the widths; others
// are cut by them. False where a field is no number.
bool universalNumbers(std::string_view line, const std::vector<std::size_t>& widths, std::vector<double>& numbers);

}  // namespace squat::loggers
