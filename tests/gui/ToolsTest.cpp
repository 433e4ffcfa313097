// Studies, calibration and receptance in the studio: what they write is what the commands write for the same case.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <set>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "gui/ToolsOfAWindow.h"
#include "results/SignalTable.h"
#include "simulation/RunCase.h"
#include "studies/Jobs.h"
#include "studio/common/MessageBar.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/project/RunReader.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/tools/CalibrationForm.h"
#include "studio/tools/JobsButton.h"
#include "studio/tools/KeyRows.h"
#include "studio/tools/TargetList.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

TEST_F(Tools, aStudyIsThatOfTheCommand) {
  ToolWindow* study = open("study");
  study->form()->findChild<KeyRows*>()->setTexts({"defect.depth=0.1,0.2"});
  study->form()->findChild<QAbstractButton*>("keepResults")->click();
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  EXPECT_TRUE(study->messages()->text().contains("files written")) << study->messages()->text().toStdString();
  const QString printed =
      command({"study", "study/case/short.toml", "--vary", "defect.depth=0.1,0.2", "-o", "command", "--format", "png"});
  EXPECT_EQ(read("study/study.csv"), read("command/study.csv"));
  EXPECT_GT(read("study/study.csv").size(), 500);
  EXPECT_EQ(printed.section("command/study.csv", 0, 0), study->text().section(path("study"), 0, 0));
  EXPECT_FALSE(read("study/study_defect_depth.pdf").isEmpty());
  EXPECT_EQ(study->findChild<QTabWidget*>()->count(), 4);  // runs, text, log, one key's figures
  // The runs join the list, called by what differs.
  ASSERT_TRUE(window_.reader()->waitFor(tests::patience));
  ASSERT_EQ(window_.store().rowCount(), 2);
  EXPECT_EQ(window_.store().at(1).label, "depth 0.2");
  EXPECT_TRUE(window_.store().at(1).result->complete);
  EXPECT_GE(window_.store().current(), 0);
  // Once more: nothing is computed again, nothing is listed twice.
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  EXPECT_EQ(window_.store().rowCount(), 2);
}

// Each run has a row from the start on; one that has ended leads to its curves.
TEST_F(Tools, aStudyShowsItsRunsAndOpensThem) {
  ToolWindow* study = open("study");
  const int runs = 6 * studies::coresHere();  // longer than the window takes to look at them
  study->form()->findChild<KeyRows*>()->setTexts({QString("defect.depth=0.05:0.2:%1").arg(runs)});
  study->form()->findChild<QAbstractButton*>("keepResults")->click();
  auto* rows = study->findChild<QTableView*>("studyRows");
  auto* show = study->findChild<QPushButton*>("studyShowRun");
  ASSERT_TRUE(rows->isVisible());
  study->start();
  ASSERT_TRUE(tests::passes([&] { return rows->model()->rowCount() == runs; }, tests::patience));
  EXPECT_TRUE(study->isComputing());  // the table stands before the end
  ASSERT_TRUE(tests::passes([&] { return !study->isBusy(); }, tests::patience));
  for (int row = 0; row < runs; ++row) EXPECT_EQ(rows->model()->index(row, 1).data().toString(), "done") << row;
  ASSERT_TRUE(window_.reader()->waitFor(tests::patience));
  rows->selectRow(runs - 1);
  show->click();
  EXPECT_EQ(window_.store().rowCount(), runs);
  ASSERT_GE(window_.store().current(), 0);
  EXPECT_EQ(window_.store().at(window_.store().current()).label, "depth 0.2");
  // Of one that was not kept, it says how to come by it.
  ASSERT_TRUE(QFile::remove(path("study/run-0001.h5")));
  rows->selectRow(0);
  show->click();
  EXPECT_TRUE(study->messages()->text().contains("not kept")) << study->messages()->text().toStdString();
}

