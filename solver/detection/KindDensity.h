// solver/detection/KindDensity.h - how likely the energies of an event are if it is a joint, a weld or another kind.
#pragma once

#include <vector>

#include "detection/EventMatch.h"
#include "detection/Example.h"
#include "detection/PossibleDefects.h"

namespace squat::detection {

// Of the logarithm of the speed: what two speeds have in common.
inline constexpr double speedSpread = 0.15;

// Density of an event's energies, on one scale with SquatSize::logDensity. Half of it comes from the examples of the
// kind, each freed of its own vehicle and taken to that of the record; for joints and welds the other half comes from
// the paths of many possible ones, since the examples have few of each form.
class KindDensity {
 public:
  // All that it is given must outlive it.
  KindDensity(const SizeModel& model, const std::vector<Example>& examples, const PossibleDefects& possible);

  // Logarithm; minus infinity for a kind without examples and paths.
  double of(Kind kind, const EventFeatures& event, const Vehicle& vehicle);

 private:
  double ofExamples(Kind kind, const EventFeatures& event, const Vehicle& vehicle) const;
  double ofPaths(ExpectedBySpeed& paths, const EventFeatures& event, const Vehicle& vehicle) const;

  const SizeModel& model_;
  const std::vector<Example>& examples_;
  ExpectedBySpeed joints_, welds_;
};

}  // namespace squat::detection
