#include <cstdio>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/FigureNames.h"
#include "commands/FigureOutput.h"
#include "commands/ResultToRead.h"
#include "core/DurableFile.h"

namespace squat::commands {

namespace {

struct RenderOptions {
  std::string result, folder = ".";
  NamedFigures figures;
};

int render(const RenderOptions& options) {
  checkFigureNames(options.figures);
  const auto result = resultToRead(options.result);
  makeFolder(options.folder);
  const auto output = writeFigures(result, options.folder, options.figures);
  for (const auto& message : output.messages) std::fprintf(stderr, "%s\n", message.c_str());
  for (const auto& file : output.files) std::printf("%s\n", file.c_str());
  return kDone;
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("render", "Draw the figures of a result file");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("result", options->result, "Result file")->required()->type_name("RESULT.h5");
  command->add_option("-o,--output", options->folder, "Folder for the figures (default: current folder)")
      ->type_name("DIR");
  addFigureNames(*command, options->figures);
  command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace squat::commands
