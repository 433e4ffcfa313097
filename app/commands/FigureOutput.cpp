#include "commands/FigureOutput.h"

#include "plots/Application.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"

namespace squat::commands {

bool figuresAvailable() { return true; }

std::string figureList() { return plots::figureList(); }

namespace {

plots::FigureRequest requestOf(const std::vector<std::string>& figures, const std::vector<std::string>& formats) {
  plots::FigureRequest request;
  request.figures = figures;
  if (!formats.empty()) request.formats = formats;
  return request;
}

}  // namespace

void checkFigureNames(const std::vector<std::string>& figures, const std::vector<std::string>& formats,
                      const cases::CaseDescription* description) {
  plots::checkRequest(requestOf(figures, formats), description);
}

FigureOutput writeFigures(const results::RunResult& result, const std::string& folder,
                          const std::vector<std::string>& figures, const std::vector<std::string>& formats) {
  plots::ensureApplication();
  FigureOutput output;
  output.files = plots::renderFigures(result, folder, requestOf(figures, formats), &output.messages);
  return output;
}

}  // namespace squat::commands
