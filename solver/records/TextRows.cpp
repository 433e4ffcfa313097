#include "records/TextRows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/Errors.h"
#include "loggers/LoggerFile.h"
#include "records/QuickNumber.h"
#include "text/Lines.h"
#include "text/Text.h"

namespace squat::records {
namespace {

constexpr std::size_t bufferBytes = std::size_t{4} << 20;
constexpr std::size_t longestLine = std::size_t{1} << 20;
constexpr std::size_t maximumMistakes = 100;  // reported of one block
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TextRows::TextRows(std::string path, const readers::SignalFileOptions& options) : path_(std::move(path)) {
  std::error_code error;
  if (!std::filesystem::exists(path_, error)) throw FileError(path_, "", "is not there", "Check the path");
  if (!std::filesystem::is_regular_file(path_, error))
    throw FileError(path_, "", "is not a regular file", "Name a file");
  if (loggers::isPacked(path_)) {
    auto unpacked = loggers::unpackedText(path_);
    fileBytes_ = unpacked.size();
    file_ = std::make_unique<std::istringstream>(std::move(unpacked));
  } else {
    fileBytes_ = static_cast<std::size_t>(std::filesystem::file_size(path_, error));
    file_ = std::make_unique<std::ifstream>(path_, std::ios::binary);
  }
  if (error || !*file_) throw FileError(path_, "", "cannot be read", "Check its permissions");
  buffer_.resize(bufferBytes + 1);
  at_ = whole_ = end_ = buffer_.data();
  fill();
  const std::string_view text(at_, static_cast<std::size_t>(whole_ - at_));
  layout_ = text::layoutOf(text, path_, options.delimiter, options.decimal, options.headLine);
  head_ = text::emptyTable(layout_, path_);
  values_.resize(layout_.fields);
  wanted_.assign(layout_.fields, 1);
  if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
  for (; line_ < layout_.firstLine; ++line_)
    at_ = static_cast<const char*>(std::memchr(at_, '\n', static_cast<std::size_t>(whole_ - at_))) + 1;
  readHead();
}

// The first rows, and back to where they begin.
void TextRows::readHead() {
  const auto* first = at_;
  std::string ignored;
  for (std::size_t row = 0; row < headRows && at_ < whole_; ++row) {
    if (!slowRow(ignored)) continue;
    for (std::size_t c = 0; c < values_.size(); ++c) head_.columns[c].values.push_back(values_[c]);
  }
  for (auto& column : head_.columns) column.clockBefore = column.clockDays = 0;
  at_ = first;
  line_ = layout_.firstLine;
  truncation_.clear();
}

bool TextRows::fill() {
  const auto left = static_cast<std::size_t>(end_ - at_);
  std::memmove(buffer_.data(), at_, left);
  file_->read(buffer_.data() + left, static_cast<std::streamsize>(bufferBytes - left));
  const auto got = static_cast<std::size_t>(file_->gcount());
  if (file_->bad()) throw FileError(path_, "line " + std::to_string(line_ + 1), "cannot be read from here on");
  readBytes_ += got;
  at_ = buffer_.data();
  end_ = at_ + left + got;
  if (left + got < bufferBytes && end_ > at_ && end_[-1] != '\n') {  // the end of the file
    open_ = true;
    buffer_[left + got] = '\n';
    ++end_;
  }
  whole_ = end_;
  while (whole_ > at_ && whole_[-1] != '\n') --whole_;
  if (whole_ == at_ && static_cast<std::size_t>(end_ - at_) > longestLine)
    throw FileError(path_, "line " + std::to_string(line_ + 1), "is longer than 1 MB", "Put one row on each line");
  return whole_ > at_;
}

std::string TextRows::structure() const {
  const auto named = [](char sign) {
    return sign == ' ' ? std::string("blanks") : sign == '\t' ? std::string("tabs") : "'" + std::string(1, sign) + "'";
  };
  return "text, columns between " + named(layout_.delimiter) +
         (layout_.decimal == ',' ? ", decimal comma" : ", decimal point") +
         (layout_.names.empty() ? ", no heading" : "") + ", numbers from line " + std::to_string(layout_.firstLine + 1);
}

void TextRows::choose(std::vector<std::size_t> columns) {
  chosen_ = std::move(columns);
  wanted_.assign(layout_.fields, 0);
  for (const std::size_t c : chosen_) wanted_[c] = 1;
}

double TextRows::fraction() const {
  const auto left = static_cast<std::size_t>(end_ - at_);
  return fileBytes_ ? std::min(1.0, static_cast<double>(readBytes_ - std::min(left, readBytes_)) /
                                        static_cast<double>(fileBytes_))
                    : 1.0;
}

// Behind the kilometres: "+345.6".
bool TextRows::quickMetres(const char*& at, double& value) const {
  const char* p = at + 1;
  double metres = 0;
  if (!quick::isDigit(*p) || value != std::floor(value) || !quickNumber(p, end_, layout_.decimal, metres)) return false;
  value = 1000 * value + metres;
  at = p;
  return true;
}

bool TextRows::quickRow() {
  if (layout_.delimiter == layout_.decimal) return false;  // "1,5","2,5": quotes part the fields
  const char* p = at_;
  const char delimiter = layout_.delimiter;
  const auto skipBlanks = [&] {
    while (*p == ' ' || (*p == '\t' && delimiter != '\t')) ++p;
  };
  for (std::size_t c = 0; c < layout_.fields; ++c) {
    skipBlanks();
    if (wanted_[c]) {
      if (!quickNumber(p, end_, layout_.decimal, values_[c])) return false;
      if (*p == '+' && !quickMetres(p, values_[c])) return false;
    } else {
      while (*p != delimiter && *p != '\n' && *p != '\r' && !(delimiter == ' ' && *p == '\t')) {
        if (*p == '"' || (c == 0 && (*p == '#' || *p == '%'))) return false;
        ++p;
      }
    }
    const char* behind = p;
    skipBlanks();
    if (delimiter == ' ' ? p > behind : *p == delimiter) {
      if (delimiter != ' ') ++p;
    } else if (c + 1 < layout_.fields) {
      return false;
    }
  }
  skipBlanks();
  if (*p == '\r') ++p;
  if (*p != '\n') return false;
  at_ = p + 1;
  ++line_;
  return true;
}

bool TextRows::slowRow(std::string& mistake) {
  const auto* lineEnd = static_cast<const char*>(std::memchr(at_, '\n', static_cast<std::size_t>(whole_ - at_)));
  const std::string_view line(at_, static_cast<std::size_t>(lineEnd - at_));
  at_ = lineEnd + 1;
  ++line_;
  if (text::isComment(line)) return false;
  text::splitRow(line, layout_, fields_);
  if (fields_.size() == layout_.fields) {
    for (std::size_t c = 0; c < layout_.fields; ++c) {
      if (!wanted_[c]) continue;
      values_[c] = text::fieldValue(fields_[c], layout_.decimal, head_.columns[c]);
      if (mistake.empty() && std::isnan(values_[c]))
        mistake = "column " + std::to_string(c + 1) + " holds " +
                  (text::trimmed(fields_[c]).empty() ? "nothing" : text::shown(text::trimmed(fields_[c])));
    }
    return true;
  }
  mistake = "has " + std::to_string(fields_.size()) + " fields, the table " + std::to_string(layout_.fields);
  if (open_ && lineEnd + 1 == end_ && fields_.size() < layout_.fields) {
    truncation_ = "line " + std::to_string(line_) + ", the last, " + mistake;
    return false;
  }
  std::fill(values_.begin(), values_.end(), missing);
  return true;
}

bool TextRows::next(std::size_t maximum, Rows& rows) {
  rows.columns.resize(chosen_.size());
  for (auto& column : rows.columns) column.clear();
  rows.lines.clear();
  rows.mistakes.clear();
  std::string mistake;
  while (rows.lines.size() < maximum) {
    if (at_ == whole_ && !fill()) break;
    if (!quickRow()) {
      mistake.clear();
      if (!slowRow(mistake)) continue;
      if (!mistake.empty() && rows.mistakes.size() < maximumMistakes)
        rows.mistakes.emplace_back(rows.lines.size(), mistake);
    }
    for (std::size_t k = 0; k < chosen_.size(); ++k) rows.columns[k].push_back(values_[chosen_[k]]);
    rows.lines.push_back(line_);
  }
  return !rows.lines.empty();
}

}  // namespace squat::records
