// solver/rcmdx/TrackPositions.h - where the vehicle was at a time: the positions of a session, and between them.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "rcmdx/Recording.h"
#include "rcmdx/TimeBracket.h"

namespace squat::rcmdx {

// A place on the network. Not-a-number, -1 and 0: not known.
struct Place {
  double covered = std::numeric_limits<double>::quiet_NaN();      // [m] since the session began
  double trackOffset = std::numeric_limits<double>::quiet_NaN();  // [m] from the track's start
  double lineOffset = std::numeric_limits<double>::quiet_NaN();   // [m] of the line; the file has km
  std::int32_t track = -1, line = -1;                             // their ids
  int direction = 0;                                              // 1: the vehicle runs forward, -1: backward
  int kilometrage = 0;                                            // 1: chainage rises as the vehicle runs, -1: it falls
  double accuracy = std::numeric_limits<double>::quiet_NaN();     // [m]
  int quality = -1;                                               // 0: very good, 15: very poor; -1: not known
};

// The positions of a session as columns. A column that the file lacks has the values for "not known".
struct PositionTrack {
  std::vector<std::int64_t> time;  // [ns] since 1970-01-01 UTC, rising
  std::vector<double> covered, trackOffset, lineOffset;
  std::vector<std::int32_t> track, line;
  std::vector<signed char> direction, kilometrage;
  std::vector<float> accuracy;
  std::vector<signed char> quality;

  std::size_t size() const { return time.size(); }
  Place place(std::size_t index) const;
};

// At most some five million positions: of more, every second, third, ... Throws FileError, also where times fall.
PositionTrack readPositions(const std::string& path, const PositionSource& source);

// Places between positions, on a straight line over time; up to a second before the first and behind the last as the
// vehicle ran there. Not known further away, and where positions are lost over more than 100 m. Where the track or line
// changes, its offset is that of the nearer position; not known if they are more than 2 m apart.
class PlaceFinder {
 public:
  explicit PlaceFinder(const PositionTrack& track) : track_(&track), bracket_(track.time) {}
  Place at(std::int64_t time);  // [ns]; quick for times that rise from call to call

 private:
  const PositionTrack* track_;
  BracketFinder bracket_;
};

// The same for many times, in the order given.
std::vector<Place> placesAt(const PositionTrack& track, const std::vector<std::int64_t>& times);

// Names by id; what the topology does not hold is missing.
struct NetworkNames {
  std::map<std::int32_t, std::string> tracks, lines;
};
NetworkNames readNames(const std::string& path, const results::ArrayTree& tree, const Session& session);

}  // namespace squat::rcmdx
