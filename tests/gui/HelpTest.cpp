// F1 opens help, and help shows the pages that are installed.
#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <algorithm>

#include "core/ProgramVersion.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "studio/window/HelpSearch.h"
#include "studio/window/HelpWindow.h"

namespace squat::studio {
namespace {

TEST(Help, F1OpensHelpAndNotTheAboutBox) {
  MainWindow window(tests::services());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  tests::press(window, Qt::Key_F1);
  const auto* help = window.findChild<HelpWindow*>();
  ASSERT_NE(help, nullptr);
  EXPECT_TRUE(help->isVisible());
  EXPECT_TRUE(help->browser()->toPlainText().contains("Squat Studio")) << help->browser()->toPlainText().toStdString();
  EXPECT_EQ(window.findChild<QMessageBox*>(), nullptr);
  tests::press(window, Qt::Key_F1);  // the same window again
  EXPECT_EQ(window.findChildren<HelpWindow*>().size(), 1);
}

// Of a key its table in the reference that the build writes; of a panel its page; of nothing the index.
TEST(Help, F1GoesToThePageOfWhatHasTheFocus) {
  MainWindow window(tests::services());
  window.resize(MainWindow::usualSize);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const auto shown = [&](QWidget* focus) {
    window.activateWindow();
    focus->setFocus();
    tests::press(window, Qt::Key_F1);
    const QUrl source = window.findChild<HelpWindow*>()->browser()->source();
    return source.fileName() + (source.hasFragment() ? "#" + source.fragment() : "");
  };
  auto* stiffness = window.findChild<QLineEdit*>("pad.stiffness");
  ASSERT_NE(stiffness, nullptr);
  EXPECT_EQ(shown(stiffness), "parameters.md#pad");
  EXPECT_EQ(shown(window.findChild<QLineEdit*>("parameterSearch")), "parameters.md");
  EXPECT_EQ(shown(window.findChild<QWidget*>("runs")), "studio.md#runs");
  window.findChild<QWidget*>("runs")->clearFocus();
  window.findChild<HelpWindow*>()->showIndex();
  EXPECT_TRUE(window.findChild<HelpWindow*>()->browser()->toPlainText().contains("Squat Studio: manual"));
}

// Anchors that the window asks for are headings of the pages.
TEST(Help, EveryPageOfTheManualOpensAtItsHeading) {
  HelpWindow help(helpPages());
  help.setAttribute(Qt::WA_DeleteOnClose, false);
  help.resize(600, 200);
  help.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
  for (const char* page : {"parameters.md#pad", "commands.md#squat-run", "studio.md#runs", "studio.md#comparison",
                           "studio.md#live-preview", "studio.md#projects", "studio.md#profile", "studio.md#signals",
                           "exchange.md#python", "running.md#what-a-run-writes", "CONTRIBUTING.md#recipes"}) {
    help.showPage(page);
    EXPECT_EQ(help.browser()->source().fileName(), QString(page).section('#', 0, 0)) << page;
    EXPECT_GT(help.browser()->verticalScrollBar()->value(), 0) << page;
  }
}

// A page that stands elsewhere is found by its name; a file that is no page is shown as text.
TEST(Help, LinksToWhatStandsElsewhere) {
  const QTemporaryDir folder;
  const auto write = [&](const QString& name, const QByteArray& text) {
    QDir(folder.path()).mkpath(QFileInfo(name).path());
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  };
  const QByteArray longText = QByteArray("Line.\n\n").repeated(100);
  const QStringList pages{write("manual/README.md", "# Manual\n\n[Keys](keys.md#pad)\n"),
                          write("built/keys.md", "# Keys\n\n" + longText + "## Pad\n\nStiff.\n" + longText)};
  write("manual/loop.py", "for each in all:\n    run(each)\n");
  HelpWindow help(pages);
  help.setAttribute(Qt::WA_DeleteOnClose, false);
  help.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
  EXPECT_TRUE(help.browser()->toPlainText().contains("Manual"));
  help.browser()->setSource(QUrl("keys.md#pad"));  // as a click on the link
  EXPECT_TRUE(help.browser()->toPlainText().contains("Stiff."));
  EXPECT_GT(help.browser()->verticalScrollBar()->value(), 0);
  help.browser()->backward();
  EXPECT_TRUE(help.browser()->toPlainText().contains("Manual"));
  help.browser()->setSource(QUrl("loop.py"));
  EXPECT_TRUE(help.browser()->toPlainText().contains("    run(each)"));
}

// Built without its pages, say: an empty window explains nothing.
TEST(Help, aPageThatIsMissingIsNamed) {
  const QTemporaryDir folder;
  QFile index(folder.filePath("index.md"));
  ASSERT_TRUE(index.open(QIODevice::WriteOnly));
  index.write("# Manual\n\n[Parameters](parameters.md#pad)\n");
  index.close();
  HelpWindow help({index.fileName()});
  help.browser()->setSource(QUrl("parameters.md#pad"));  // as a click on the link
  EXPECT_TRUE(help.browser()->toPlainText().contains("“parameters” is not there"))
      << help.browser()->toPlainText().toStdString();
  help.showIndex();
  help.showPage("parameters.md#pad");  // as F1
  EXPECT_TRUE(help.browser()->toPlainText().contains("“parameters” is not there"))
      << help.browser()->toPlainText().toStdString();
}

TEST(Help, AboutNamesVersionAndCommit) {
  MainWindow window(tests::services());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  tests::press(window, Qt::Key_F1, Qt::ControlModifier);
  const auto* about = window.findChild<QMessageBox*>();
  ASSERT_NE(about, nullptr);
  EXPECT_TRUE(about->text().contains(QString::fromStdString(programVersionText()))) << about->text().toStdString();
}

// The README stands beside the program wherever that is, built or installed.
TEST(Help, thereIsAPage) {
  ASSERT_FALSE(helpPages().isEmpty());
  for (const QString& page : helpPages()) EXPECT_TRUE(QFile::exists(page)) << page.toStdString();
}

TEST(Help, pagesAreListedByTheirHeadingAndShown) {
  const QTemporaryDir folder;
  const auto write = [&](const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  };
  const QStringList pages{write("contact.md", "![a picture](x.png)\n\n# Wheel-rail contact\n\nHertz, 1882.\n"),
                          write("track.md", "# The track\n\nSleepers.\n")};
  HelpWindow help(pages);
  help.setAttribute(Qt::WA_DeleteOnClose, false);
  for (const char* title : {"Wheel-rail contact", "The track"})
    EXPECT_TRUE(help.browser()->toPlainText().contains(title)) << title;
  help.browser()->setSource(QUrl::fromLocalFile(pages[0]));
  EXPECT_TRUE(help.browser()->toPlainText().contains("Hertz, 1882.")) << help.browser()->toPlainText().toStdString();
  help.showIndex();
  EXPECT_TRUE(help.browser()->toPlainText().contains("The track"));
  help.browser()->setSource(QUrl::fromLocalFile(pages[0]));  // the same page again
  EXPECT_TRUE(help.browser()->toPlainText().contains("Hertz, 1882."));
  help.showIndex();
  const QString index = write("index.md", "# Manual\n\nStart here.\n");
  HelpWindow withIndex(pages + QStringList{index});
  withIndex.setAttribute(Qt::WA_DeleteOnClose, false);
  EXPECT_TRUE(withIndex.browser()->toPlainText().contains("Start here."));
}

// "One" has wheel three times and flat twice, of these one each below "Part"; "Two" has no flat; "Three" has wheel
// three times and flat four times.
class HelpSearch : public testing::Test {
 protected:
  QString write(const QString& name, const QByteArray& text) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  const QTemporaryDir folder_;
  const QStringList pages_{write("one.md", "# One\n\nA wheel flat. Wheel.\n\n## `Part` of it\n\nFlat wheel.\n"),
                           write("two.md", "# Two\n\nA wheel.\n"),
                           write("three.md", "# Three\n\nFlat wheels, flat wheels, flat wheels: flat.\n")};
};

TEST_F(HelpSearch, listsThePagesThatHoldAllWordsByTheirMatches) {
  const auto matches = searchHelp(pages_, "  Wheel flat ");
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].title, "Three");
  EXPECT_EQ(matches[0].count, 7);
  EXPECT_EQ(matches[1].title, "One");
  EXPECT_EQ(matches[1].count, 5);
  ASSERT_EQ(matches[1].sections.size(), 1u);
  EXPECT_EQ(matches[1].sections[0].heading, "Part of it");
  EXPECT_EQ(matches[1].sections[0].anchor, "part-of-it");
  EXPECT_EQ(matches[1].sections[0].count, 2);
  EXPECT_TRUE(searchHelp(pages_, "ballast").empty());
  EXPECT_TRUE(searchHelp(pages_, " ").empty());
}

