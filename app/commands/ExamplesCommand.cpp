#include <cstdio>
#include <optional>

#include "case/CaseDescription.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/Interrupt.h"
#include "commands/OutputFolder.h"
#include "commands/TerminalMonitor.h"
#include "core/DurableFile.h"
#include "detection/MakeExamples.h"
#include "studies/Jobs.h"

namespace squat::commands {

namespace {

struct ExamplesOptions {
  CaseOptions caseOptions;
  std::string file = "examples.csv";
  detection::ExampleOptions examples;
  int jobs = 0;
};

int examples(const ExamplesOptions& options) {
  const auto description = readCase(options.caseOptions);
  auto examples = options.examples;
  examples.jobs = options.jobs > 0 ? options.jobs : studies::coresHere();
  keepInputs(cases::filesOfCase(options.caseOptions.name, description), {options.file});
  std::optional<OutputFolder> folder;
  if (!examples.passages.empty()) folder.emplace(examples.passages);
  const InterruptGuard interrupt;
  TerminalMonitor monitor(stderr);
  const auto made = detection::makeExamples(description, examples, monitor);
  monitor.clearLine();
  if (!made) {
    std::fprintf(stderr, "cancelled: no file written\n");
    return kCancelled;
  }
  writeDurably(options.file, detection::examplesText(*made));
  std::printf("%zu passages over known defects\nwritten: %s\n", made->size(), options.file.c_str());
  return kDone;
}

}  // namespace

void addExamplesCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "examples", "Compute passages over known squats and other irregularities, from which squat detect takes kinds");
  auto options = std::make_shared<ExamplesOptions>();
  addCaseOptions(*command, options->caseOptions);
  command->add_option("-o,--output", options->file, "Table of the examples (default: examples.csv)")->type_name("FILE");
  command->add_option("--squats", options->examples.squats, "Passages over squats (default: 45)")
      ->check(CLI::Range(3, 10000))
      ->type_name("N");
  command
      ->add_option("--others", options->examples.others,
                   "Passages over joints, welds, crossings, corrugation (default: 16)")
      ->check(CLI::Range(0, 10000))
      ->type_name("N");
  command->add_option("--flats", options->examples.flats, "Passages of wheels with a flat (default: 4)")
      ->check(CLI::Range(0, 10000))
      ->type_name("N");
  command->add_option("--seed", options->examples.seed, "Another choice of defects (default: 1)")->type_name("N");
  command->add_option("--jobs", options->jobs, "Parallel runs (default: all cores)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  command->add_option("--passages", options->examples.passages, "Keep the signal of each passage in this folder")
      ->type_name("DIR");
  addInstructionSet(*command, options->examples.isa);
  command->callback([options, &action] { action = [options] { return examples(*options); }; });
}

}  // namespace squat::commands
