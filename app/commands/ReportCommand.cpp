#include <cstdio>
#include <filesystem>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/FigureNames.h"
#include "commands/FigureOutput.h"
#include "commands/ReportOutput.h"
#include "commands/SignalOptions.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "project/ProjectFile.h"
#include "project/Report.h"
#include "results/ResultFile.h"

namespace squat::commands {

namespace {

constexpr const char* kProjectEnding = ".squat-project";
constexpr std::size_t kLongestNotes = std::size_t{1} << 20;

struct ReportOptions {
  std::vector<std::string> files, measured;
  std::string output, title, notes;
  SignalOptions signal;
  ReportChoice choice;
};

std::string stemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

// The first result is shown and compared with, the others are laid over it.
project::Report reportOfResults(const std::vector<std::string>& files) {
  project::Report report;
  for (const auto& file : files) {
    const auto content =
        report.signals.empty() ? results::ResultContent::everything : results::ResultContent::withoutFields;
    const auto result = std::make_shared<results::RunResult>(results::readResult(file, content));
    report.signals.push_back({stemOf(file), file, result, result, {}, true});
  }
  report.shown = report.reference = 0;
  return report;
}

// They are laid where they match the run, as in the studio. The first one becomes the reference, unless a measured
// signal is it already.
void addMeasured(const ReportOptions& options, project::Report& report, std::vector<std::string>& notes) {
  if (options.measured.empty()) return;
  if (report.shown < 0)
    throw CaseError({{"--measured", options.measured[0], "a run to lay it over", "Show a run in the project"}});
  const auto shown = report.signals.at(static_cast<std::size_t>(report.shown));
  const auto reading = fileOptions(options.signal);
  const double speed = reading.speed > 0 ? reading.speed : shown.result->speed;
  bool hasReference = report.reference >= 0 && !report.signals[static_cast<std::size_t>(report.reference)].result;
  for (const auto& file : options.measured) {
    const auto records = project::measuredRecords(file, speed, {reading}, shown.record.get());
    for (const auto& [record, used] : records) {
      if (!hasReference) report.reference = static_cast<int>(report.signals.size());
      hasReference = true;
      const std::string name = records.size() > 1 ? stemOf(file) + ": " + record->run : stemOf(file);
      for (const auto& note : record->notes) notes.push_back(name + ": " + note);
      report.signals.push_back({name, file, record, nullptr, used, true});
    }
  }
}

int makeReport(const ReportOptions& options) {
  const auto& first = options.files.front();
  const bool isProject = first.ends_with(kProjectEnding);
  if (isProject && options.files.size() > 1)
    throw CaseError({{"RESULT", options.files[1], "nothing beside a project", "Add the result to the project"}});
  checkFigureNames({options.choice.figures, {}});
  const std::string output = options.output.empty() ? stemOf(first) + ".pdf" : options.output;
  auto inputs = options.files;
  inputs.insert(inputs.end(), options.measured.begin(), options.measured.end());
  if (!options.notes.empty()) inputs.push_back(options.notes);
  keepInputs(inputs, {output});
  std::vector<std::string> notes;
  auto content = isProject ? project::reportOf(project::readProject(first), notes) : reportOfResults(options.files);
  content.title = options.title.empty() ? stemOf(first) : options.title;
  if (!options.notes.empty()) content.notes = readWholeFile(options.notes, kLongestNotes);
  addMeasured(options, content, notes);
  if (const auto folder = std::filesystem::path(output).parent_path(); !folder.empty()) makeFolder(folder.string());
  for (const auto& problem : writeReport(content, options.choice, output)) notes.push_back(problem);
  for (const auto& note : notes) std::fprintf(stderr, "note: %s\n", note.c_str());
  std::printf("%s\n", output.c_str());
  return kDone;
}

}  // namespace

void addReportCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "report", "Write a PDF with the case, figures, comparison and notes of results or of a project");
  auto options = std::make_shared<ReportOptions>();
  command
      ->add_option("result", options->files, "Result files, the first one in the figures; or one project of the studio")
      ->required()
      ->type_name("RESULT.h5...");
  command->add_option("--measured", options->measured, "CSV, HDF5 or MATLAB files, laid over the run")
      ->type_name("FILE");
  command->add_option("-o,--output", options->output, "File for the report (default: RESULT.pdf)")
      ->type_name("FILE.pdf");
  command->add_option("--title", options->title, "Title (default: name of the first file)")->type_name("TEXT");
  command->add_option("--notes", options->notes, "Text file with notes (default: those of the project)")
      ->type_name("FILE");
  addList(*command, "--figures", options->choice.figures,
          "Figures, separated by commas (default: all that the run has)")
      ->type_name("NAME,...");
  command->add_option("--colours", options->choice.colours, "Colours of maps (default: viridis)")
      ->check(CLI::IsMember({"viridis", "cividis", "jet"}))
      ->type_name("NAME");
  command->add_option("--page", options->choice.page, "Page (default: a4)")
      ->check(CLI::IsMember({"a4", "letter"}))
      ->type_name("SIZE");
  addSignalOptions(*command, options->signal);
  if (const auto list = figureList(); !list.empty()) command->footer("Figures:\n" + list);
  command->callback([options, &action] { action = [options] { return makeReport(*options); }; });
}

}  // namespace squat::commands
