// README and manual: as short as promised, and every test and script that they name is there. Links: tests/pages.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>

#include "arch/Page.h"
#include "arch/SourceTree.h"

namespace squat::arch {
namespace {

using ::testing::IsEmpty;

const std::string kTop = SQUAT_SOURCE_DIR;

const std::vector<std::string>& names() {
  static const auto all = testNames(kTop);
  return all;
}

// As `ctest -R`: an expression that is found somewhere in a name.
bool isATest(const std::string& expression) {
  const std::regex pattern(expression);
  return std::any_of(names().begin(), names().end(),
                     [&](const std::string& name) { return std::regex_search(name, pattern); });
}

// 'a|b' and a|b as {"a", "b"}: each of them must be there, not only one.
std::vector<std::string> alternatives(const std::string& expression) {
  std::vector<std::string> parts{""};
  for (const char c : expression) {
    if (c == '|') parts.emplace_back();
    if (c != '|' && c != '\'') parts.back() += c;
  }
  return parts;
}

std::size_t signsOf(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

TEST(Readme, HasAtMost100LinesOf120Characters) {
  const auto lines = linesOf(kTop + "/README.md");
  EXPECT_LE(lines.size(), 100U);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_LE(signsOf(lines[i]), 120U) << "line " << i + 1;
}

TEST(Readme, SaysWhereTheProgramsAre) {
  bool said = false;
  for (const auto& code : codeOf(kTop + "/README.md"))
    said = said || (code.isBlock && code.text == R"(export PATH="$PWD/build/release/bin:$PATH")");
  EXPECT_TRUE(said);
}

TEST(Pages, EveryTestOfTheVerificationTableIsThere) {
  static const std::regex span("`([^`]+)`");
  std::vector<std::string> missing;
  int rows = 0;
  auto lines = linesOf(kTop + "/resources/manual/verification.md");
  for (const auto& line : linesOf(kTop + "/resources/manual/measurements.md"))
    if (line.ends_with("` |")) lines.push_back(line);  // rows that end with a test
  for (const auto& line : lines) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| what", 0) == 0) continue;
    const auto cell = line.rfind("| ", line.size() - 3);  // the last one names the tests
    const std::string tests = line.substr(cell);
    int inRow = 0;
    for (std::sregex_iterator found(tests.begin(), tests.end(), span), end; found != end; ++found, ++inRow)
      if (!isATest(found->str(1))) missing.push_back(found->str(1));
    if (inRow == 0) missing.push_back("a test for: " + line);
    ++rows;
  }
  EXPECT_THAT(missing, IsEmpty());
  EXPECT_GT(rows, 30);
}

// Every name in the code of the solver.
std::set<std::string> solverNames() {
  std::set<std::string> names;
  for (const auto& file : readSources(kTop, {"solver"})) {
    std::string name;
    for (const char c : file.code + " ") {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
        name += c;
      } else if (!name.empty()) {
        names.insert(name);
        name.clear();
      }
    }
  }
  return names;
}

// Each row of the page's tables: what, equation, source, and the functions that compute it, which the solver has.
TEST(Pages, EveryEquationHasASourceAndAFunction) {
  static const std::regex row(R"(^\| (.+) \| (.+) \| (.+) \| (.+) \|$)"), name("`(\\w+)`");
  const auto known = solverNames();
  int rows = 0;
  for (const auto& line : linesOf(kTop + "/resources/manual/theory.md")) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| what", 0) == 0) continue;
    ++rows;
    std::smatch cells;
    ASSERT_TRUE(std::regex_match(line, cells, row)) << line;
    const std::string functions = cells.str(4);
    int inRow = 0;
    for (std::sregex_iterator found(functions.begin(), functions.end(), name), end; found != end; ++found, ++inRow)
      EXPECT_EQ(known.count(found->str(1)), 1U) << found->str(1) << ": " << line;
    EXPECT_GT(inRow, 0) << line;
  }
  EXPECT_GT(rows, 35);
}

TEST(Pages, EveryExpressionForCtestFindsATest) {
  static const std::regex expression(R"(ctest .*-R ('[^']+'|\S+))");
  std::vector<std::string> missing;
  int seen = 0;
  for (const auto& page : pagesOf(kTop))
    for (const auto& code : codeOf(page)) {
      std::smatch found;
      if (!std::regex_search(code.text, found, expression)) continue;
      ++seen;
      EXPECT_EQ(code.text.rfind("ctest --test-dir build/release -R ", 0), 0U) << page << ": " << code.text;
      for (const auto& part : alternatives(found.str(1)))
        if (!isATest(part)) missing.push_back(page + ": " + part);
    }
  EXPECT_THAT(missing, IsEmpty());
  EXPECT_GT(seen, 15);
}

// Scripts that are to be called in the source folder; presets.
TEST(Pages, ScriptsAreThere) {
  static const std::regex script(R"((^|\s)(\./bootstrap|\.ci/\w+))"), command(R"(\./bootstrap (\w+))");
  std::string bootstrap;
  for (const auto& line : linesOf(kTop + "/bootstrap")) bootstrap += line + "\n";
  for (const auto& page : pagesOf(kTop))
    for (const auto& code : codeOf(page)) {
      std::smatch found;
      if (std::regex_search(code.text, found, script)) {
        EXPECT_TRUE(std::filesystem::exists(kTop + "/" + found.str(2))) << page << ": " << code.text;
      }
      if (std::regex_search(code.text, found, command)) {
        EXPECT_NE(bootstrap.find("\n  " + found.str(1) + ")\n"), std::string::npos) << page << ": " << code.text;
      }
    }
}

std::string valueOf(const std::string& file, const std::string& pattern) {
  std::smatch found;
  for (const auto& line : linesOf(kTop + "/" + file))
    if (std::regex_search(line, found, std::regex(pattern))) return found.str(1);
  return "nothing like " + pattern + " in " + file;
}

TEST(Citation, HasTheVersionOfTheProgramAndItsLicence) {
  EXPECT_EQ(valueOf("CITATION.cff", "^version: (\\S+)"), valueOf("CMakeLists.txt", R"(project\(\w+ VERSION (\S+))"));
  EXPECT_EQ(valueOf("CITATION.cff", "^title: (.+)"), "Squat Studio");
  EXPECT_EQ(valueOf("CITATION.cff", "^license: (\\S+)"), "GPL-3.0-or-later");
}

// The reference file names the paper that the citation names.
TEST(Citation, NamesThePaper) {
  const auto source = valueOf("resources/reference/paper.json", "\"source\": \"([^\"]+)\"");
  EXPECT_NE(source.find(valueOf("CITATION.cff", "^      (Validation of .+)")), std::string::npos) << source;
  EXPECT_NE(source.find(valueOf("CITATION.cff", "journal: (.+)")), std::string::npos) << source;
}

}  // namespace
}  // namespace squat::arch
