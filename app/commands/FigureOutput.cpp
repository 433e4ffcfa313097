#include "commands/FigureOutput.h"

#include <algorithm>

#include "core/Errors.h"
#include "plots/Application.h"
#include "plots/Figures.h"

namespace squat::commands {

bool figuresAvailable() { return true; }

namespace {

plots::FigureRequest requestOf(const std::vector<std::string>& figures, const std::vector<std::string>& formats) {
  plots::FigureRequest request;
  request.figures = figures;
  if (!formats.empty()) request.formats = formats;
  return request;
}

}  // namespace

void checkFigureNames(const std::vector<std::string>& figures, const std::vector<std::string>& formats, bool plastic) {
  plots::checkRequest(requestOf(figures, formats));
  for (const char* name : {"permanent_change", "residual_stress"})
    if (!plastic && std::find(figures.begin(), figures.end(), name) != figures.end())
      throw CaseError({{"--figures", name, "a figure of an elastic rail", "It needs rail.plastic = true in the case"}});
}

FigureOutput writeFigures(const results::RunResult& result, const std::string& folder,
                          const std::vector<std::string>& figures, const std::vector<std::string>& formats) {
  plots::ensureApplication();
  FigureOutput output;
  output.files = plots::renderFigures(result, folder, requestOf(figures, formats), &output.messages);
  return output;
}

}  // namespace squat::commands
