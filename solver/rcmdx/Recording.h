// solver/rcmdx/Recording.h - what an RCM-DX file holds (SBB's exchange format for rail condition monitoring, an HDF5
// file): sessions, data sources, channels and where positions stand. Nothing here holds samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/ArrayTree.h"

namespace squat::rcmdx {

struct Channel {
  std::string path;           // of its group
  std::string data;           // of its dataset
  std::string name;           // without the names of system and source in front of it
  std::string unit;           // as the file states it, words as symbols ("metre per second squared": m/s2)
  std::string basis;          // ChannelBasis: "MOVE_DIRECTION_VERTICAL_LEFT"; empty: not stated
  std::string triggerMode;    // TIME, DISTANCE or EVENT; empty: not stated
  std::string neighbour;      // name of the channel beside it
  std::size_t samples = 0;    // as many as there are times, or the file is damaged
  double frequency = 0;       // [Hz] nominal; 0: not stated
  double distance = 0;        // [m] between samples; 0: not stated
  double positionOffset = 0;  // [m] of the sensor from the vehicle's zero point; the sign is the file's
};

// Channels that share their times.
struct DataSource {
  std::string path, system, name;  // system: of the measuring system that it is part of
  std::string timestamps;          // path of their dataset: [ns] since 1970-01-01 UTC, rising
  std::size_t samples = 0;
  std::vector<Channel> channels;
};

// Paths of the datasets of positions, all equally long; empty where there is none.
struct PositionSource {
  std::string path, timestamps;
  std::size_t samples = 0;
  std::string coveredDistance, trackOffset, lineOffset, trackId, lineId, direction, kilometrage, accuracy;
  std::string quality;
};

struct Session {
  std::string path, name, platform, vehicleNumber;
  std::int64_t start = 0, end = 0;  // [ns] since 1970-01-01 UTC; 0: not stated
  std::vector<DataSource> sources;  // in the order of the file
  std::optional<PositionSource> position;
  std::string topology;  // path of its group; empty: none
};

struct Recording {
  std::string path;
  int major = 0, minor = 0, feature = 0;  // of the specification
  std::vector<Session> sessions;
};

// Whether a listed file (results::listHdf5) is one, by the version that its root states and the groups beneath.
bool isRcmDx(const results::ArrayTree& tree);
bool isRcmDx(const std::string& path);  // false too for a file that is no HDF5, or a damaged one

// What the file holds. Throws FileError where it holds no session.
Recording recordingOf(const std::string& path, const results::ArrayTree& tree);
Recording readRcmDx(const std::string& path);

// The list that both work on: as results::listHdf5, with room for the many pictures of such files.
results::ArrayTree listRcmDx(const std::string& path);

// Last part of a path; the part before it.
std::string nameIn(const std::string& path);
std::string groupOf(const std::string& path);

}  // namespace squat::rcmdx
