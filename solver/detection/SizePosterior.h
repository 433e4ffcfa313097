// solver/detection/SizePosterior.h - how large the squats of one record are, and how severe.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/Monitor.h"
#include "detection/EventMatch.h"
#include "detection/PossibleDefects.h"

namespace squat::detection {

struct SquatSize {
  std::array<double, 3> severity{};                  // probability of each
  double length = 0, lengthLow = 0, lengthHigh = 0;  // [m] median and 90 % range
  double depth = 0, depthLow = 0, depthHigh = 0;     // [m]
  double logDensity = 0;                             // of the event's energies, if it is a squat
};

struct SquatSizes {
  std::vector<SquatSize> each;  // of the events
  Vehicle vehicle;
};

// Weight of an event's evidence about its vehicle: the events of a record are not independent looks at it.
inline constexpr double sharedEvidence = 0.5;

// What is known of one event before its energies are looked at.
struct Belief {
  double squat = 1;                  // probability to be one
  std::optional<Severity> severity;  // where it is known
};

// Bayes' rule over the possible squats. The noise of an event adds to the energy of a squat, with the scatter that its
// degrees of freedom bring.
class SizePosterior {
 public:
  // Model and squats must outlive it. `events`: those that it will be asked of. Not to be used once it was cancelled.
  SizePosterior(const SizeModel& model, const PossibleSquats& possible, const std::vector<EventFeatures>& events,
                ThreadTeam& team, Monitor& monitor);

  // The events share their vehicle u, which is estimated with their sizes: sizes given the vehicle, and the vehicle
  // given the sizes, in turn until it rests; from the 200 events that are squats most surely. `beliefs`: one for each
  // event; what is no squat says nothing of the vehicle. `own`: passages of the same vehicle over squats of known
  // sizes. `start`: u that the estimate sets out from. Nothing where it was cancelled; not influenced by the number of
  // threads.
  std::optional<Vehicle> vehicleOf(const std::vector<EventFeatures>& events, const std::vector<Belief>& beliefs,
                                   const std::vector<Example>& own, const std::optional<BandValues>& start,
                                   ThreadTeam& team, Monitor& monitor) const;

  // Of one event. `severity`: where it is known.
  SquatSize sizeOf(const EventFeatures& event, std::optional<Severity> severity, const Vehicle& vehicle) const;

 private:
  const SizeModel& model_;
  const PossibleSquats& possible_;
  ExpectedBySpeed expected_;
};

// Vehicle, and sizes of all events, on one thread.
SquatSizes squatSizes(const SizeModel& model, const PossibleSquats& possible, const std::vector<EventFeatures>& events,
                      const std::vector<Belief>& beliefs, const std::vector<Example>& own);

}  // namespace squat::detection
