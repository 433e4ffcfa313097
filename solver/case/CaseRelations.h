// solver/case/CaseRelations.h - the checks behind Validation.h, by theme; internal to solver/case.
#pragma once

#include <vector>

#include "case/Validation.h"

namespace squat::cases::relations {

void checkMaterials(const CaseDescription& description, std::vector<Finding>& findings);
void checkWheelset(const CaseDescription& description, std::vector<Finding>& findings);
void checkTrackAndRun(const CaseDescription& description, std::vector<Finding>& findings);
void checkDefect(const CaseDescription& description, std::vector<Finding>& findings);
void checkMeasuredProfile(const CaseDescription& description, std::vector<Finding>& findings);
void checkTread(const CaseDescription& description, std::vector<Finding>& findings);
void checkIrregularity(const CaseDescription& description, std::vector<Finding>& findings);
void checkLosses(const CaseDescription& description, std::vector<Finding>& findings);
void checkSeat(const CaseDescription& description, std::vector<Finding>& findings);
void checkMesh(const CaseDescription& description, std::vector<Finding>& findings);
void checkBogie(const CaseDescription& description, std::vector<Finding>& findings);
void checkTraction(const CaseDescription& description, std::vector<Finding>& findings);

}  // namespace squat::cases::relations
