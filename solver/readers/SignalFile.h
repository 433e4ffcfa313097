// solver/readers/SignalFile.h - axle box acceleration from files that others have written: text tables, HDF5 and MATLAB
// files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "signals/Record.h"

namespace squat::readers {

struct SignalFileOptions {
  // Columns by name (case does not count) or number from 1, several parted by commas, "all" for every column that is
  // not an axis. Empty: the column named aba, else the only one that is no axis.
  std::string column;
  std::string timeColumn, positionColumn, speedColumn, runColumn;  // empty: found by their headers
  std::string object;  // path inside an HDF5 file: a dataset or a group; empty: found by name
  double rate = 0;     // [Hz]; 0: from the time column, or from equally spaced positions and the speed
  double speed = 0;    // [m/s] constant; 0: from the speed column or from time and position
  char delimiter = 0;  // 0: found; ' ' stands for any blanks
  char decimal = 0;    // '.' or ','; 0: found
  // Units that the file does not state, or states wrongly: column, by name or number, and unit.
  std::vector<std::pair<std::string, std::string>> units = {};
  std::string signalUnit = {};  // of signals for which neither the file nor `units` states one
  std::string timeUnit = {};    // of the time column; empty: as the file states it
  std::size_t headLine = 0;     // of the text file's heading, from 1; 0: found
};

// Throws CaseError for options that no file could fit.
void requireOptions(const SignalFileOptions& options);

// All runs of a file, one record with one channel for each signal column and run.
//
// Text: any delimiter (, ; tab | blanks), decimal point or comma, with or without header, lines before the header, a
// row of units under it; names in UTF-8 or Latin-1; CRLF, byte-order mark, quoted fields, lines that begin with # or %
// are understood. Units in the header: s, ms, us; m, km, mm and km+m (12+345.6); m/s, km/h; m/s2, mm/s2, g. Without
// header a first column that rises in equal steps is the time in s. A run column, or a time that jumps back, parts
// runs. HDF5: a dataset of one or two dimensions, a group of datasets, a result file of this program. MATLAB
// files of version 5 and later: an array, or a structure of arrays.
//
// Throws FileError with line or object: unreadable, no table, wrong column, a gap or a not-a-number in a column that is
// used, a value beyond 1e100, a time or position that does not rise, no sampling rate, fewer than 2 samples, an axis in
// an unknown unit. Limit: 4 GB of text, 384 MB of HDF5 values, 190 MB in one dataset.
std::vector<signals::Record> readSignals(const std::string& path, const SignalFileOptions& options = {});

// The record's signal with its positions. Throws CaseError where neither speed nor position is known.
signals::Passage passageWithPositions(const signals::Record& record);

}  // namespace squat::readers
