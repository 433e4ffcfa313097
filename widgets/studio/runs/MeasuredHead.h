// widgets/studio/runs/MeasuredHead.h - the columns of a measured file and its first rows, read without the rest of it.
#pragma once

#include <QString>
#include <cstddef>
#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "readers/TableRoles.h"
#include "results/ArrayStream.h"
#include "text/DelimitedTable.h"

namespace squat::studio {

// Arrays of one group and one length, which are read together.
struct ArrayPart {
  std::string group;  // "/left"
  std::size_t samples = 0;
  std::string object;  // path of one of them: what chooses the part
};

struct MeasuredHead {
  std::string path;
  text::DelimitedTable table;                  // the columns, of a text file with their first values
  std::vector<bool> numeric;                   // of each column
  std::vector<std::vector<std::string>> rows;  // as the file writes them; of arrays: firstRows()
  // Of a file of arrays alone.
  std::vector<ArrayPart> parts;
  std::size_t part = 0;                      // the one whose columns these are
  std::vector<results::ArrayColumn> places;  // of each column
  std::size_t samples = 0;
  double rate = 0, speed = 0;  // [Hz], [m/s] beside the signal; 0: none
  bool severalParts = false;   // none of the parts is clearly meant
  std::string problem;         // why there are no columns; empty: there are

  bool isArrays() const { return !parts.empty(); }
};

// The beginning of a text file, the listing of a file of arrays; `options` as they choose the part and the layout.
MeasuredHead headOf(const std::string& path, const readers::SignalFileOptions& options);

// The first rows of the arrays: that takes as long as a piece of them does. Throws FileError.
std::vector<std::vector<std::string>> firstRows(const MeasuredHead& head);

// What the reader takes the columns for; where an axis is in an unknown unit, no column is anything.
readers::TableRoles rolesIn(const MeasuredHead& head, const readers::SignalFileOptions& options);

// The column that the reader takes without being asked; noColumn: it asks.
std::size_t clearSignal(const MeasuredHead& head, const readers::TableRoles& roles);

// The one that is offered first: what `options` name, of several that of the record `run`; else the clear one, else the
// first acceleration, else the first column of numbers.
std::size_t likelySignal(const MeasuredHead& head, const readers::SignalFileOptions& options, const std::string& run);

// How options name a column: its name where that is unmistakable, else its number.
std::string optionOf(const MeasuredHead& head, std::size_t column);

// "2: left box [m/s²]"
QString columnText(const MeasuredHead& head, std::size_t column);

// Several columns could be the signal, and none of them is clearly meant.
bool needsChoice(const MeasuredHead& head);

}  // namespace squat::studio
