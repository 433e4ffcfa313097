// solver/project/Report.h - what a report is about: runs, measured signals and the events of long records, as a plain
// value. ReportContent.h says it in words.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "project/EventList.h"
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
  int shown = -1;                    // the run in the figures; -1: none is drawn
  int reference = -1;                // what the others are compared with; -1: nothing
  std::string date = {};             // of the report, as it is printed; empty: today
  EventList events = {};             // of long records, none: no search was made
  std::string eventFolder = {};      // of that list; beside it stand the files with the signals over squats
  std::vector<SeenEvent> seen = {};  // what the user has seen at events
};

// The report of a project, without a title: every run and signal of it, results without fields except the one that is
// shown, and the list of events of its long records. The reference is the one that was chosen, else the first measured
// signal, else the first run. `problems` gets a sentence for each file that is missing or has changed since.
Report reportOf(const Project& project, std::vector<std::string>& problems);

// Reads the list of events that a search has written. One that is missing or damaged is said in `problems`.
void addEvents(const LongRecords& records, Report& report, std::vector<std::string>& problems);

}  // namespace squat::project
