#include "commands/Program.h"

#include <signal.h>

#include <cstdio>
#include <exception>
#include <new>

#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "core/Errors.h"

namespace squat::commands {

namespace {

int told(const char* kind, const std::exception& error, int code) {
  std::fprintf(stderr, "squat: %s: %s\n", kind, error.what());
  return code;
}

int act(const Action& action) {
  try {
    return action();
  } catch (const CaseError& error) {
    return told("the case is wrong", error, kCaseWrong);
  } catch (const RunError& error) {
    return told("the run failed", error, kRunFailed);
  } catch (const FileError& error) {
    return told("a file is wrong", error, kFileWrong);
  } catch (const std::bad_alloc& error) {
    return told("the run failed: not enough memory; choose a coarser mesh (--mesh draft)", error, kRunFailed);
  } catch (const std::exception& error) {
    return told("the run failed", error, kRunFailed);
  }
}

}  // namespace

int runProgram(int argc, char** argv) {
  ::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of size is an error of writing, not the end of the program
  ::signal(SIGPIPE, SIG_DFL);
  CLI::App program("Rolls a wheel over a rail-head defect and shows what the axle box feels.", "squat");
  program.set_version_flag("--version", "squat " SQUAT_VERSION);
  program.require_subcommand(1);
  program.failure_message(CLI::FailureMessage::help);
  Action action;
  addRunCommand(program, action);
  addRenderCommand(program, action);
  addDescribeCommand(program, action);
  addFiguresCommand(program, action);
  addAnalyseCommand(program, action);
  addCompareCommand(program, action);
  addStudyCommand(program, action);
  addReceptanceCommand(program, action);
  addValidateCommand(program, action);
  program.footer(
      "Exit codes: 0 done, 2 the case or the call is wrong, 3 the run failed, 4 a file is wrong, 130 cancelled");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "squat: the call is wrong: %s\nTry squat --help\n", error.what());
    return kCaseWrong;
  }
  return act(action);
}

}  // namespace squat::commands
