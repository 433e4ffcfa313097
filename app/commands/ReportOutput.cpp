#include "commands/ReportOutput.h"

#include "plots/Application.h"
#include "plots/FigureFiles.h"
#include "plots/ReportPages.h"

namespace squat::commands {

std::vector<std::string> writeReport(const project::Report& report, const ReportChoice& choice,
                                     const std::string& path) {
  plots::ensureApplication();
  const auto page = choice.page == "letter" ? plots::PageFormat::letter : plots::PageFormat::a4;
  std::vector<std::string> problems;
  plots::writeWhole(plots::reportPdf(report, {page, choice.figures, choice.colours}, problems), path);
  return problems;
}

}  // namespace squat::commands
