// widgets/studio/document/ShownCase.h - whether the result that is shown was computed from the case that is open.
#pragma once

#include <QString>

#include "case/CaseDescription.h"
#include "results/RunResult.h"

namespace squat::studio {

// "motion.speed, defect.depth and 3 more differ"; empty where all that counts is the same, or there is no result.
QString differenceOfCases(const results::RunResult* result, const cases::CaseDescription& open);

}  // namespace squat::studio
