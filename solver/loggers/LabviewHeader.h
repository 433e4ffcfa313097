// solver/loggers/LabviewHeader.h - the tagged rows before the numbers in a LabVIEW measurement file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/Lines.h"

namespace squat::loggers {

enum class LabviewAxis {
  none,
  one,
  multi
};  // X_Columns: no column of X, one for all channels, one before each channel

struct LabviewHeader {
  char separator = '\t';
  char decimal = 0;  // 0: not stated, as before LabVIEW 8.6
  LabviewAxis axis = LabviewAxis::one;
};

struct LabviewChannel {
  std::string name, unit;
  std::string dimension;    // of X: "Time", "Frequency"; empty: not stated
  std::string abscissa;     // unit of X; empty: not stated
  std::string stepText;     // Delta_X as it is written
  double x0 = 0, step = 0;  // of X; 0: not stated
};

struct LabviewSegment {
  std::vector<LabviewChannel> channels;
  std::size_t fieldsPerChannel = 1;  // 2 with an X of its own
};

// Reads on to the end of the file's header. Throws FileError where it does not end.
LabviewHeader labviewHeader(text::Lines& lines, const std::string& path);

// Reads from `line`, the first row of a segment's header, to its row of names. Throws FileError.
LabviewSegment labviewSegment(text::Lines& lines, std::string_view line, const LabviewHeader& header,
                              const std::string& path);

// The next row that is neither empty nor inside a special block (***Start_Special*** to ***End_Special***).
bool nextLabviewRow(text::Lines& lines, std::string_view& line);

}  // namespace squat::loggers
