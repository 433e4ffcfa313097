// solver/geometry/Stations.h - where the sections of a swept block stand: runs of equally long intervals.
#pragma once

#include <utility>
#include <vector>

namespace squat::geometry {

struct StationRun {
  int count = 0;      // intervals
  double length = 0;  // of each interval: [m] along a line, [rad] around an axis
};

struct Stations {
  double start = 0;     // [m] or [rad]
  bool closed = false;  // around the full circle: the last station is the first
  std::vector<StationRun> runs;

  int intervals() const;
  // Stations that carry unknowns: intervals() + 1, or intervals() when closed.
  int count() const { return closed ? intervals() : intervals() + 1; }
  // intervals() + 1 positions, the last one also when closed.
  std::vector<double> positions() const;
};

// A stretch to be meshed with intervals of at most `length`.
struct Zone {
  double to = 0;      // [m] end of the zone; it begins where the one before ended
  double length = 0;  // [m] requested interval length
  int whole = 0;      // its intervals in all are a multiple of this; 0: of those of a run
};

// Runs that fill exactly `gap` with the fewest intervals of at most `length` that step down towards finer neighbours
// (their interval length as laid, or 0 where there is none) by at most a factor `growth` a run. Runs have multiples of
// `multiple` intervals; all together a multiple of `whole`, itself one of `multiple`, where that is given.
std::vector<StationRun> fillGap(double gap, double length, double finerBefore, double finerAfter, double growth,
                                int multiple, int whole = 0);

// Stations over neighbouring zones from `start`. Where lengths jump by more than `growth`, short runs with intermediate
// lengths are taken from the coarser zone. Runs get multiples of `multiple` intervals, so that vectors along the
// stations are full; zone ends move slightly outwards of the finer zone for that, `start` and the last end stay exact.
Stations stationsOver(double start, const std::vector<Zone>& zones, double growth, int multiple);

// Interval of ascending positions that holds a value, the outermost where it lies beyond them: index of its left end,
// and the fraction of the interval from there.
std::pair<int, double> intervalOf(const std::vector<double>& positions, double at);

}  // namespace squat::geometry