// By names, limits and numbers, as one who has not read how the command writes them.
TEST_F(Tools, valuesOfAStudyAreTypedInFields) {
  const ToolForm* form = open("study")->form();
  auto* rows = form->findChild<KeyRows*>();
  const auto* runs = form->findChild<QLabel*>("studyRuns");
  EXPECT_EQ(runs->text(), "");
  const auto field = [&](const char* name, int row) { return rows->findChildren<QLineEdit*>(name).value(row); };
  rows->findChild<QComboBox*>("key")->setCurrentText("Depth (defect.depth)");
  field("from", 0)->setText("0.1");
  EXPECT_EQ(runs->text(), "1 run");
  field("to", 0)->setText("0.3");
  EXPECT_EQ(runs->text(), "5 runs");
  rows->findChild<QSpinBox*>("count")->setValue(3);
  EXPECT_EQ(rows->texts(), std::vector<std::string>{"defect.depth=0.1:0.3:3"});
  rows->findChild<QToolButton*>("addKey")->click();
  rows->findChildren<QComboBox*>("key").value(1)->setEditText("motion.speed");  // a key as well
  field("from", 1)->setText("20, 30");
  EXPECT_EQ(rows->texts(), (std::vector<std::string>{"defect.depth=0.1:0.3:3", "motion.speed=20,30"}));
  EXPECT_EQ(runs->text(), "6 runs");
  form->findChild<QComboBox*>("points")->setCurrentIndex(1);
  EXPECT_EQ(runs->text(), "64 runs");
  EXPECT_EQ(rows->limits()[0], "defect.depth=0.1:0.3");
  EXPECT_FALSE(rows->findChild<QSpinBox*>("count")->isVisible());
}

// Keys of the right side are typed, and the value beside them is that of the right side.
TEST(KeyRows, theValueBesideAKeyIsThatOfItsSide) {
  auto description = cases::defaultCase();
  cases::setValue(description, "model.extent", "whole");
  cases::setValue(description, "pad.stiffness", "1200");
  ASSERT_EQ(cases::trySetRight(description, "pad.stiffness", "800"), std::nullopt);
  KeyRows rows([](const cases::Parameter&) { return true; }, KeyValues::limits);
  rows.showCase(description);
  rows.setTexts({"right.pad.stiffness=500:900", "pad.stiffness=500:900", "right.ballast.stiffness=20:60"});
  QStringList seen;
  for (const auto* label : rows.findChildren<QLabel*>())
    if (label->text().startsWith("now ")) seen << label->text();
  const auto ballast = cases::valueText(description, *cases::findParameter("ballast.stiffness"));
  EXPECT_EQ(seen, (QStringList{"now 800 MN/m", "now 1200 MN/m", QString::fromStdString("now " + ballast + " MN/m")}))
      << seen.join("; ").toStdString();
}

TEST_F(Tools, whatWasWrongIsNotSaidAnyMoreOnceItIsMended) {
  ToolWindow* study = open("study");
  auto* rows = study->form()->findChild<KeyRows*>();
  rows->setTexts({"defect.dept=0.1,0.2"});
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  ASSERT_TRUE(study->messages()->text().contains("defect.depth")) << study->messages()->text().toStdString();
  rows->findChild<QComboBox*>("key")->setEditText("defect.depth");
  EXPECT_EQ(study->messages()->text(), "");
  study->setFolder("");
  study->start();
  ASSERT_TRUE(study->messages()->text().contains("folder"));
  QTest::keyClicks(study->findChild<QLineEdit*>("toolFolder"), "/");
  EXPECT_EQ(study->messages()->text(), "");
}

// A tool whose tab is closed computes on: the main window says so, and leads back to it.
TEST_F(Tools, whatIsComputedIsSeenInTheMainWindow) {
  const auto* jobs = window_.findChild<JobsButton*>();
  EXPECT_FALSE(jobs->isEnabled());
  const int width = jobs->width();
  ToolWindow* study = open("study");
  study->form()->findChild<KeyRows*>()->setTexts({QString("defect.depth=0.05:0.2:%1").arg(40 * studies::coresHere())});
  study->start();
  study->close();
  EXPECT_FALSE(study->isVisible());
  EXPECT_TRUE(tests::passes([&] { return jobs->text().contains("runs done"); }, 20000)) << jobs->text().toStdString();
  EXPECT_TRUE(jobs->text().startsWith("Study: ")) << jobs->text().toStdString();
  EXPECT_EQ(jobs->width(), width);
  Q_EMIT jobs->menu()->aboutToShow();
  ASSERT_EQ(jobs->menu()->actions().size(), 2);
  jobs->menu()->actions()[0]->trigger();
  EXPECT_TRUE(study->isVisible());
  jobs->menu()->actions()[1]->trigger();
  ASSERT_TRUE(tests::passes([&] { return !study->isBusy(); }, tests::patience));
  EXPECT_FALSE(jobs->isEnabled());
  EXPECT_EQ(jobs->text(), "");
}

