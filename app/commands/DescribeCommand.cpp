#include <cstdio>

#include "case/CaseFile.h"
#include "case/CaseText.h"
#include "case/ParameterTable.h"
#include "case/Validation.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ExitCodes.h"

namespace squat::commands {

namespace {

struct DescribeOptions {
  CaseOptions caseOptions;
  bool json = false, defaults = false;  // defaults: no case is named
};

int describe(const DescribeOptions& options) {
  const auto description = options.defaults ? cases::parseCase("", "defaults", {}, caseOverrides(options.caseOptions))
                                            : readCase(options.caseOptions);
  cases::SetKeys set;
  for (const auto& [key, value] : caseOverrides(options.caseOptions).values) set.push_back(key);
  const auto text = options.json ? cases::describeJson(description, set) : cases::describeTable(description, set);
  for (const auto& warning : cases::validate(description).warnings)
    std::fprintf(stderr, "warning: %s\n", toWarning(warning).c_str());
  std::fputs(text.c_str(), stdout);
  if (text.empty() || text.back() != '\n') std::fputc('\n', stdout);
  return kDone;
}

}  // namespace

void addDescribeCommand(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("describe", "Print every parameter of a case with its unit, range, default and source");
  auto options = std::make_shared<DescribeOptions>();
  addCaseOptions(*command, options->caseOptions);
  command->get_option("case")->required(false);
  command->add_flag("--json", options->json, "Print JSON, for scripts");
  command->callback([options, command, &action] {
    options->defaults = command->count("case") == 0;
    action = [options] { return describe(*options); };
  });
}

}  // namespace squat::commands
