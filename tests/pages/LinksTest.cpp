// Every link and picture of README, manual, studies and the texts for developers: the file is there, and the heading
// that an anchor names. The two pages that are written when the program is built are written here.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "arch/Page.h"
#include "core/DurableFile.h"
#include "pages/CommandPage.h"
#include "pages/ParameterPage.h"
#include "pages/Program.h"
#include "results/SampleResult.h"
#include "text/HeadingAnchor.h"

namespace squat::pages {
namespace {

namespace fs = std::filesystem;
const std::string kTop = SQUAT_SOURCE_DIR;

struct Link {
  std::string target;
  int line = 0;
};

// Of a page's prose: code is no link.
std::vector<Link> linksOf(const std::string& path) {
  static const std::regex code("`[^`]+`"), link(R"(\]\(([^)\s]+)\))");
  std::vector<Link> links;
  bool fenced = false;
  int number = 0;
  for (auto line : arch::linesOf(path)) {
    ++number;
    if (line.starts_with("```")) fenced = !fenced;
    if (fenced || line.starts_with("    ")) continue;
    line = std::regex_replace(line, code, "code");
    for (std::sregex_iterator found(line.begin(), line.end(), link), end; found != end; ++found)
      links.push_back({found->str(1), number});
  }
  return links;
}

std::set<std::string> anchorsOf(const std::string& path) {
  std::set<std::string> anchors;
  bool fenced = false;
  for (const auto& line : arch::linesOf(path)) {
    if (line.starts_with("```")) fenced = !fenced;
    if (!fenced && line.starts_with("#")) anchors.insert(text::headingAnchor(line.substr(line.find(' ') + 1)));
  }
  return anchors;
}

std::vector<std::string> textsOf(const fs::path& folder) {
  std::vector<std::string> texts;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".md") texts.push_back(entry.path().string());
  std::sort(texts.begin(), texts.end());
  return texts;
}

class Links : public ::testing::Test {
 protected:
  Links() {
    writeDurably(generated_ / "parameters.md", std::string_view(parameterPage()));
    writeDurably(generated_ / "commands.md", std::string_view(commandPage(callsOf(SQUAT_PROGRAM))));
  }

  // Every page; those that are written by the build among them.
  std::vector<std::string> pages() const {
    std::vector<std::string> all;
    for (const fs::path& folder : {fs::path(kTop), fs::path(kTop) / "resources/manual",
                                   fs::path(kTop) / "resources/studies", fs::path(generated_.path())})
      for (auto& text : textsOf(folder)) all.push_back(std::move(text));
    return all;
  }

  // Where a link of a page leads; empty where that is nowhere.
  std::string fileOf(const std::string& page, const std::string& target) const {
    const bool ofThisPage = target.front() == '#';
    const auto file = ofThisPage ? fs::path(page) : fs::path(page).parent_path() / target.substr(0, target.find('#'));
    if (fs::exists(file)) return fs::weakly_canonical(file).string();
    const bool inTheManual =
        fs::weakly_canonical(file.parent_path()) == fs::weakly_canonical(kTop + "/resources/manual");
    const auto written = generated_ / file.filename().string();
    return inTheManual && fs::exists(written) ? written : std::string();
  }

 private:
  tests::TemporaryFolder generated_;
};

TEST_F(Links, LeadSomewhere) {
  int links = 0, anchors = 0;
  for (const auto& page : pages())
    for (const auto& [target, line] : linksOf(page)) {
      if (target.find(':') != std::string::npos) continue;  // another site
      ++links;
      const auto file = fileOf(page, target);
      EXPECT_NE(file, "") << page << ":" << line << ": " << target;
      const auto hash = target.find('#');
      if (file.empty() || hash == std::string::npos) continue;
      ++anchors;
      EXPECT_EQ(anchorsOf(file).count(target.substr(hash + 1)), 1U) << page << ":" << line << ": " << target;
    }
  EXPECT_GT(links, 60);
  EXPECT_GT(anchors, 10);
}

TEST_F(Links, TheIndexNamesEveryPage) {
  const auto index = kTop + "/resources/manual/README.md";
  std::set<std::string> named{fs::weakly_canonical(index).string()};
  for (const auto& [target, line] : linksOf(index)) named.insert(fileOf(index, target));
  for (const auto& page : pages())
    if (fs::path(page).parent_path() != fs::path(kTop)) {
      EXPECT_EQ(named.count(fs::weakly_canonical(page).string()), 1U) << page;
    }
}

// Bars without a backslash, code included: readers differ about those in code.
std::ptrdiff_t barsIn(const std::string& row) {
  std::ptrdiff_t bars = 0;
  for (std::size_t i = 0; i < row.size(); ++i) bars += row[i] == '|' && (i == 0 || row[i - 1] != '\\');
  return bars;
}

TEST_F(Links, TablesAreWhole) {
  for (const auto& page : pages()) {
    std::ptrdiff_t bars = 0;  // of the table's first row
    int number = 0;
    for (const auto& line : arch::linesOf(page)) {
      ++number;
      if (!line.starts_with("| ") && !line.starts_with("|-")) {
        bars = 0;
        continue;
      }
      if (bars == 0) bars = barsIn(line);
      EXPECT_EQ(barsIn(line), bars) << page << ":" << number << ": " << line;
    }
  }
}

// A picture that no page shows, or that only another picture's name hides.
TEST_F(Links, EveryPictureIsShown) {
  std::set<std::string> shown;
  for (const auto& page : pages())
    for (const auto& [target, line] : linksOf(page))
      if (target.ends_with(".png")) shown.insert(fileOf(page, target));
  for (const auto& entry : fs::directory_iterator(kTop + "/resources/pictures"))
    EXPECT_EQ(shown.count(fs::weakly_canonical(entry.path()).string()), 1U) << entry.path();
}

}  // namespace
}  // namespace squat::pages
