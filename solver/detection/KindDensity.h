// solver/detection/KindDensity.h - how likely the energies of an event are if it is a joint, a weld or another kind.
#pragma once

#include <map>
#include <vector>

#include "detection/EventMatch.h"
#include "detection/Example.h"
#include "detection/PossibleDefects.h"

namespace squat::detection {

// Of the logarithm of the speed: what two speeds have in common.
inline constexpr double speedSpread = 0.15;

// Density of an event's energies, on one scale with SquatSize::logDensity, by the examples of a kind, each freed of its
// own vehicle and taken to that of the record. For what is no squat one half comes from the paths of many possible
// irregularities, since the examples have few of each form. For the kind other, thirds come from examples, paths and a
// normal density as wide as all paths and half as wide again: what resembles none of them is nothing known.
class KindDensity {
 public:
  // `events`: those that it will be asked of. Not to be used once it was cancelled.
  KindDensity(const SizeModel& model, const std::vector<Example>& examples, const PossibleDefects& possible,
              const std::vector<EventFeatures>& events, ThreadTeam& team, Monitor& monitor);

  // Logarithm; minus infinity for a kind without examples and paths.
  double of(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const;
  // Logarithm of the share of a kind's examples that are loud at least as far (EventFeatures::reach). Noise hides the
  // ends of an event and never adds to them, so that a short reach tells nothing.
  double logReach(Kind kind, const EventFeatures& event) const;

 private:
  struct Passage {
    BandValues energies = BandValues::Zero();  // freed of its vehicle where that is known
    bool isFreed = false;
    double speed = 0, weight = 0;
  };
  double ofExamples(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const;
  double ofPaths(const ExpectedBySpeed& paths, const EventFeatures& event, const Vehicle& vehicle) const;
  double ofNoneKnown(const EventFeatures& event, const Vehicle& vehicle) const;

  BandMatrix betweenPassages_;
  std::map<Kind, std::vector<Passage>> passages_;
  std::map<Kind, std::vector<double>> reaches_;  // [m] of the examples
  std::map<Kind, ExpectedBySpeed> paths_;
};

}  // namespace squat::detection
