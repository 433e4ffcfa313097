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

// Of about a kilometre each.
std::vector<BackgroundSection> backgroundSections(const std::vector<Piece>& pieces);
// The nearest one; nullptr where there is none.
const BackgroundSection* sectionAt(const std::vector<BackgroundSection>& sections, double position);

}  // namespace squat::detection
