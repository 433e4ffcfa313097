#include "commands/FigureOutput.h"

#include "plots/Application.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"

namespace squat::commands {

bool figuresAvailable() { return true; }

std::string figureList() { return plots::figureList(); }

namespace {

plots::FigureRequest requestOf(const NamedFigures& named) {
  plots::FigureRequest request;
  request.figures = named.figures;
  if (!named.formats.empty()) request.formats = named.formats;
  request.size = named.size;
  request.settings = named.settings;
  return request;
}

}  // namespace

void checkFigureNames(const NamedFigures& named, const cases::CaseDescription* description) {
  plots::checkRequest(requestOf(named), description);
}

FigureOutput writeFigures(const results::RunResult& result, const std::string& folder, const NamedFigures& named) {
  plots::ensureApplication();
  FigureOutput output;
  output.files = plots::renderFigures(result, folder, requestOf(named), &output.messages);
  return output;
}

}  // namespace squat::commands
