#include <cstdio>
#include <filesystem>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/ResultToRead.h"
#include "commands/VtkOutput.h"
#include "results/Hdf5.h"

namespace squat::commands {

namespace {

struct ExportOptions {
  std::string result, folder = ".";
};

// Without its values, which may be many.
bool isGrowth(const std::string& path) {
  results::Hdf5Limits limits;
  limits.valuesUpTo = 0;
  return results::textAttribute(results::readHdf5(path, limits).attributes, "schema") == growth::growthSchema;
}

std::vector<std::string> writeFiles(const ExportOptions& options) {
  if (!isGrowth(options.result)) return writeVtkFiles(resultToRead(options.result), options.folder);
  const auto stem = std::filesystem::path(options.result).stem().string();
  return writeVtkFiles(growth::readSurfaceSeries(options.result), stem, options.folder);
}

int exportResult(const ExportOptions& options) {
  for (const auto& path : writeFiles(options)) std::printf("%s\n", path.c_str());
  return kDone;
}

}  // namespace

void addExportCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "export", "Write the stored instants of a result, or the stages of a growth, for ParaView (.pvd, .vtu)");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("result", options->result, "Result file, or STEM-growth.h5")->required()->type_name("RESULT.h5");
  command->add_option("-o,--output", options->folder, "Folder for the files (default: current folder)")
      ->type_name("DIR");
  command->callback([options, &action] { action = [options] { return exportResult(*options); }; });
}

}  // namespace squat::commands
