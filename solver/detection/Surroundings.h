// solver/detection/Surroundings.h - kinds that one event alone does not show: wheel flats, corrugation.
#pragma once

#include <vector>

#include "detection/Event.h"

namespace squat::detection {

struct SurroundingsOptions {
  // [m] of the wheel; 0: found, between these two.
  double circumference = 0;
  double minimumCircumference = 2.0, largestCircumference = 3.4;
};

// A wheel flat strikes once a turn: four events or more, of which each has another one circumference away (two where
// one is missed). Four that look like no flat (Judgement::flatProbability) are none; three that look like flats are one
// where the circumference is known, as from another flat. Those of them that are four times as strong as the middle one
// are something else on top. Events of one channel, in the order of travel, judged. Returns the circumference [m], 0
// where there is no flat.
double markFlats(std::vector<Event>& events, const SurroundingsOptions& options);

// Indices of the events that belong to long chains of strikes, ten and more: a flat that strikes in every turn, which
// is no background. Events need not be judged.
std::vector<std::size_t> strikesOfFlats(const std::vector<Event>& events, const SurroundingsOptions& options);

// Corrugation excites a stretch: an event whose neighbourhood is as loud over two metres and more.
void markCorrugation(std::vector<Event>& events);

}  // namespace squat::detection
