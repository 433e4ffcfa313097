// The manual as one file: two small pages whose HTML is typed by hand, and the whole manual without a loose end.
#include "manual/HtmlManual.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>
#include <stdexcept>

#include "core/DurableFile.h"
#include "pages/CommandPage.h"
#include "pages/ParameterPage.h"
#include "pages/Program.h"
#include "results/SampleResult.h"

namespace squat::manual {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;

class SmallManual : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    writeDurably(folder_ / name, std::string_view(text));
  }
  std::string html() const { return htmlManual(folder_ / "README.md", folder_ / "made", "1.2"); }
  void SetUp() override {
    makeFolder(folder_ / "made");
    write("README.md", "# Pots\n\n[Boiling](boil.md) and [the rest](rest.md#salt-pepper)\n");
    write("boil.md", "# Boiling\n\n![Steam](steam.png) [its own](#boiling) <https://example.org> [notes](notes.txt)\n");
    write("made/rest.md", "# Rest\n\n## Salt, `pepper`\n\n| a | b |\n|---|---|\n| 1 | x\\|y |\n");
    write("steam.png", "Man");  // RFC 4648 writes these three bytes as TWFu
    write("notes.txt", "1 < 2\n");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SmallManual, LinksPagesPicturesAndTexts) {
  const auto text = html();
  EXPECT_THAT(text, HasSubstr("<title>Squat Studio 1.2: manual</title>"));
  EXPECT_THAT(text, HasSubstr("<a href=\"#boil\">Boiling</a> and <a href=\"#rest--salt-pepper\">the rest</a>"));
  EXPECT_THAT(text, HasSubstr("<section id=\"boil\">\n<h1 id=\"boil--boiling\">Boiling</h1>"));
  EXPECT_THAT(text, HasSubstr("<h2 id=\"rest--salt-pepper\">Salt, <code>pepper</code></h2>"));
  EXPECT_THAT(text, HasSubstr("<img src=\"data:image/png;base64,TWFu\" alt=\"Steam\">"));
  EXPECT_THAT(text, HasSubstr("<a href=\"#boil--boiling\">its own</a>"));
  EXPECT_THAT(text, HasSubstr("<a href=\"https://example.org\">"));
  EXPECT_THAT(text, HasSubstr("<a href=\"#notestxt\">notes</a>"));
  EXPECT_THAT(text, HasSubstr("<section id=\"notestxt\">\n<h1>notes.txt</h1>\n<pre>1 &lt; 2\n</pre>"));
  EXPECT_THAT(text, HasSubstr("<td>1</td>\n<td>x|y</td>"));
}

TEST_F(SmallManual, RefusesWhatLeadsNowhere) {
  for (const char* loose : {"[x](none.md)", "[x](boil.md#none)", "![x](none.png)", "[x](none.txt)"}) {
    write("README.md", std::string("# Pots\n\n[Boiling](boil.md) ") + loose + "\n");
    EXPECT_THROW(html(), std::runtime_error) << loose;
  }
}

TEST(HtmlManual, HoldsTheWholeManual) {
  const TemporaryFolder made;
  writeDurably(made / "parameters.md", std::string_view(pages::parameterPage()));
  writeDurably(made / "commands.md", std::string_view(pages::commandPage(pages::callsOf(SQUAT_PROGRAM))));
  const auto text = htmlManual(SQUAT_SOURCE_DIR "/resources/manual/README.md", made.path(), "0");
  std::set<std::string> ids, pages;
  static const std::regex id(" id=\"([^\"]+)\""), link("href=\"#([^\"]+)\""), picture("<img src=\"([^\"]{5})");
  for (std::sregex_iterator found(text.begin(), text.end(), id), end; found != end; ++found)
    EXPECT_TRUE(ids.insert(found->str(1)).second) << "twice: " << found->str(1);
  for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found)
    EXPECT_EQ(ids.count(found->str(1)), 1U) << found->str(1);
  int pictures = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), picture), end; found != end; ++found, ++pictures)
    EXPECT_EQ(found->str(1), "data:");
  EXPECT_GE(pictures, 6);
  for (const char* page : {"manual", "install", "parameters", "commands", "model", "glossary", "contributing"})
    EXPECT_EQ(ids.count(page), 1U) << page;
  EXPECT_THAT(text, Not(HasSubstr("|---|")));  // a table that was not understood
  EXPECT_THAT(text, HasSubstr("<td><code>pad.stiffness</code></td>"));
}

}  // namespace
}  // namespace squat::manual
