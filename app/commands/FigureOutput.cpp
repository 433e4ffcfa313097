#include "commands/FigureOutput.h"

#include "plots/Application.h"
#include "plots/Figures.h"

namespace squat::commands {

bool figuresAvailable() { return true; }

FigureOutput writeFigures(const results::RunResult& result, const std::string& folder,
                          const std::vector<std::string>& figures, const std::vector<std::string>& formats) {
  plots::ensureApplication();
  plots::FigureRequest request;
  request.figures = figures;
  if (!formats.empty()) request.formats = formats;
  FigureOutput output;
  output.files = plots::renderFigures(result, folder, request, &output.messages);
  return output;
}

}  // namespace squat::commands
