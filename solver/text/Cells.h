// solver/text/Cells.h - a user's table of words and numbers, cell by cell: labels of events, points of a study.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace squat::text {

struct Cells {
  std::vector<std::vector<std::string>> rows;  // the first is the heading; UTF-8, trimmed, numbers with a decimal point
  std::vector<std::size_t> lines;              // of each row in the file, from 1
};

// Columns between commas, semicolons or tabs, whichever the heading has most of; where it is no comma, numbers may have
// a decimal comma. A byte-order mark, CRLF, empty lines and lines that begin with # or % are skipped; quotes are taken
// off, and what stands between them, line breaks too, is one cell. Throws FileError for what is no text.
Cells cellsOf(std::string_view text, const std::string& path);
Cells readCells(const std::string& path, std::size_t largestFile);

}  // namespace squat::text
