// Every command line of README and manual, typed by a reader in an empty folder with the programs on the PATH, on the
// mesh `tiny`: a shim in front of each program swaps the mesh, and lets the studio draw its window into a picture.
#include <gmock/gmock.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "app/FilesPage.h"
#include "arch/Page.h"
#include "core/DurableFile.h"
#include "results/SampleResult.h"

namespace squat {
namespace {

using tests::TemporaryFolder;

constexpr const char* kSquat = R"(#!/usr/bin/env bash
words=() meshed=
for word in "$@"; do
  [[ $previous == --mesh ]] && word=tiny
  [[ $word == --mesh ]] && meshed=yes
  words+=("$word") previous=$word
done
case "$1" in run | warm | study | validate | receptance | figures | describe) [[ $meshed ]] || words+=(--mesh tiny) ;; esac
[[ $1 == estimate ]] && words+=(--runs 20 --longest 20)
[[ $1 == calibrate ]] && words+=(--confirm tiny --evaluations 10)
exec "PROGRAM" "${words[@]}"
)";
constexpr const char* kStudio = R"(#!/usr/bin/env bash
QT_QPA_PLATFORM=offscreen exec "PROGRAM" "$@" --screenshot studio.png
)";

void writeShim(const std::string& path, std::string text, const std::string& program) {
  text.replace(text.find("PROGRAM"), 7, program);
  writeDurably(path, std::string_view(text));
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
}

bool beginsWith(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

bool isForTheSourceFolder(const std::string& line) {
  for (const char* word : {"./bootstrap", ".ci/", "ctest ", "cmake ", "export PATH="})
    if (beginsWith(line, word)) return true;
  return false;
}

// Names in capitals stand for something: such a line is no command as it is typed.
bool hasPlaceholder(const std::string& line) {
  static const std::regex capitals(R"((^|[\s/])[A-Z]{3,}(\.\w+|/|\s|$))");
  return std::regex_search(line, capitals);
}

bool isCommand(const arch::PageCode& code) {
  if (hasPlaceholder(code.text)) return false;
  const bool calls = beginsWith(code.text, "squat ") || beginsWith(code.text, "squat-studio");
  return code.isBlock ? calls || beginsWith(code.text, "printf ") : calls && code.text.find(' ') != std::string::npos;
}

void makeShims(const TemporaryFolder& folder) {
  std::filesystem::create_directories(folder / "programs");
  std::filesystem::create_directories(folder / "empty");
  writeShim(folder / "programs/squat", kSquat, SQUAT_PROGRAM);
  writeShim(folder / "programs/squat-studio", kStudio, SQUAT_STUDIO);
}

enum class Lines { all, ofFirstCase };

// Types the commands of a page one by one; how many there are.
int typeAll(const std::string& page, const TemporaryFolder& folder, Lines lines = Lines::all) {
  int typed = 0;
  for (const auto& code : arch::codeOf(page)) {
    if (!isCommand(code) || (lines == Lines::ofFirstCase && (!code.isBlock || beginsWith(code.text, "squat-studio "))))
      continue;
    ++typed;
    writeDurably(folder / "line", std::string_view(code.text + "\n"));
    const auto start = std::chrono::steady_clock::now();
    const auto call = "cd '" + (folder / "empty") + "' && PATH='" + (folder / "programs") + "':\"$PATH\" bash '" +
                      (folder / "line") + "' > '" + (folder / "output") + "' 2>&1";
    const int status = std::system(call.c_str());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::printf("%4d %6.1f s  %s\n", code.line, took.count(), code.text.c_str());
    std::fflush(stdout);
    EXPECT_EQ(status, 0) << page << ":" << code.line << ": " << code.text << "\n"
                         << readWholeFile(folder / "output", 1000000);
  }
  return typed;
}

// What a newcomer types first: the README's blocks. Its table of commands, and the studio on a result of theirs, are
// among the slow ones.
TEST(Typed, TheFirstCaseOfTheReadmeWorksInAnEmptyFolder) {
  const TemporaryFolder folder;
  makeShims(folder);
  EXPECT_GE(typeAll(SQUAT_SOURCE_DIR "/README.md", folder, Lines::ofFirstCase), 4);
}

// The README first; the manual's pages go on in its folder, where its results stand. Among them are results of elastic
// and yielding rails and tables of every command: the page of files must know each file, dataset and column, and
// describe none that there is not.
TEST(Typed, EveryCommandWorksInAnEmptyFolder) {
  const TemporaryFolder folder;
  makeShims(folder);
  int typed = 0;
  for (const auto& page : arch::pagesOf(SQUAT_SOURCE_DIR)) typed += typeAll(page, folder);
  EXPECT_GT(typed, 18);
  FilesPage page(SQUAT_SOURCE_DIR "/resources/manual/files.md");
  EXPECT_THAT(page.notSaid(folder / "empty"), ::testing::IsEmpty());
  for (const auto& name : page.notSeen())  // axes of which a file has one; the commit of a build from an archive
    EXPECT_TRUE(name.ends_with(": position") || name.ends_with(": time") || name == "/: commit" ||
                name.find(".json: ") != std::string::npos)  // keys of what there may be: FilesPageTest
        << name;
}

// What `describe` warns of in the case that a page writes and runs, on the mesh that is the default.
std::string warningsOfTheCaseOf(const std::string& page) {
  const TemporaryFolder folder;
  int described = 0;
  for (const auto& code : arch::codeOf(page)) {
    if (!code.isBlock) continue;
    const bool writes = beginsWith(code.text, "printf ");
    const bool runs = beginsWith(code.text, "squat run ") && code.text.find(".toml") != std::string::npos;
    if (!writes && !runs) continue;
    std::string words = code.text;
    if (runs) {
      std::istringstream typed(code.text);
      for (int i = 0; i < 3; ++i) typed >> words;  // squat run CASE
      words = "'" SQUAT_PROGRAM "' describe " + words + " 2>> said > /dev/null";
      ++described;
    }
    EXPECT_EQ(std::system(("cd '" + folder.path() + "' && " + words).c_str()), 0) << page << ": " << code.text;
  }
  EXPECT_EQ(described, 1) << page;
  return readWholeFile(folder / "said", 1000000);
}

TEST(TypedReadme, FirstCasesBringNoWarning) {
  for (const char* page : {"/README.md", "/resources/manual/tutorials.md"})
    EXPECT_EQ(warningsOfTheCaseOf(std::string(SQUAT_SOURCE_DIR) + page), "") << page;
}

// Nothing in a block of the README is passed over: what is not typed here is for the source folder.
TEST(TypedReadme, HasNoOtherLines) {
  int commands = 0;
  for (const auto& code : arch::codeOf(SQUAT_SOURCE_DIR "/README.md")) {
    const bool typed = isCommand(code);
    if (typed) ++commands;
    EXPECT_TRUE(typed || !code.isBlock || isForTheSourceFolder(code.text)) << code.text;
    EXPECT_TRUE(typed || !beginsWith(code.text, "squat ")) << code.text;
  }
  EXPECT_GE(commands, 14);  // a first case, nine commands of the table, the studio
}

}  // namespace
}  // namespace squat
