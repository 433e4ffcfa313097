// app/commands/StudySummary.h - a study's table for a terminal: the keys and a few of the features.
#pragma once

#include <string>

#include "studies/StudyTable.h"

namespace squat::commands {

// One row a run that has ended, at most 40 of them; the anchor of the features in the line above. Empty where no run
// has ended.
std::string studySummary(const studies::StudyTable& table);

}  // namespace squat::commands
