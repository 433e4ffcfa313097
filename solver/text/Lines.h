// solver/text/Lines.h - a text file line by line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace squat::text {

// Walks through a text in memory, which must outlive it. A byte-order mark is skipped; a line comes without its line
// feed (a carriage return before it stays). Throws FileError for UTF-16, for bytes of zero in the first 64 KB and for a
// line above 1 MB; `advice` says how to export such a file.
class Lines {
 public:
  Lines(std::string_view text, std::string path, const std::string& advice);

  bool next(std::string_view& line);                // any line
  bool nextRow(std::string_view& line);             // the next that is neither empty nor a comment (isComment)
  std::uint32_t number() const { return number_; }  // of the line that came last, from 1
  std::string location() const;                     // "line 12", for messages

 private:
  std::string_view rest_;
  std::string path_;
  std::uint32_t number_ = 0;
};

// Empty, or beginning with # or %.
bool isComment(std::string_view line);

// The fields of a line; quotes around a field are taken off, delimiters inside them do not separate. The delimiter ' '
// stands for any blanks.
void splitFields(std::string_view line, char delimiter, std::vector<std::string_view>& fields);

}  // namespace squat::text
