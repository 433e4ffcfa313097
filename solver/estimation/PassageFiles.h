// solver/estimation/PassageFiles.h - measured passages: read, low-passed, with event and noise found.
#pragma once

#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "signals/Alignment.h"

namespace squat::estimation {

struct MeasuredPassage {
  std::string file, name;    // name: file and run, for people
  signals::Passage passage;  // low-passed [m/s2], positions [m] in the direction of travel
  double speed = 0;          // [m/s] at the event
  double impact = 0;         // [m] position of the largest absolute value
  double peak = 0;           // [m/s2] there
  double noise = 0;          // [m/s2] standard deviation before the event
  std::vector<std::string> notes;
};

// Every run of every file. `speed` [m/s] counts for records that hold neither speed nor position. Throws FileError for
// a signal without unit or in another than m/s2, for one that is sampled too slowly for `cutoff` [Hz], for a record
// that ends less than 60 mm behind the impact or begins less than 40 mm before it, and where no event stands out: its
// peak has to be at least four times the noise.
std::vector<MeasuredPassage> readPassages(const std::vector<std::string>& files,
                                          const readers::SignalFileOptions& reading, double speed, double cutoff);

// The event and the noise of a low-passed passage. Throws as above.
void findEvent(MeasuredPassage& measured, double cutoff);

}  // namespace squat::estimation
