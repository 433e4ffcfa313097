// solver/studies/CaseStudy.h - studies of a case file: the keys are those of the parameter table.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "case/CaseFile.h"
#include "results/RunResult.h"
#include "studies/RunStudy.h"

namespace squat::studies {

// Which points: the texts of --vary, KEY=FROM:TO:COUNT or KEY=V,W,...; with `sample`, KEY=LOW:HIGH; or a file instead.
struct StudyRequest {
  std::vector<std::string> variations = {};
  std::string sample = {}, pointsFile = {};
  std::uint64_t seed = 1;
};

// Reads the case and the texts of --vary. Throws CaseError for unknown keys (with the nearest known one), values of the
// wrong type or out of range, and a grid of which no point can be run; FileError for the case.
StudyDefinition studyOf(const std::string& nameOrPath, const cases::CaseOverrides& overrides,
                        const std::vector<std::string>& variations);
StudyDefinition studyOf(const std::string& nameOrPath, const cases::CaseOverrides& overrides,
                        const StudyRequest& request);

// The case at one point of the grid: file, then overrides, then the point's values. Throws CaseError.
cases::CaseDescription caseAt(const StudyDefinition& definition, const cases::CaseOverrides& overrides,
                              const StudyPoint& point);

// Runs the study with `run` for each case: simulation::runCase with the options of the caller. An incomplete result
// counts as cancelled. Throws CaseError where a file of the study would replace what the case is read from.
using CaseRunner = std::function<results::RunResult(const cases::CaseDescription&, const StudyPoint&, Monitor&)>;
StudyTable runCaseStudy(const StudyDefinition& definition, const cases::CaseOverrides& overrides, const CaseRunner& run,
                        const StudyOptions& options, Monitor& monitor);

}  // namespace squat::studies
