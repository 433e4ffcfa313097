// solver/rcmdx/ChosenSource.h - which session and which data source of a recording are read.
#pragma once

#include <string>
#include <vector>

#include "rcmdx/Recording.h"

namespace squat::rcmdx {

struct ChosenSource {
  Session session;
  DataSource source;               // with the channels alone that are read
  std::vector<std::string> notes;  // what was passed over
};

// `object` as in RecordChoice. Throws FileError as recordColumns() does.
ChosenSource chooseSource(const Recording& recording, const std::string& object);

// Unit and name say what a channel is: "m/s2" for an acceleration, "m/s" for a speed.
bool isAcceleration(const Channel& channel);
bool isSpeed(const Channel& channel);

}  // namespace squat::rcmdx