// Keys lead from one tool to the next, Escape leaves a tab open in which one works, Ctrl+W closes it, and the window
// with the last one.
TEST_F(Tools, keysOfTheMainWindowWorkInATool) {
  ToolWindow* study = open("study");
  QWidget& tools = *study->window();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&tools));
  QApplication::setActiveWindow(&tools);
  tests::press(tools, Qt::Key_Escape);
  EXPECT_TRUE(study->isVisible());
  tests::press(tools, Qt::Key_F9, Qt::ControlModifier);
  const ToolWindow* estimate = window_.tool("estimate");
  EXPECT_TRUE(tests::passes([&] { return estimate->isVisible(); }));
  EXPECT_FALSE(study->isVisible()) << "its tab is behind";
  tests::press(tools, Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(estimate->isVisible());
  EXPECT_TRUE(study->isVisible());
  tests::press(tools, Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(tools.isVisible());
  EXPECT_TRUE(window_.isVisible());
}

// Beside the project once there is one, else beside the case's file, else among the documents: never in the home folder
// itself. A folder that the user has named stays.
TEST_F(Tools, filesGoBesideTheProject) {
  window_.findChild<QAction*>("studyAction")->trigger();
  auto* folder = window_.tool("study")->findChild<QLineEdit*>("toolFolder");
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  EXPECT_EQ(folder->text(), documents + "/Squat Studio/short-study");
  ASSERT_TRUE(QDir(folder_.path()).mkdir("cases") && QDir(folder_.path()).mkdir("work"));
  ASSERT_TRUE(window_.saveCaseTo(path("cases/dip.toml")));
  EXPECT_EQ(folder->text(), path("cases/dip-study"));
  ASSERT_TRUE(window_.saveProjectTo(path("work/day.squat-project")));
  EXPECT_EQ(folder->text(), path("work/dip-study"));
  window_.tool("study")->setFolder(path("mine"));
  window_.closeProject();
  EXPECT_EQ(folder->text(), path("mine"));
}

TEST_F(Tools, aStudyThatWasStoppedIsResumed) {
  ToolWindow* study = open("study");
  const int points = 3 * studies::coresHere() + 3;  // more than run at once
  study->form()->findChild<KeyRows*>()->setTexts({QString("defect.depth=0.05:0.2:%1").arg(points)});
  study->start();
  ASSERT_TRUE(tests::passes([&] { return read("study/study.csv").count('\n') > 1; }, tests::patience));
  study->cancel();
  ASSERT_TRUE(tests::passes([&] { return !study->isBusy(); }, tests::patience));
  EXPECT_TRUE(study->messages()->text().contains("Cancelled")) << study->messages()->text().toStdString();
  EXPECT_FALSE(study->text().isEmpty());  // what is known so far
  const QByteArray part = read("study/study.csv");
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  EXPECT_TRUE(study->text().contains(QString("%1 of %1 runs done").arg(points))) << study->text().toStdString();
  EXPECT_GT(read("study/study.csv").size(), part.size());
}

TEST_F(Tools, whatIsWrongIsSaidAndNothingIsLost) {
  ToolWindow* study = open("study");
  study->form()->findChild<KeyRows*>()->setTexts({"defect.dept=0.1,0.2"});
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  EXPECT_TRUE(study->messages()->text().contains("defect.depth")) << study->messages()->text().toStdString();
  study->form()->findChild<KeyRows*>()->setTexts({"defect.depth=0.1"});
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  const QByteArray table = read("study/study.csv");
  EXPECT_EQ(table.count('\n'), 2);
  // Another case has no business in this folder.
  window_.document().setParameter("motion.speed", "35");
  ASSERT_NO_FATAL_FAILURE(finish(*study));
  EXPECT_TRUE(study->messages()->text().contains("another case")) << study->messages()->text().toStdString();
  EXPECT_EQ(read("study/study.csv"), table);
  study->setFolder("");
  study->start();
  EXPECT_FALSE(study->isBusy());
  EXPECT_TRUE(study->messages()->text().contains("folder")) << study->messages()->text().toStdString();
}

// Edits while it computes are those of the next start.
TEST_F(Tools, takesTheCaseAsItStandsAtTheStart) {
  ToolWindow* study = open("study");
  study->form()->findChild<KeyRows*>()->setTexts({"defect.depth=0.1,0.2"});
  study->start();
  window_.document().setParameter("motion.speed", "35");
  ASSERT_TRUE(tests::passes([&] { return !study->isBusy(); }, tests::patience));
  EXPECT_TRUE(study->text().contains("2 of 2 runs done")) << study->text().toStdString();
  EXPECT_EQ(cases::readCase(path("study/case/short.toml").toStdString()).motion.speed, 30);
}

TEST_F(Tools, theReceptanceIsThatOfTheCommand) {
  ToolWindow* receptance = open("receptance");
  ASSERT_NO_FATAL_FAILURE(finish(*receptance));
  ASSERT_TRUE(window_.saveCaseTo(path("short.toml")));
  const QString printed = command({"receptance", "short.toml", "-o", "command", "--format", "png"});
  EXPECT_EQ(read("receptance/short-receptance.csv"), read("command/short-receptance.csv"));
  EXPECT_EQ(read("receptance/short-wheelset-modes.csv"), read("command/short-wheelset-modes.csv"));
  EXPECT_GT(read("receptance/short-receptance.csv").size(), 10000);
  EXPECT_EQ(printed.section("\nwritten:", 0, 0), receptance->text());
  EXPECT_FALSE(read("receptance/short-receptance.svg").isEmpty());
}

// A key from a signal that the case itself has made, measured in the list; ten points or so.
TEST_F(Tools, aCalibrationIsThatOfTheCommand) {
  Monitor nobody;
  results::writeSignalTable(path("measured.csv").toStdString(), simulation::runCase(shortCase(), {}, nobody));
  ASSERT_TRUE(window_.openMeasured(path("measured.csv"))) << window_.messages()->text().toStdString();
  ToolWindow* calibration = open("calibration");
  auto* form = qobject_cast<CalibrationForm*>(calibration->form());
  const QString key = "defect.depth=0.05:0.25";
  form->findChild<KeyRows*>()->setTexts({key});
  ASSERT_NO_FATAL_FAILURE(finish(*calibration));
  EXPECT_TRUE(calibration->messages()->text().contains("target")) << calibration->messages()->text().toStdString();
  form->targets()->addSignal(0);
  form->findChild<QComboBox*>("confirmMesh")->setCurrentText("tiny");
  form->findChild<QSpinBox*>("evaluations")->setValue(10);
  ASSERT_NO_FATAL_FAILURE(finish(*calibration));
  ASSERT_TRUE(calibration->text().contains("defect.depth")) << calibration->messages()->text().toStdString();
  const QString printed =
      command({"calibrate", "calibration/case/short.toml", "--targets", "calibration/case/measured-targets.json",
               "--free", key, "--confirm", "tiny", "--evaluations", "10", "-o", "command", "--no-figures"});
  // Points that are computed at the same time end in any order.
  const auto sorted = [this](const QString& name) {
    auto lines = read(name).split('\n');
    std::sort(lines.begin(), lines.end());
    return lines;
  };
  EXPECT_EQ(sorted("calibration/calibration.csv"), sorted("command/calibration.csv"));
  EXPECT_EQ(printed.section("\nwritten:", 0, 0), calibration->text());
  // The case that was found can be opened from the window, and belongs to the work.
  auto* openCase = calibration->findChild<QPushButton*>("toolOpenCase");
  ASSERT_TRUE(openCase->isVisible());
  openCase->click();
  EXPECT_EQ(window_.document().path(), path("calibration/short-calibrated.toml"));
}

TEST_F(Tools, keepWhatWasSetForTheNextDay) {
  {
    ToolWindow* study = open("study");
    study->form()->findChild<KeyRows*>()->setTexts({"defect.depth=0.1,0.2", "motion.speed=20:40:3"});
    study->form()->findChild<QComboBox*>("points")->setCurrentIndex(1);
    study->close();
  }
  MainWindow tomorrow(tests::services());
  const ToolForm* form = tomorrow.tool("study")->form();
  EXPECT_EQ(form->findChild<KeyRows*>()->texts(),
            (std::vector<std::string>{"defect.depth=0.1,0.2", "motion.speed=20:40:3"}));
  EXPECT_EQ(form->findChild<QComboBox*>("points")->currentText(), "Sobol sample");
}

// The window is closed while a study computes: one question, and the study stops; its options are kept.
TEST_F(Tools, closingAsksAndStops) {
  QStringList questions;
  Answer answer = Answer::cancel;
  StudioServices services = tests::services();
  services.asker = [&](QWidget*, const QString& question, const QString&) {
    questions << question;
    return answer;
  };
  MainWindow window(services);
  window.document().startFrom(shortCase(), QString(), "short", false);
  window.show();
  ToolWindow* study = window.tool("study");
  study->setFolder(path("closed"));
  study->form()->findChild<KeyRows*>()->setTexts({QString("defect.depth=0.05:0.2:%1").arg(20 * studies::coresHere())});
  study->start();
  ASSERT_TRUE(tests::passes([&] { return read("closed/study.csv").count('\n') > 1; }, tests::patience));
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(study->isComputing());
  answer = Answer::discard;
  EXPECT_TRUE(window.close());
  EXPECT_FALSE(study->isBusy());
  ASSERT_EQ(questions.size(), 2) << questions.join('\n').toStdString();
  EXPECT_TRUE(questions[1].contains("study")) << questions[1].toStdString();
  EXPECT_LT(read("closed/study.csv").count('\n'), 20 * studies::coresHere());
}

// A value that the form refuses is not computed with the value before it.
TEST_F(Tools, aValueThatIsRefusedStopsTheStart) {
  ToolWindow* study = open("study");
  study->form()->findChild<KeyRows*>()->setTexts({"defect.depth=0.1"});
  auto* line = qobject_cast<QLineEdit*>(window_.form()->row("motion.speed")->editor());
  line->selectAll();
  QTest::keyClicks(line, "-5");
  study->start();
  EXPECT_FALSE(study->isBusy());
  EXPECT_TRUE(study->messages()->text().contains("Cannot start")) << study->messages()->text().toStdString();
}

TEST_F(Tools, everyControlHasANameAndKeysOfItsOwn) {
  for (const char* name : {"study", "calibration", "growth", "receptance", "squats", "estimate"}) {
    SCOPED_TRACE(name);
    ToolWindow* tool = open(name);
    std::set<QString> taken;
    int seen = 0;
    for (QWidget* widget : tool->findChildren<QWidget*>()) {
      if (widget->objectName().startsWith("qt_") || widget->inherits("QTabBar") || widget->inherits("QScrollArea"))
        continue;
      if (const auto* button = qobject_cast<QAbstractButton*>(widget); button && !button->text().isEmpty()) {
        const QString keys = button->shortcut().toString();
        EXPECT_TRUE(keys.isEmpty() || taken.insert(keys).second) << button->text().toStdString();
        if (button->inherits("QPushButton")) {
          EXPECT_FALSE(keys.isEmpty()) << button->text().toStdString();
        }
      }
      if (const auto* label = qobject_cast<QLabel*>(widget); label && label->buddy()) {
        const QString keys = QKeySequence::mnemonic(label->text()).toString();
        EXPECT_TRUE(keys.isEmpty() || taken.insert(keys).second) << label->text().toStdString();
      }
      if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible()) continue;
      QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
      ASSERT_NE(told, nullptr);
      EXPECT_FALSE(told->text(QAccessible::Name).isEmpty())
          << widget->metaObject()->className() << ' ' << widget->objectName().toStdString();
      ++seen;
    }
    EXPECT_GE(seen, 6);
  }
}

}  // namespace
}  // namespace squat::studio
