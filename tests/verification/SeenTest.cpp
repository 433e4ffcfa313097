// What is stated is what tests assert: the judge of stated figures, and the pages beside the table of figures.
#include "verification/Seen.h"

#include <gmock/gmock.h>

#include <limits>
#include <map>
#include <regex>
#include <set>

#include "arch/Page.h"
#include "text/Text.h"

namespace squat::verification {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Stated, FailsAtOneAndAHalfTimesTheFigureAndSaysWhereItCouldBeBetter) {
  bool good = true;
  EXPECT_THAT(judgedAsStated(2.8, 1.8, Worse::larger, good), HasSubstr("1.8 is stated"));  // 2.7 is the limit
  EXPECT_FALSE(good);
  EXPECT_THAT(judgedAsStated(2.6, 1.8, Worse::larger, good), IsEmpty());
  EXPECT_FALSE(good);
  EXPECT_THAT(judgedAsStated(3, 2, Worse::larger, good), HasSubstr("2 is stated"));  // 1.5 times itself fails
  EXPECT_THAT(judgedAsStated(0, 0, Worse::larger, good), IsEmpty());
  EXPECT_THAT(judgedAsStated(1, 0, Worse::larger, good), HasSubstr("0 is stated"));
  EXPECT_THAT(judgedAsStated(1.1, 1.8, Worse::larger, good), IsEmpty());
  EXPECT_TRUE(good);
  EXPECT_THAT(judgedAsStated(40, 65, Worse::smaller, good), HasSubstr("65 is stated"));
  EXPECT_THAT(judgedAsStated(100, 65, Worse::smaller, good), IsEmpty());
  EXPECT_TRUE(good);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(judgedAsStated(none, 1.8, Worse::larger, good), HasSubstr("nan"));
}

// The worst figure of each quantity among the tests whose names begin so, the names of instances left out.
std::map<std::string, Stated> worstOfTests(const std::string& beginning) {
  std::map<std::string, Stated> worst;
  for (const auto& row : statedFigures()) {
    const auto name = row.test.substr(row.test.rfind('/', row.test.find('.')) + 1);
    if (name.rfind(beginning, 0) != 0) continue;
    const auto at = worst.try_emplace(row.quantity, row).first;
    if (std::stod(row.figure) > std::stod(at->second.figure)) at->second = row;
  }
  return worst;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t from = 1; from < line.size();) {
    const auto to = std::min(line.find('|', from), line.size());
    const auto cell = text::trimmed(std::string_view(line).substr(from, to - from));
    cells.emplace_back(cell);
    from = to + 1;
  }
  return cells;
}

TEST(Stated, FiguresOfTheReadmeAreThoseOfTheTable) {
  static const std::regex command("ctest --test-dir build/release -R ([A-Za-z.]+)`");
  int rows = 0;
  for (const auto& line : arch::linesOf(SQUAT_SOURCE_DIR "/README.md")) {
    std::smatch found;
    if (line.rfind("| ", 0) != 0 || !std::regex_search(line, found, command)) continue;
    const auto cell = cellsOf(line).at(2);
    const auto unit = cell.substr(cell.find(' ') + 1);
    std::string expected;
    for (const auto& [quantity, stated] : worstOfTests(found.str(1)))
      if (stated.unit == unit && (expected.empty() || std::stod(stated.figure) > std::stod(expected)))
        expected = stated.figure;
    EXPECT_EQ(cell, expected + " " + unit) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 8);
}

TEST(Stated, FiguresOfTheManualAreThoseOfTheTable) {
  static const std::regex span("`([^`]+)`");
  std::set<std::string> onThePage;
  auto lines = arch::linesOf(SQUAT_SOURCE_DIR "/resources/manual/verification.md");
  for (const auto& line : arch::linesOf(SQUAT_SOURCE_DIR "/resources/manual/measurements.md"))
    if (line.ends_with("` |")) lines.push_back(line);  // rows that end with a test
  for (const auto& line : lines) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| what", 0) == 0) continue;
    const auto cells = cellsOf(line);
    std::map<std::string, Stated> worst;
    for (std::sregex_iterator test(cells.at(5).begin(), cells.at(5).end(), span), end; test != end; ++test)
      for (const auto& [quantity, figure] : worstOfTests(test->str(1))) {
        const auto at = worst.try_emplace(quantity, figure).first;
        if (std::stod(figure.figure) > std::stod(at->second.figure)) at->second = figure;
      }
    std::string expected;
    for (const auto& [quantity, stated] : worst) {
      expected.append(expected.empty() ? "" : "; ").append(quantity + " " + stated.figure + " " + stated.unit);
      onThePage.insert(quantity + stated.unit);
    }
    const bool isStated = cells.at(3) == expected;  // without a figure: passed, or not run yet
    EXPECT_TRUE(isStated || (worst.empty() && cells.at(3).ends_with("passed"))) << line << "\nshould have " << expected;
  }
  for (const auto& row : statedFigures()) EXPECT_EQ(onThePage.count(row.quantity + row.unit), 1U) << row.test;
}

// A test that was renamed would no longer be held to its figure.
TEST(Stated, EveryFigureIsOfATestThatIsThere) {
  const auto names = arch::testNames(SQUAT_SOURCE_DIR);
  for (const auto& row : statedFigures()) {
    // Of an instance of a parameter the suite and the test, as the sources have them.
    auto name = row.test.substr(row.test.rfind('/', row.test.find('.')) + 1);
    name = name.substr(0, name.find('/'));
    EXPECT_THAT(names, ::testing::Contains(name)) << row.test;
  }
}

// Of the paper's statements: met and not met of each mesh that has a test.
TEST(Stated, PaperStatementsOfTheManualAreThoseOfTheTable) {
  const auto lines = arch::linesOf(SQUAT_SOURCE_DIR "/resources/manual/validation.md");
  for (const auto& [test, mesh] : {std::pair{"PaperStatements.Draft", "draft"}, {"PaperStatements.Tiny", "tiny"}}) {
    const int notMet = std::stoi(worstOfTests(test).at(std::string("statements on ") + mesh).figure);
    const auto row = "| `" + std::string(mesh) + "` | " + std::to_string(20 - notMet) + " | " + std::to_string(notMet);
    EXPECT_THAT(lines, ::testing::Contains(::testing::StartsWith(row)));
  }
}

// The README gives the times of whole runs that .ci/speed has measured.
TEST(Stated, RunTimesOfTheReadmeAreThoseOfTheManual) {
  static const std::regex row(R"(\| `(\w+)` \|.* \| ([0-9.]+) s \| [0-9.]+ % \| \d+ \|)");
  std::map<std::string, std::string> times;
  for (const auto& line : arch::linesOf(SQUAT_SOURCE_DIR "/resources/manual/speed.md")) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    const double seconds = std::stod(found.str(2));
    char text[40];
    std::snprintf(text, sizeof text, seconds < 60 ? "%.0f s" : "%.1f min", seconds < 60 ? seconds : seconds / 60);
    times[found.str(1)] = text;
  }
  ASSERT_EQ(times.size(), 4U);
  const auto expected = "`draft` by default (" + times["draft"] + " on two cores), `standard` (" + times["standard"] +
                        "), `paper` (" + times["paper"] + ").";
  std::string readme;
  for (const auto& line : arch::linesOf(SQUAT_SOURCE_DIR "/README.md")) readme += line + " ";
  EXPECT_THAT(readme, HasSubstr(expected));
}

}  // namespace
}  // namespace squat::verification
