// solver/project/ReportContent.h - what a report says, in words and tables, whatever it is printed with.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "project/Report.h"

namespace squat::project {

struct ReportTable {
  std::string heading;               // empty: none
  std::vector<std::string> columns;  // empty: each row is a name and what it names
  std::vector<std::vector<std::string>> rows;
};

// A squat of the list of events, which has a page of its own.
struct ReportSquat {
  std::size_t event = 0;  // its place in Report::events
  std::string heading;    // "Squat at 12345.68 m"
  ReportTable facts;      // kind, place, severity, size; without heading and columns
};

inline constexpr std::size_t squatsWithPages = 200;  // of more squats, those with the largest accelerations

// For a reader who does not know the program: what it is about first, whatever has a key or a word of the program's own
// last. Names are words, units stand beside them; no row and no column says nothing.
struct ReportContent {
  std::vector<std::string> sentences;  // one a run or signal, and one of the events
  std::vector<ReportTable> body;       // the summary, a column a signal and at most four in a table; changed inputs
  ReportTable squatList;               // every squat in a row; no rows: there are none
  std::vector<ReportSquat> squats;     // in the order of the list
  // Files and versions, other events, features of the run that is shown, and its case: every key that has an effect.
  std::vector<ReportTable> appendix;
};

// What cannot be computed of a signal is said in `problems`.
ReportContent reportContent(const Report& report, std::vector<std::string>& problems);

}  // namespace squat::project
