#include "commands/FigureNames.h"

#include <algorithm>
#include <cstdio>

#include "commands/FigureOutput.h"
#include "commands/NumberRange.h"

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

namespace {

// "85x60"
void takeSize(const std::string& text, FigureSize& size) {
  constexpr double leastWidth = 80, leastHeight = 55, most = 400;  // below it labels of axes are cut
  char after = 0;
  FigureSize taken = size;
  const bool read = std::sscanf(text.c_str(), "%lfx%lf%c", &taken.width, &taken.height, &after) == 2;
  const auto allowed = [&](double side, double least) { return side >= least && side <= most; };
  if (!read || !allowed(taken.width, leastWidth) || !allowed(taken.height, leastHeight))
    throw CLI::ValidationError("--figure-size", text + ": width and height in mm, 80x55 to 400x400, e.g. 85x60");
  size = taken;
}

}  // namespace

void addFigureSize(CLI::App& command, FigureSize& size) {
  command
      .add_option_function<std::string>(
          "--figure-size", [&size](const std::string& text) { takeSize(text, size); },
          "Width and height of each plot in mm, 80x55 to 400x400 (default: 85x60, wide ones 170 and their own height); "
          "the "
          "3-D "
          "picture keeps its own")
      ->type_name("WIDTHxHEIGHT");
  command.add_option("--dpi", size.resolution, "Resolution of PNG files, 50 to 1200 (default: 300)")
      ->check(between(50, 1200))
      ->type_name("N");
}

void addFigureNames(CLI::App& command, NamedFigures& named) {
  addList(command, "--figures", named.figures,
          "Figures to draw, separated by commas (default: all that the result has)")
      ->type_name("NAME,...");
  addList(command, "--format", named.formats, "png, svg, pdf (default: all)")->type_name("FORMAT,...");
  addFigureSize(command, named.size);
  if (const auto list = figureList(); !list.empty()) command.footer("Figures:\n" + list);
}

}  // namespace squat::commands
