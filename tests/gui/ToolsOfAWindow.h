// tests/gui/ToolsOfAWindow.h - the tools of a main window on a short case, and what the commands make of the same.
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <initializer_list>
#include <utility>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {

// A tenth of a second on the coarsest mesh.
inline cases::CaseDescription shortCase() {
  auto description = cases::loadCase("light-defect", {"tiny", {}});
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"motion.run_up", "0.06"}, {"motion.beyond", "0.07"}})
    cases::setValue(description, key, value);
  return description;
}

class Tools : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tools");  // what another test has set
    window_.document().startFrom(shortCase(), QString(), "short", false);
    window_.show();
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  ToolWindow* open(const QString& name) {
    window_.findChild<QAction*>(name + "Action")->trigger();
    ToolWindow* tool = window_.tool(name);
    EXPECT_TRUE(tool->isVisible());
    tool->setFolder(path(name));
    return tool;
  }
  static void finish(ToolWindow& tool) {
    tool.start();
    ASSERT_TRUE(tests::passes([&] { return !tool.isBusy(); }, tests::patience));
  }
  // The command on the case that the tool has kept, into a folder of its own. What it prints.
  QString command(const QStringList& words) const {
    QProcess program;
    program.setWorkingDirectory(folder_.path());
    program.start(SQUAT_PROGRAM, words);
    EXPECT_TRUE(program.waitForFinished(tests::patience));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    return QString::fromUtf8(program.readAllStandardOutput());
  }

  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
};

}  // namespace squat::studio
