// solver/project/Project.h - a piece of work around some runs as one plain value: cases, runs, measured signals, long
// records, notes and views.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/FigureSettings.h"
#include "readers/SignalFile.h"
#include "signals/Record.h"

namespace squat::project {

// The case that is being edited. Its text is in the project: what is not saved yet comes back as well.
struct OpenCase {
  std::string name;
  std::string path;       // empty: in no file of its own
  bool modified = false;  // differs from that file
  std::string toml;
};

enum class Kind { run, measured };

// A run or a measured signal: a link to its file.
struct Entry {
  Kind kind = Kind::run;
  std::string path;
  std::string digest;  // recordDigest() of what the file held; empty: not known
  std::string name;
  bool named = true;  // by the user, or after its file; false: by what differs between the runs
  bool overlaid = false;
  std::string colour;  // "#rrggbb"; empty: the automatic one
  // Of a measured signal: which one of the file, how the file is read, and where its largest value was laid [m].
  std::string signal;
  readers::SignalFileOptions reading;
  double impact = 0;
  double gain = 1;           // of its values
  bool isAutomatic = false;  // laid beside the run that is shown, again with every other run
};

// What the user has seen at an event of a long record.
struct SeenEvent {
  double position = 0;  // [m]
  std::string channel;
  std::string seenAs;  // "severe squat", "weld"
};

// How the rows of a table stand.
struct TableOrder {
  std::string sort;         // name of the column; empty: as they were made
  bool descending = false;  // of that column
  std::string group;        // name of the column whose values make groups; empty: none
  std::string filter;       // as typed
  bool operator==(const TableOrder&) const = default;
};

// Long records, the options of the search for events in them, and what came out.
struct LongRecords {
  std::vector<std::string> files;    // empty: none are open
  std::vector<std::string> digests;  // fileDigest() of each; empty: not known
  std::string channels, chainage;    // as typed; empty: all accelerations, from the file
  double speed = 0;                  // [m/s]; 0: from the file
  std::string units;                 // as typed: "aba=g, speed=km/h"; empty: as the files state them
  std::string together;              // several files: "ride", "passes"; empty: as they follow on each other
  std::string axles;                 // as typed: "none", "left,right"; empty: by the names of the channels
  bool ownVehicle = false;           // judged by the vehicle and track of the open case
  std::string labels;                // file of the user's labels; empty: none
  std::string events;                // file of the list of events, squats.json; empty: not written yet
  std::vector<SeenEvent> seen;       // saved as labels or not
  TableOrder order;                  // of the list of events
};

// The part of an axis that is seen, low < high.
struct AxisRange {
  double low = 0, high = 0;  // in `unit`
  std::string unit;          // "m", "s", "Hz", "N", "Pa", "m/s²": SI; of decibels, with what they refer to
};

// What is enlarged of a figure.
struct FigureRange {
  std::string figure;             // name of its tab
  std::optional<AxisRange> x, y;  // none: the whole axis
};

// How the figures of the signals are computed and drawn, and what of them is seen.
struct FigureViews {
  analysis::FigureSettings settings;
  std::vector<FigureRange> ranges = {};  // of the figures that are not seen whole
};

// All paths are absolute here; in the file they are relative to it where they can be (ProjectFile.h).
struct Project {
  OpenCase open;
  std::vector<std::string> cases;  // files of the cases that were worked on, the last one first
  std::vector<Entry> entries;
  int current = -1, reference = -1;  // of the entries; -1: none
  std::string notes;
  std::vector<std::string> views;      // names of the tabs in front
  std::optional<FigureViews> figures;  // none: as the program starts
  LongRecords records;
  TableOrder runOrder;  // of the list of runs
};

// Eight hexadecimal digits that stand for times, positions and values of a record: whether a file still holds what it
// held.
std::string recordDigest(const signals::Record& record);

}  // namespace squat::project
