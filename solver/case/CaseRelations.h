// solver/case/CaseRelations.h - the checks behind Validation.h, by theme; internal to solver/case.
#pragma once

#include <string>
#include <vector>

#include "case/Validation.h"

namespace squat::cases::relations {

// How findings are written: four digits, to the side that is allowed, so that what a message names is accepted; a limit
// in SI as text in the unit of `key`; a finding about keys, the first of which the user should change.
enum class Side { nearest, below, above };
std::string rounded(double value, Side side = Side::nearest);
std::string limitText(const std::string& key, const char* relation, double limit);
void add(std::vector<Finding>& findings, const CaseDescription& description, Severity severity,
         std::vector<std::string> keys, std::string allowed, std::string advice);

void checkMaterials(const CaseDescription& description, std::vector<Finding>& findings);
void checkWheelset(const CaseDescription& description, std::vector<Finding>& findings);
void checkTrackAndRun(const CaseDescription& description, std::vector<Finding>& findings);
void checkDefect(const CaseDescription& description, std::vector<Finding>& findings);
void checkMeasuredProfile(const CaseDescription& description, std::vector<Finding>& findings);
void checkSeat(const CaseDescription& description, std::vector<Finding>& findings);
void checkMesh(const CaseDescription& description, std::vector<Finding>& findings);
void checkTraction(const CaseDescription& description, std::vector<Finding>& findings);

}  // namespace squat::cases::relations
