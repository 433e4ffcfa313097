#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/FigureNames.h"
#include "commands/FigureOutput.h"
#include "commands/OutputFolder.h"
#include "commands/ReportOutput.h"
#include "commands/SignalOptions.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "project/ProjectFile.h"
#include "project/Report.h"

namespace squat::commands {

namespace {

constexpr const char* kProjectEnding = ".squat-project";

struct ReportOptions {
  std::vector<std::string> files, measured;
  std::string output, title, notes;
  SignalOptions signal;
  ReportChoice choice;
};

std::string textOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw FileError(path, "", "cannot be read", "Check the path, or leave --notes out");
  return text.str();
}

// The first result is shown, the others are laid over it.
project::Project projectOf(const ReportOptions& options) {
  project::Project project;
  for (const auto& file : options.files) {
    project::Entry entry;
    entry.path = file;
    entry.name = std::filesystem::path(file).stem().string();
    entry.overlaid = true;
    project.entries.push_back(entry);
  }
  project.current = 0;
  return project;
}

// Their largest value is laid where that of the run is, as in the studio.
void addMeasured(const ReportOptions& options, project::Report& report) {
  if (options.measured.empty()) return;
  const auto& shown = report.signals.at(static_cast<std::size_t>(report.shown));
  const auto reading = fileOptions(options.signal);
  const double speed = reading.speed > 0 ? reading.speed : shown.result->speed;
  for (const auto& file : options.measured) {
    const auto records = project::measuredRecords(file, speed, {reading, project::impactOf(shown.record.get())});
    for (const auto& measured : records) {
      const std::string stem = std::filesystem::path(file).stem().string();
      if (report.reference < 0 || report.signals[static_cast<std::size_t>(report.reference)].result)
        report.reference = static_cast<int>(report.signals.size());
      report.signals.push_back({records.size() > 1 ? stem + ": " + measured.record->run : stem, file, measured.record,
                                nullptr, measured.reading, true});
    }
  }
}

int report(const ReportOptions& options) {
  const auto& first = options.files.front();
  const bool isProject = first.ends_with(kProjectEnding);
  if (isProject && options.files.size() > 1)
    throw CaseError({{"RESULT", options.files[1], "nothing beside a project", "Add the result to the project"}});
  checkFigureNames(options.choice.figures, {});
  auto project = isProject ? project::readProject(first) : projectOf(options);
  if (!options.notes.empty()) project.notes = textOf(options.notes);
  std::vector<std::string> problems;
  const std::string stem = std::filesystem::path(first).stem().string();
  auto content = project::reportOf(project, options.title.empty() ? stem : options.title, problems);
  // A project may have lost a file; a file that was named must be there.
  if (!isProject && !problems.empty()) throw FileError(first, "", problems.front());
  if (content.shown < 0 && !options.measured.empty())
    throw CaseError({{"--measured", options.measured[0], "a run to lay it over", "Show a run in the project"}});
  addMeasured(options, content);
  const std::string output = options.output.empty() ? stem + ".pdf" : options.output;
  if (const auto folder = std::filesystem::path(output).parent_path(); !folder.empty()) makeFolder(folder.string());
  for (const auto& problem : writeReport(content, options.choice, output)) problems.push_back(problem);
  for (const auto& problem : problems) std::fprintf(stderr, "note: %s\n", problem.c_str());
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
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace squat::commands
