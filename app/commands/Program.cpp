#include "commands/Program.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "case/ParameterTable.h"
#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "core/platform/Signals.h"
#include "core/platform/Terminal.h"

namespace squat::commands {

namespace {

int reported(const char* kind, const std::exception& error, int code) {
  std::fprintf(stderr, "squat: %s: %s\n", kind, error.what());
  return code;
}

// Errors of the call are CaseErrors as well: their keys are options.
const char* kindOf(const CaseError& error) {
  const auto isOption = [](const CaseProblem& problem) { return problem.key.starts_with('-'); };
  const auto& all = error.problems();
  return std::all_of(all.begin(), all.end(), isOption) ? "invalid option" : "invalid case";
}

// What to do where the memory is too small depends on what was called.
const char* memoryAdvice(const CLI::App& program) {
  for (const char* name : {"analyse", "compare"})
    if (program.got_subcommand(name)) return "run failed: out of memory; shorten the record or read fewer columns";
  if (program.got_subcommand("render")) return "run failed: out of memory; draw fewer figures per call";
  return "run failed: out of memory; use a coarser mesh (--mesh draft)";
}

int act(const Action& action, const CLI::App& program) {
  try {
    return action();
  } catch (const CaseError& error) {
    return reported(kindOf(error), error, kCaseWrong);
  } catch (const RunError& error) {
    return reported("run failed", error, kRunFailed);
  } catch (const FileError& error) {
    return reported("invalid file", error, kFileWrong);
  } catch (const std::bad_alloc& error) {
    return reported(memoryAdvice(program), error, kRunFailed);
  } catch (const std::exception& error) {
    return reported("run failed", error, kRunFailed);
  }
}

// A table that a full disk cut short must not pass for a complete one.
int withOutputWritten(int code) {
  errno = 0;
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!failed) return code;
  std::fprintf(stderr, "squat: cannot write the complete output%s%s\n", errno != 0 ? ": " : "",
               errno != 0 ? std::strerror(errno) : "");
  return code == kDone ? kFileWrong : code;
}

// The words of the call; "help [command]" stands for "[command] --help".
std::vector<std::string> wordsOf(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  words.push_back("--help");
  return words;
}

// The message for an unknown command, with the nearest one; empty where all are known.
std::string unknownCommand(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* level = &program;
  for (const auto& word : words) {
    const auto commands = level->get_subcommands([](const CLI::App*) { return true; });
    if (commands.empty() || word.empty() || word.front() == '-') return {};
    const CLI::App* nearest = nullptr;
    int smallest = 2 + static_cast<int>(word.size()) / 4;  // farther than that is another word
    std::string names;
    for (const auto* command : commands) {
      const int distance = cases::editDistance(word, command->get_name());
      if (distance < smallest) nearest = command, smallest = distance;
      names += (names.empty() ? "" : ", ") + command->get_name();
    }
    if (smallest > 0 || !nearest)
      return "unknown command '" + word + "'; " +
             (nearest ? "did you mean " + nearest->get_name() + "?" : "choose one of " + names);
    level = nearest;
  }
  return {};
}

}  // namespace

int runProgram(int argc, char** argv) {
  platform::ignoreFileSizeSignal();
  platform::endWhereAPipeIsClosed();
  platform::keepStandardStreamsOpen();
  CLI::App program("Rolls a wheel over a rail-head defect and computes the axle box acceleration.", "squat");
  program.set_version_flag("--version", "squat " + programVersionText());
  program.require_subcommand(1);
  program.failure_message(CLI::FailureMessage::help);
  Action action;
  addRunCommand(program, action);
  addWarmCommand(program, action);
  addRenderCommand(program, action);
  addReportCommand(program, action);
  addExportCommand(program, action);
  addDescribeCommand(program, action);
  addFiguresCommand(program, action);
  addAnalyseCommand(program, action);
  addCalibrateCommand(program, action);
  addEstimateCommand(program, action);
  addCompareCommand(program, action);
  addStudyCommand(program, action);
  addDetectCommand(program, action);
  addExamplesCommand(program, action);
  addGrowCommand(program, action);
  addInspectCommand(program, action);
  addReceptanceCommand(program, action);
  addValidateCommand(program, action);
  program.footer("Exit codes: 0 success, 2 invalid case or call, 3 run failed, 4 invalid file, 130 cancelled");
  auto words = wordsOf(argc, argv);
  if (const auto unknown = unknownCommand(program, words); !unknown.empty()) {
    std::fprintf(stderr, "squat: invalid call: %s\nTry squat --help\n", unknown.c_str());
    return kCaseWrong;
  }
  std::reverse(words.begin(), words.end());  // as the parser takes them
  try {
    program.parse(words);
  } catch (const CLI::Success& success) {  // --help, --version
    return withOutputWritten(program.exit(success));
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "squat: invalid call: %s\nTry squat --help\n", error.what());
    return kCaseWrong;
  }
  return withOutputWritten(act(action, program));
}

}  // namespace squat::commands
