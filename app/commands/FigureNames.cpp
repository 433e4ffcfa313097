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

using plots::PrintedSize;

// "80x55 to 400x400"
std::string allowedSizes() {
  char text[60];
  std::snprintf(text, sizeof text, "%gx%g to %gx%g", PrintedSize::minimumWidth, PrintedSize::minimumHeight,
                PrintedSize::maximumSide, PrintedSize::maximumSide);
  return text;
}

// "85x60"
void takeSize(const std::string& text, PrintedSize& size) {
  char after = 0;
  PrintedSize taken = size;
  const bool read = std::sscanf(text.c_str(), "%lfx%lf%c", &taken.width, &taken.height, &after) == 2;
  const auto allowed = [](double side, double minimum) { return side >= minimum && side <= PrintedSize::maximumSide; };
  if (!read || !allowed(taken.width, PrintedSize::minimumWidth) || !allowed(taken.height, PrintedSize::minimumHeight))
    throw CLI::ValidationError("--figure-size", text + ": width and height in mm, " + allowedSizes() + ", e.g. 85x60");
  size = taken;
}

void takeScale(const std::string& text, analysis::SpectrumScale& scale) {
  const auto found = analysis::spectrumScaleNamed(text);
  if (!found) throw CLI::ValidationError("--spectrum", text + ": linear, log, dB or third-octaves");
  scale = *found;
}

}  // namespace

void addFigureSize(CLI::App& command, PrintedSize& size) {
  command
      .add_option_function<std::string>(
          "--figure-size", [&size](const std::string& text) { takeSize(text, size); },
          "Width and height of each figure in mm, " + allowedSizes() +
              " (default: 85x60; wide figures 170 and a height of their own)")
      ->type_name("WIDTHxHEIGHT");
  command.add_option("--dpi", size.resolution, "Resolution of PNG files (default: 300)")
      ->check(between(PrintedSize::minimumResolution, PrintedSize::maximumResolution))
      ->type_name("N");
}

void addFigureNames(CLI::App& command, NamedFigures& named) {
  addList(command, "--figures", named.figures,
          "Figures to draw, separated by commas (default: all that the result has)")
      ->type_name("NAME,...");
  addList(command, "--format", named.formats, "png, svg, pdf (default: all)")->type_name("FORMAT,...");
  addFigureSize(command, named.size);
  command
      .add_option_function<std::string>(
          "--spectrum", [&named](const std::string& text) { takeScale(text, named.settings.spectrum); },
          "Scale of the figure psd: linear, log, dB (of the density) or third-octaves (levels in bands of IEC 61260-1) "
          "(default: linear)")
      ->type_name("SCALE");
  if (const auto list = figureList(); !list.empty()) command.footer("Figures:\n" + list);
}

}  // namespace squat::commands
