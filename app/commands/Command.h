// app/commands/Command.h - each subcommand adds itself to the program and sets `action` where it was called.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace squat::commands {

using Action = std::function<int()>;  // returns the exit code; throws CaseError, RunError, FileError

void addAnalyseCommand(CLI::App& program, Action& action);
void addCalibrateCommand(CLI::App& program, Action& action);
void addCompareCommand(CLI::App& program, Action& action);
void addDescribeCommand(CLI::App& program, Action& action);
void addDetectCommand(CLI::App& program, Action& action);
void addEstimateCommand(CLI::App& program, Action& action);
void addExamplesCommand(CLI::App& program, Action& action);
void addExportCommand(CLI::App& program, Action& action);
void addFiguresCommand(CLI::App& program, Action& action);
void addGrowCommand(CLI::App& program, Action& action);
void addInspectCommand(CLI::App& program, Action& action);
void addReceptanceCommand(CLI::App& program, Action& action);
void addRenderCommand(CLI::App& program, Action& action);
void addReportCommand(CLI::App& program, Action& action);
void addRunCommand(CLI::App& program, Action& action);
void addStudyCommand(CLI::App& program, Action& action);
void addValidateCommand(CLI::App& program, Action& action);
void addWarmCommand(CLI::App& program, Action& action);

}  // namespace squat::commands
