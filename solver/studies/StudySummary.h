// solver/studies/StudySummary.h - a study's table as text: the keys and a few of the features.
#pragma once

#include <string>

#include "studies/StudyTable.h"

namespace squat::studies {

// One row a run that has ended, at most 40 of them; the anchor of the features in the line above. Empty where no run
// has ended.
std::string studySummary(const StudyTable& table);

}  // namespace squat::studies
