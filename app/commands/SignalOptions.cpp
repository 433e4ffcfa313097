#include "commands/SignalOptions.h"

#include <filesystem>

#include "analysis/OptionText.h"
#include "case/ShippedCases.h"
#include "commands/NumberRange.h"

namespace squat::commands {

void addSignalOptions(CLI::App& command, SignalOptions& options) {
  auto& file = options.file;
  command
      .add_option("--column", file.column,
                  "Column of the signal, by name or number; several separated by commas, or all")
      ->type_name("NAME");
  command.add_option("--time-column", file.timeColumn, "Column of the time (default: found by its header)")
      ->type_name("NAME");
  command.add_option("--position-column", file.positionColumn, "Column of the position")->type_name("NAME");
  command.add_option("--speed-column", file.speedColumn, "Column of the speed")->type_name("NAME");
  command.add_option("--run-column", file.runColumn, "Column that numbers repeated runs")->type_name("NAME");
  command
      .add_option("--unit", options.units,
                  "Unit of a column where the file states none or a wrong one: aba=g, speed=km/h; g: of all "
                  "signals without one; may be repeated")
      ->allow_extra_args(false)
      ->type_name("COLUMN=UNIT");
  command
      .add_option("--time-unit", file.timeUnit, "Unit of the time: s, ms, us, ns or min (default: as the file states)")
      ->type_name("UNIT");
  command.add_option("--head-line", file.headLine, "Line of the heading in a text file (default: found)")
      ->check(between(1.0, 1e6))
      ->type_name("LINE");
  command
      .add_option("--object", file.object, "Part of a file: path in HDF5, group of TDMS, session or source of RCM-DX")
      ->type_name("PATH");
  command.add_option("--rate", file.rate, "Sampling rate, if the file has no time column")
      ->check(between(1.0, 1e8))
      ->type_name("HZ");
  command.add_option("--speed", options.speed, "Speed, if the file has none: 30, \"30 m/s\" or \"108 km/h\"")
      ->type_name("SPEED");
  command
      .add_option("--delimiter", options.delimiter,
                  "Column separator: auto, comma, semicolon, tab, space or one character")
      ->type_name("SIGN");
  command.add_flag("--decimal-comma", options.decimalComma, "Numbers have a decimal comma");
}

std::string recordFile(const std::string& nameOrPath) {
  if (std::filesystem::exists(nameOrPath) || nameOrPath.find('/') != std::string::npos) return nameOrPath;
  const auto shipped = cases::resourcesFolder() / "records" / (nameOrPath + ".csv");
  return std::filesystem::exists(shipped) ? shipped.string() : nameOrPath;
}

readers::SignalFileOptions fileOptions(const SignalOptions& options) {
  auto file = options.file;
  if (!options.speed.empty()) file.speed = analysis::speedFromText(options.speed);
  for (const auto& text : options.units)
    if (text.find('=') == std::string::npos)
      file.signalUnit = text;
    else
      file.units.push_back(analysis::columnUnitFromText(text));
  file.delimiter = analysis::delimiterFromText(options.delimiter);
  if (options.decimalComma) file.decimal = ',';
  return file;
}

}  // namespace squat::commands