// Of two pages that hold the word, that of the manual is what a user looks for.
TEST_F(HelpSearch, pagesOfTheManualComeFirst) {
  ASSERT_TRUE(QDir(folder_.path()).mkdir("manual"));
  const auto matches = searchHelp(pages_ + QStringList{write("manual/four.md", "# Four\n\nA wheel.\n")}, "wheel");
  ASSERT_EQ(matches.size(), 4u);
  EXPECT_EQ(matches[0].title, "Four");
}

TEST_F(HelpSearch, isTypedAndLedBackTo) {
  HelpWindow help(pages_);
  help.setAttribute(Qt::WA_DeleteOnClose, false);
  help.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
  tests::press(help, Qt::Key_F, Qt::ControlModifier);
  tests::type(help, "wheel flat");
  tests::press(help, Qt::Key_Return);
  const auto text = [&] { return help.browser()->toPlainText(); };
  EXPECT_TRUE(text().contains("Three (7 matches)")) << text().toStdString();
  EXPECT_TRUE(text().contains("One (5 matches)"));
  EXPECT_FALSE(text().contains("Two"));
  QUrl part = QUrl::fromLocalFile(pages_[0]);
  part.setFragment("part-of-it");
  EXPECT_TRUE(help.browser()->toHtml().contains(part.toString(QUrl::FullyEncoded)));
  help.browser()->setSource(part);  // as a click on the link
  EXPECT_TRUE(text().contains("A wheel flat."));
  EXPECT_EQ(help.browser()->extraSelections().size(), 5);  // each match is marked
  help.browser()->backward();
  EXPECT_TRUE(text().contains("Three (7 matches)")) << text().toStdString();
  help.findChild<QLineEdit*>("helpSearch")->clear();
  EXPECT_EQ(help.browser()->extraSelections().size(), 0);
  help.search("ballast");
  EXPECT_TRUE(text().contains("No page holds all of these words")) << text().toStdString();
}

TEST_F(HelpSearch, findsThePagesOfTheManual) {
  const auto matches = searchHelp(helpPages(), "wheel flat");
  ASSERT_FALSE(matches.empty());
  for (const auto& match : matches) EXPECT_TRUE(QFile::exists(match.page)) << match.page.toStdString();
  EXPECT_TRUE(std::any_of(matches.begin(), matches.end(),
                          [](const auto& match) { return QFileInfo(match.page).fileName() == "model.md"; }));
}

}  // namespace
}  // namespace squat::studio
