// widgets/plots/StudyFigures.h - features of a study against its parameters.
#pragma once

#include <vector>

#include "plots/FigureSheet.h"
#include "studies/StudyTable.h"

namespace squat::plots {

// One sheet a varied key, study_KEY: peak, moving rms, contact force, powers in the bands, wavelength and strongest
// line against the key's values; one curve for each combination of the other keys' values (at most twelve, the caption
// says so where there are more). Values that are no numbers stand at equal distances
// and are not joined by lines. Runs that failed or have not ended, and features without a value, are missing points.
std::vector<FigureSheet> studyFigures(const studies::StudyTable& table, const Style& style);

}  // namespace squat::plots
