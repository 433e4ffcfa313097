#include "commands/FigureSheets.h"

namespace squat::commands {

void addFigureOptions(CLI::App& command, FigureChoice& choice, bool mayBeNone) {
  addList(command, "--format", choice.formats, "png, svg, pdf (default: all)")
      ->check(CLI::IsMember({"png", "svg", "pdf"}))
      ->type_name("FORMAT,...");
  command
      .add_option("--colours", choice.colours, "Colour map of scalograms: viridis, cividis or jet (default: viridis)")
      ->check(CLI::IsMember({"viridis", "cividis", "jet"}))
      ->type_name("NAME");
  addFigureSize(command, choice.size);
  if (mayBeNone) command.add_flag("--no-figures", choice.none, "Draw no figures");
}

}  // namespace squat::commands
