// solver/signals/Record.h - what one wheel felt on its way along the track, computed or measured.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "signals/Alignment.h"

namespace squat::signals {

enum class Origin { computed, measured };

// One signal of a record. `name` and `unit` are also those of its dataset in a result file.
struct Channel {
  std::string name, unit, description;
  std::vector<double> values;  // one at each time of the record
};

// Channels over one axis. SI units.
struct Record {
  Origin origin = Origin::computed;
  std::string file;              // path it was read from; empty: not from a file of signals
  std::string run;               // name of the run inside the file: column, and value of the run column
  double speed = 0;              // [m/s] nominal; 0: not known
  std::vector<double> time;      // [s] equally spaced
  std::vector<double> position;  // [m] at each time, strictly rising in the direction of travel; empty: not known
  bool chainage = false;         // position comes from the file's own axis (else it is speed times time from zero)
  bool falling = false;          // the chainage falls along the run: position is its negative
  std::vector<Channel> signals;
  std::vector<std::string> notes;  // what was assumed or mended on reading

  const Channel* channel(std::string_view name) const;  // null: none of this name
  Channel* channel(std::string_view name);
  const std::vector<double>* signal(std::string_view name) const;
};

// A channel by name, the first one where `name` is empty. Throws SignalError where there is none, where it has fewer
// than two samples or another number than times.
TimeSeries seriesOf(const Record& record, std::string_view name = {});

// The same with its positions, which are empty where they are not known. Throws also where there is another number of
// positions than times.
Passage passageOf(const Record& record, std::string_view name = {});

}  // namespace squat::signals
