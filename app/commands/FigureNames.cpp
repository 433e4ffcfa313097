#include "commands/FigureNames.h"

#include <algorithm>

#include "commands/FigureOutput.h"

namespace squat::commands {

CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<std::string>& entries,
                     const std::string& help) {
  const auto take = [&entries](const std::vector<std::string>& given) {
    entries.clear();
    for (const auto& entry : given)
      if (std::find(entries.begin(), entries.end(), entry) == entries.end()) entries.push_back(entry);
  };
  return command.add_option_function<std::vector<std::string>>(name, take, help)->delimiter(',');
}

void addFigureNames(CLI::App& command, std::vector<std::string>& figures, std::vector<std::string>& formats) {
  addList(command, "--figures", figures, "Figures to draw, separated by commas (default: all that the result has)")
      ->type_name("NAME,...");
  addList(command, "--format", formats, "png, svg, pdf (default: all)")->type_name("FORMAT,...");
  if (const auto list = figureList(); !list.empty()) command.footer("Figures:\n" + list);
}

}  // namespace squat::commands
