// solver/detection/PossibleDefects.h - what an event may be: squats of all sizes, joints, welds and the rest, and their
// paths.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "core/Monitor.h"
#include "core/ThreadTeam.h"
#include "detection/EventFeatures.h"
#include "detection/PathSpectrum.h"
#include "detection/Severity.h"
#include "detection/SizeModel.h"

namespace squat::detection {

// Squats of all sizes and forms, each severity the same number of times in sum, with the spectra of their paths.
class PossibleSquats {
 public:
  PossibleSquats(std::size_t count, const SeverityLimits& limits);

  struct Squat {
    double length = 0, depth = 0;  // [m]
    Severity severity = Severity::light;
    double weight = 0;  // sum 1
    PathSpectrum path;
  };
  const std::vector<Squat>& all() const { return squats_; }
  std::vector<const PathSpectrum*> paths() const;

 private:
  std::vector<Squat> squats_;
};

// What is no squat: the kinds that exampleOthers() and exampleFlats() draw.
struct PossibleDefects {
  explicit PossibleDefects(const SeverityLimits& limits);

  PossibleSquats squats;
  std::map<Kind, std::vector<PathSpectrum>> others;
};

// y of SizeModel.h without u, of many paths, for the speeds of some events.
class ExpectedBySpeed {
 public:
  // Ends early where it is cancelled; then it is not to be used.
  ExpectedBySpeed(const SizeModel& model, const std::vector<const PathSpectrum*>& paths,
                  const std::vector<EventFeatures>& events, ThreadTeam& team, Monitor& monitor);
  // Of each path; `speed` [m/s]: that of one of the events.
  const std::vector<BandValues>& at(double speed) const;

  struct Moments {
    BandValues sum = BandValues::Zero();
    BandMatrix squares = BandMatrix::Zero();
    double count = 0;
  };
  const Moments& momentsAt(double speed) const;

 private:
  std::map<long, std::vector<BandValues>> expected_;
  std::map<long, Moments> moments_;
};

}  // namespace squat::detection
