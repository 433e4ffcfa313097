// solver/studies/StudyIdentity.h - which study the files of a folder belong to.
#pragma once

#include <optional>
#include <string>

#include "studies/Partition.h"
#include "studies/StudyGrid.h"

namespace squat::studies {

// FOLDER/study.json, of the whole table.
std::string identityPath(const std::string& folder);
// Writes it where it does not say the same already. FileError.
void writeIdentity(const StudyDefinition& definition, const std::string& folder);
// Throws CaseError where the folder's study.json is that of another study (another case, other points, another version
// of the program), FileError where it is damaged. False where there is none.
bool hasIdentity(const StudyDefinition& definition, const std::string& folder);

// FOLDER/study-parts.json, which all parts of a study have in common: the study and how it is divided. Written by the
// part that starts first, whole and never over another one; the others compare. Throws CaseError, with nothing
// written, where the folder holds another study, parts of another division, or a study that is computed by one process;
// FileError where it cannot be written. Parts by hash may grow: the points of before are among those of `definition`.
void claimParts(const StudyDefinition& definition, const Partition& partition, const std::string& folder);

// Throws CaseError where the folder's study.csv is not that of the parts' study, or of fewer of its points.
void requireOwnTable(const StudyDefinition& definition, const Partition& parts, const std::string& folder);

// What claimParts() has left; checked in the same way. Nothing where no part has started there.
std::optional<Partition> partsIn(const StudyDefinition& definition, const std::string& folder);

}  // namespace squat::studies
