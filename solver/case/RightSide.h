// solver/case/RightSide.h - the right side of a whole model: as the left one, but for what the case states in [right].
//
// All other keys describe the left side, which is on the left when one looks in rolling direction. A key of the right
// side has the name of that on the left behind "right.": right.defect.depth.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"
#include "core/Errors.h"

namespace squat::cases {

inline constexpr std::string_view rightGroup = "right";

// "defect.depth" of "right.defect.depth"; empty: the key is none of the right side's.
std::string_view keyOnRight(std::string_view key);
// Whether the sides may differ in this key: defect, supports, suspension, friction, lateral position and the random
// irregularity's seed.
bool mayDiffer(std::string_view key);
// Whether both sides are alike up to their defects, so that they start as mirror images.
bool startsAlike(const CaseDescription& description);
// The row of a key of either side; nullptr: no such key.
const Parameter* findOnEitherSide(std::string_view key);
// What a user reads of a key behind "right." that does not exist, or must be the same on both sides.
CaseProblem noKeyOfRight(std::string_view key);

// The case of the right side alone: a half model.
CaseDescription rightOf(const CaseDescription& description);
// The case of the side that a key belongs to.
inline CaseDescription sideOf(const CaseDescription& description, std::string_view key) {
  return keyOnRight(key).empty() ? description : rightOf(description);
}
// Sets a key of the right side, named as on the left, as trySetValue does. Stated keys stand in the order of the table.
std::optional<CaseProblem> trySetRight(CaseDescription& description, std::string_view key, const std::string& text);
// Whether the case itself states this key of the right side, named as on the left.
bool isStatedOnRight(const CaseDescription& description, std::string_view key);
// The right side again as the left one in this key. The name of a file and the numbers from it go together.
void setAsLeft(CaseDescription& description, std::string_view key);

// Why a key of the right side has no effect in a case; empty: it has one.
std::string reasonWithoutRight(const CaseDescription& description, const Parameter& parameter);
// The same for who has rightOf() of it already.
std::string reasonWithoutRight(const CaseDescription& description, const CaseDescription& right,
                               const Parameter& parameter);

// Throws CaseError for a whole model where only a half one will do: "a warm state".
void requireHalf(const CaseDescription& description, const std::string& purpose);
// The same of a bogie with two wheelsets.
void requireSingleWheelset(const CaseDescription& description, const std::string& purpose);

// What the right side's case says with the names of its keys: "right.defect.depth".
CaseProblem onRight(CaseProblem problem);

}  // namespace squat::cases
