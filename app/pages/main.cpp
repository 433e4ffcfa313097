// squat_pages DIR PROGRAM... - man pages and shell completion of the programs, from what they print for --help, into
// DIR/man1 and DIR/completions; the pages of the manual about commands and parameters into DIR/manual.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include "core/DurableFile.h"
#include "core/ProgramVersion.h"
#include "pages/CommandPage.h"
#include "pages/Completion.h"
#include "pages/ManualPage.h"
#include "pages/ParameterPage.h"
#include "pages/Program.h"

namespace {

using Calls = std::vector<std::pair<std::string, squat::pages::HelpText>>;

// The program's page names its commands; theirs name the program and the commands of their own.
std::vector<std::string> othersOf(const Calls& calls, const std::string& call) {
  std::vector<std::string> others;
  for (const auto& [other, help] : calls)
    if (other != call && (other.starts_with(call + " ") || call.starts_with(other + " "))) others.push_back(other);
  return others;
}

void writePages(const std::string& folder, const Calls& calls) {
  const auto version = std::string("Squat Studio ") + squat::programVersion();
  for (const auto& [call, help] : calls)
    squat::writeDurably(folder + "/man1/" + squat::pages::pageName(call) + ".1",
                        squat::pages::manualPage({call, help, othersOf(calls, call)}, version));
  squat::writeDurably(folder + "/completions/" + calls.front().first, squat::pages::completion(calls));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: squat_pages DIR PROGRAM...\n");
    return 2;
  }
  try {
    const std::string folder = argv[1];
    for (const char* part : {"/man1", "/completions", "/manual"}) squat::makeFolder(folder + part);
    Calls all;
    for (int i = 2; i < argc; ++i) {
      const auto calls = squat::pages::callsOf(argv[i]);
      writePages(folder, calls);
      all.insert(all.end(), calls.begin(), calls.end());
    }
    squat::writeDurably(folder + "/manual/commands.md", squat::pages::commandPage(all));
    squat::writeDurably(folder + "/manual/parameters.md", squat::pages::parameterPage());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "squat_pages: %s\n", error.what());
    return 1;
  }
  return 0;
}
