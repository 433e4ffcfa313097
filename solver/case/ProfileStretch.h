// solver/case/ProfileStretch.h - which stretch of a long scan is its deepest defect; internal to solver/case.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// What to set for 0.5 m about the deepest place, in words: "Its deepest place, 0.21 mm below the level about it, is at
// 123.456 m: set defect.from = 123.206 and defect.to = 123.706". Points ascend.
std::string stretchAdvice(const std::vector<ProfilePoint>& points);

}  // namespace squat::cases
