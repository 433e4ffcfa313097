// app/commands/FigureOutput.h - figures of a result as files; a headless build has none and says so.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "commands/FigureNames.h"
#include "results/RunResult.h"

namespace squat::commands {

struct FigureOutput {
  std::vector<std::string> files;     // written
  std::vector<std::string> messages;  // what could not be drawn, and why
};

bool figuresAvailable();

// Names and titles of all figures, one a line; empty in a headless build.
std::string figureList();

// Throws CaseError for unknown names and, where a case is given, for figures that a run of it will have nothing for,
// before hours are spent; a headless build, which draws none, checks the formats alone.
void checkFigureNames(const NamedFigures& named, const cases::CaseDescription* description = nullptr);

// Throws CaseError for unknown names (and for any call in a headless build),
// FileError where a file cannot be written.
FigureOutput writeFigures(const results::RunResult& result, const std::string& folder, const NamedFigures& named);

}  // namespace squat::commands
