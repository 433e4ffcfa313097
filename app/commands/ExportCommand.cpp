#include <cstdio>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/ResultToRead.h"
#include "commands/VtkOutput.h"

namespace squat::commands {

namespace {

struct ExportOptions {
  std::string result, folder = ".";
};

int exportResult(const ExportOptions& options) {
  for (const auto& path : writeVtkFiles(resultToRead(options.result), options.folder))
    std::printf("%s\n", path.c_str());
  return kDone;
}

}  // namespace

void addExportCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("export", "Write the stored instants of a result for ParaView (.pvd, .vtu)");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("result", options->result, "Result file")->required()->type_name("RESULT.h5");
  command->add_option("-o,--output", options->folder, "Folder for the files (default: current folder)")
      ->type_name("DIR");
  command->callback([options, &action] { action = [options] { return exportResult(*options); }; });
}

}  // namespace squat::commands
