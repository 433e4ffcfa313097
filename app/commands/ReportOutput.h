// app/commands/ReportOutput.h - a report as a PDF; a headless build has no pages and says so.
#pragma once

#include <string>
#include <vector>

#include "project/Report.h"

namespace squat::commands {

struct ReportChoice {
  std::vector<std::string> figures;  // empty: all that the run has something for
  std::string colours = "viridis";
  std::string page = "a4";  // or "letter"
};

// Writes the report whole or not at all and returns what could not be computed or drawn. Throws CaseError for unknown
// figures and in a headless build, FileError where the file cannot be written.
std::vector<std::string> writeReport(const project::Report& report, const ReportChoice& choice,
                                     const std::string& path);

}  // namespace squat::commands
