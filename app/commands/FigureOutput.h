// app/commands/FigureOutput.h - figures of a result as files; a headless build has none and says so.
#pragma once

#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::commands {

struct FigureOutput {
  std::vector<std::string> files;     // written
  std::vector<std::string> messages;  // what could not be drawn, and why
};

bool figuresAvailable();

// Throws CaseError for unknown names, and for figures of plastic flow where the rail is elastic, before hours are
// spent; says nothing in a headless build, which draws none.
void checkFigureNames(const std::vector<std::string>& figures, const std::vector<std::string>& formats, bool plastic);

// `figures` and `formats` empty: all. Throws CaseError for unknown names (and for any call in a headless build),
// FileError where a file cannot be written.
FigureOutput writeFigures(const results::RunResult& result, const std::string& folder,
                          const std::vector<std::string>& figures, const std::vector<std::string>& formats);

}  // namespace squat::commands
