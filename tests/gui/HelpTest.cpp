// F1 opens help, and help shows the pages that are installed.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

#include "core/ProgramVersion.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
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

}  // namespace
}  // namespace squat::studio
