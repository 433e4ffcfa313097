// solver/project/Report.h - what a report says of runs and measured signals: a plain value, whatever it is printed
// with.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "project/MeasuredRecords.h"
#include "project/Project.h"
#include "results/RunResult.h"

namespace squat::project {

struct ReportSignal {
  std::string name;
  std::string file;                                            // empty: in none yet
  RecordPointer record;                                        // as it is drawn
  std::shared_ptr<const results::RunResult> result = nullptr;  // null: measured
  MeasuredReading reading = {};                                // of a measured one
  bool overlaid = false;                                       // drawn over the run that is shown
  std::string colour = {};                                     // "#rrggbb"; empty: the automatic one
};

struct Report {
  std::string title;
  std::string notes;  // plain text; an empty line begins a paragraph
  std::vector<ReportSignal> signals;
  int shown = -1;      // the run in the figures; -1: none is drawn
  int reference = -1;  // what the others are compared with; -1: nothing
};

// The report of a project, without a title: every run and signal of it, results without fields except the one that is
// shown. The reference is the one that was chosen, else the first measured signal, else the first run. `problems` gets
// a sentence for each file that is missing or has changed since.
Report reportOf(const Project& project, std::vector<std::string>& problems);

struct ReportTable {
  std::string heading;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

// Runs and signals with file, mesh, time and version; the comparison, a column a signal and at most four in a table;
// the features of the run that is shown; its case, every key that has an effect. Units stand in the first column, or
// in one of their own. What cannot be computed of a signal is said in `problems`.
std::vector<ReportTable> reportTables(const Report& report, std::vector<std::string>& problems);

}  // namespace squat::project
