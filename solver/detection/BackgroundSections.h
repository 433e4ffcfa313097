// solver/detection/BackgroundSections.h - the background of a channel, kilometre by kilometre.
#pragma once

#include <vector>

#include "detection/EvidenceTail.h"
#include "detection/SegmentEvents.h"

namespace squat::detection {

struct BackgroundSection {
  double from = 0, to = 0;  // [m] as the record counts, from <= to
  EvidenceTail tail;
};

struct Way {
  double from = 0, to = 0;  // [m] as the record counts, from <= to
};

// Of about a kilometre each. Metres in which the channel is silent, and those that touch one of `leftOut`, all of one
// length, say nothing of the background.
std::vector<BackgroundSection> backgroundSections(const std::vector<Piece>& pieces, std::vector<Way> leftOut = {});
// The nearest one; nullptr where there is none.
const BackgroundSection* sectionAt(const std::vector<BackgroundSection>& sections, double position);

}  // namespace squat::detection
