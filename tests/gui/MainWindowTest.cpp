// The window as a whole: files, tabs, closing, dark.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "core/Errors.h"
#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "studio/common/MessageBar.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/runs/RunPanel.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

// What a tab is for, seen: a figure of signals has points within its axes, or a map.
QString widgetOf(const QString& tab) {
  if (tab == "profile") return "profileTable";
  if (tab == "model") return "scene";
  if (tab == "paper") return "paperTitle";
  if (tab == "preview") return "previewTitle";
  if (tab == "run" || tab == "runs" || tab == "comparison" || tab == "notes") return tab;
  return "view " + tab;
}

bool hasData(plots::Figure& figure) {
  const QCPRange seen = figure.xAxis->range();
  for (int i = 0; i < figure.plottableCount(); ++i) {
    const auto* curve = qobject_cast<const QCPCurve*>(figure.plottable(i));
    if (qobject_cast<const QCPColorMap*>(figure.plottable(i)) || (curve && curve->dataCount() > 10)) return true;
  }
  for (int i = 0; i < figure.graphCount(); ++i) {
    const auto data = figure.graph(i)->data();
    if (std::count_if(data->constBegin(), data->constEnd(), [&](const auto& at) { return seen.contains(at.key); }) > 10)
      return true;
  }
  return false;
}

// The cells of a patch are items. More than ten, as of the points of a curve.
bool hasCells(const plots::Figure& figure) {
  int cells = 0;
  for (int i = 0; i < figure.itemCount(); ++i) cells += qobject_cast<QCPItemRect*>(figure.item(i)) != nullptr;
  return cells > 10;
}

TEST(MainWindow, everyTabShowsSomething) {
  MainWindow window(tests::services());
  ASSERT_TRUE(window.openCase("light-defect"));
  window.store().add({std::make_shared<const results::RunResult>(tests::syntheticResult()), "run", {}, false});
  window.resize(1400, 900);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  for (const QString& name : MainWindow::tabNames()) {
    ASSERT_TRUE(window.showTab(name));
    QTest::qWait(60);
    const QWidget* shown = window.findChild<QWidget*>(widgetOf(name));
    ASSERT_NE(shown, nullptr) << name.toStdString();
    EXPECT_TRUE(shown->isVisible()) << name.toStdString();  // what stands behind another tab is not
    if (const FigureView* view = window.signalsPanel()->view(name)) {
      EXPECT_TRUE(name == "contact_patch" ? hasCells(*view->figure()) : hasData(*view->figure())) << name.toStdString();
    }
  }
  EXPECT_TRUE(hasData(*window.profile()->plot()));
  EXPECT_FALSE(window.showTab("nowhere"));
}

// No larger than the screen, or than the smallestWindow screen that the studio is made for (1366 x 768 less the frames
// of a desktop): the first start has no layout to restore.
TEST(MainWindow, theFirstWindowFitsTheScreen) {
  MainWindow window(tests::services());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  constexpr QSize smallestWindow(1280, 700);
  const QSize maximum = window.screen()->availableSize().expandedTo(smallestWindow);
  EXPECT_LE(window.width(), maximum.width());
  EXPECT_LE(window.height(), maximum.height());
}

// What a text needs is what its widget has: nothing is cut, also in a small window.
TEST(MainWindow, everyTextHasRoom) {
  MainWindow window(tests::services());
  ASSERT_TRUE(window.openCase("light-defect"));
  window.store().add({std::make_shared<const results::RunResult>(tests::syntheticResult()), "run", {}, false});
  for (const QSize size : {QSize(1500, 920), QSize(1440, 900), QSize(1280, 700)}) {
    window.resize(size);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    for (const QString& name : MainWindow::tabNames()) {
      window.showTab(name);
      QTest::qWait(30);
      for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool text = (label && !label->wordWrap()) || (button && !button->text().isEmpty()) ||
                          qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
        if (!text || !widget->isVisible() || qobject_cast<QTabBar*>(widget->parentWidget())) continue;
        EXPECT_GE(widget->width(), widget->minimumSizeHint().width())
            << name.toStdString() << ": " << widget->metaObject()->className() << ' '
            << widget->accessibleName().toStdString() << (label ? label->text().toStdString() : std::string());
      }
    }
    EXPECT_EQ(window.size(), size);  // no part forces the window to be larger
  }
}

// Cancelled in a phase before the rolling: no empty entry in the list, no question about it on closing.
TEST(MainWindow, nothingIsKeptOfARunThatNeverRolled) {
  int questions = 0;
  StudioServices services = tests::services();
  services.runner = [](const cases::CaseDescription&, const simulation::RunOptions&, Monitor& monitor,
                       results::RunResult*) {
    while (!monitor.cancelled()) QTest::qSleep(1);
    results::RunResult nothing;
    nothing.stopReason = "cancelled";
    return nothing;
  };
  services.asker = [&](QWidget*, const QString&, const QString&) {
    ++questions;
    return Answer::cancel;
  };
  MainWindow window(services);
  window.show();
  window.startRun();
  window.controller().cancel();
  ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }));
  EXPECT_EQ(window.store().rowCount(), 0);
  EXPECT_TRUE(window.findChild<QLabel*>("runLine")->text().contains("no results"));
  EXPECT_TRUE(window.close());
  EXPECT_EQ(questions, 0);
}

// Above the messages, in which warnings would scroll them away.
TEST(MainWindow, timeAndPeaksOfARunStayInSight) {
  StudioServices services = tests::services();
  services.runner = [run = tests::madeUpRunner(20)](const auto& description, const auto& options, Monitor& monitor,
                                                    results::RunResult* partial) {
    auto result = run(description, options, monitor, partial);
    result.performance = {{"seconds", "s", "", 83.4}};
    result.warnings = {"first", "second", "third", "fourth"};
    return result;
  };
  MainWindow window(services);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const auto* note = window.findChild<QLabel*>("runLine");
  ASSERT_NE(note, nullptr);
  window.startRun();
  EXPECT_FALSE(note->text().contains("Done"));
  ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }));
  QTest::qWait(20);                // it is drawn
  EXPECT_EQ(note->toolTip(), "");  // whole
  for (const char* word : {"Done in 1 min 23 s", "axle box acceleration", "contact force up to"})
    EXPECT_TRUE(note->text().contains(word)) << note->text().toStdString();
  const auto* messages = window.findChild<RunPanel*>()->findChild<QPlainTextEdit*>();
  EXPECT_TRUE(messages->toPlainText().contains("fourth")) << messages->toPlainText().toStdString();
  window.startRun();
  EXPECT_FALSE(note->text().contains("Done"));  // it is of the run before
}

TEST(MainWindow, everyActionHasAName) {
  MainWindow window(tests::services());
  for (const QAction* action : window.findChildren<QAction*>())
    if (!action->isSeparator() && action->parent() == &window) {
      EXPECT_FALSE(action->text().isEmpty());
    }
  for (const char* name : {"new", "open", "save", "saveAs", "saveResult", "undo", "redo", "runAction", "pauseAction",
                           "cancelAction", "dark", "fit", "quit"}) {
    const auto* action = window.findChild<QAction*>(name);
    ASSERT_NE(action, nullptr) << name;
    EXPECT_FALSE(action->shortcut().isEmpty()) << name;
  }
}

TEST(MainWindow, figuresAreExportedOnceThereIsSomethingToSee) {
  MainWindow window(tests::services());
  const auto enabled = [&](const char* name) { return window.findChild<QAction*>(name)->isEnabled(); };
  const auto* button = window.findChild<QPushButton*>("exportAllButton");
  for (const char* name : {"copyFigure", "exportFigure", "exportAll"}) EXPECT_FALSE(enabled(name)) << name;
  EXPECT_FALSE(button->isEnabled());
  window.store().add({std::make_shared<const results::RunResult>(tests::syntheticResult()), "run", {}, false});
  for (const char* name : {"copyFigure", "exportFigure", "exportAll"}) EXPECT_TRUE(enabled(name)) << name;
  EXPECT_TRUE(button->isEnabled());
}

TEST(MainWindow, aWrongFileIsAMessageNotABox) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("wrong.toml"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("schema = 1\n[motion]\nsped = 3\n");
  file.close();
  MainWindow window(tests::services());
  window.show();
  EXPECT_FALSE(window.openAny(file.fileName()));
  EXPECT_FALSE(window.messages()->text().isEmpty());
  EXPECT_FALSE(window.openAny(folder.filePath("missing.h5")));
  EXPECT_TRUE(window.messages()->text().contains("missing.h5"));
}

TEST(MainWindow, aResultIsSavedAndOpened) {
  const QTemporaryDir folder;
  MainWindow window(tests::services());
  window.store().add({std::make_shared<const results::RunResult>(tests::syntheticResult()), "run", {}, false});
  ASSERT_TRUE(window.saveResultTo(folder.filePath("run.h5"))) << window.messages()->text().toStdString();
  MainWindow other(tests::services());
  ASSERT_TRUE(other.openAny(folder.filePath("run.h5")));
  ASSERT_EQ(other.store().rowCount(), 1);
  EXPECT_EQ(*other.store().currentResult()->signal("aba_filtered"),
            *window.store().at(0).result->signal("aba_filtered"));
}

TEST(MainWindow, closingDuringARunAsksAndStopsCleanly) {
  Answer answer = Answer::cancel;
  StudioServices services = tests::services(60000);
  services.asker = [&](QWidget*, const QString&, const QString&) { return answer; };
  MainWindow window(services);
  window.show();
  window.startRun();
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(window.controller().isRunning());
  answer = Answer::discard;
  EXPECT_TRUE(window.close());
  EXPECT_FALSE(window.controller().isRunning());
}

// The answer stops the run; what is asked afterwards waits for nobody's processor.
TEST(MainWindow, closingStopsTheRunBeforeItAsksOn) {
  std::vector<bool> runs;  // while each question stands
  MainWindow* asking = nullptr;
  StudioServices services = tests::services(60000);
  services.asker = [&](QWidget*, const QString&, const QString&) {
    runs.push_back(asking->controller().isRunning());
    return Answer::discard;
  };
  MainWindow window(services);
  asking = &window;
  window.show();
  window.document().setParameter("motion.speed", "25");  // asked about as well
  window.startRun();
  EXPECT_TRUE(window.close());
  EXPECT_EQ(runs, (std::vector<bool>{true, false}));
}

// Stopped to close, and then the user stays: what the run had is there, as after a cancel.
TEST(MainWindow, whatAStoppedRunHadStaysWithAWindowThatStays) {
  int questions = 0;
  StudioServices services = tests::services(60000);
  services.asker = [&](QWidget*, const QString&, const QString&) {
    return ++questions == 1 ? Answer::discard : Answer::cancel;
  };
  MainWindow window(services);
  window.show();
  window.document().setParameter("motion.speed", "25");
  window.startRun();
  EXPECT_FALSE(window.close());
  EXPECT_EQ(questions, 2);
  ASSERT_EQ(window.store().rowCount(), 1);
  EXPECT_FALSE(window.store().currentResult()->complete);
}

TEST(MainWindow, aResultOfAnotherCaseIsMarked) {
  MainWindow window(tests::services());
  ASSERT_TRUE(window.openCase("light-defect"));
  window.show();
  auto* mark = window.findChild<QLabel*>("signalProblem");
  window.startRun();
  ASSERT_TRUE(tests::passes([&] { return window.store().rowCount() == 1; }));
  EXPECT_EQ(mark->text(), "");
  window.document().setParameter("motion.speed", "25");
  for (const char* word : {"“light-defect”", "motion.speed"})
    EXPECT_TRUE(mark->text().contains(word)) << mark->text().toStdString();
  window.document().setParameter("title", "another name alone");
  window.document().undoStack().undo();
  window.document().undoStack().undo();
  EXPECT_EQ(mark->text(), "");
  window.document().setParameter("title", "another name alone");
  EXPECT_EQ(mark->text(), "");
  const auto* dock = window.findChild<QDockWidget*>("signalsDock");
  EXPECT_TRUE(dock->windowTitle().contains("light-defect")) << dock->windowTitle().toStdString();
}

// 0.1 m and 0.12 m are the preset's, 0.3 m the default of both.
TEST(MainWindow, aPresetThatShortensTheRunSaysSo) {
  MainWindow window(tests::services());
  window.show();
  window.document().setParameter("mesh.preset", "tiny");
  for (const char* word : {"tiny", "motion.run_up = 0.1 m", "motion.beyond = 0.12 m", "default 0.3 m"})
    EXPECT_TRUE(window.messages()->text().contains(word)) << window.messages()->text().toStdString();
}

// Typed, not entered with Return: what the form shows is what runs.
TEST(MainWindow, aValueThatIsStillBeingTypedCounts) {
  double ran = 0;
  StudioServices services = tests::services();
  services.runner = [&](const cases::CaseDescription& description, const simulation::RunOptions&, Monitor&,
                        results::RunResult*) {
    ran = description.motion.speed;
    return results::RunResult{};
  };
  MainWindow window(services);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  auto* line = window.form()->findChild<QLineEdit*>("motion.speed");
  ASSERT_TRUE(line);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, "40");
  window.startRun();
  ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }));
  EXPECT_EQ(ran, 40);
  line->selectAll();
  QTest::keyClicks(line, "41");
  EXPECT_TRUE(window.close());  // discards
  EXPECT_EQ(window.document().description().motion.speed, 41);
}

// What is seen cannot be saved: then nothing is, and the user is told. On leaving it counts as a change.
TEST(MainWindow, aRefusedTextIsNotSavedAsTheValueBefore) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("mine.toml");
  int questions = 0;
  Answer answer = Answer::cancel;
  StudioServices services = tests::services();
  services.asker = [&](QWidget*, const QString&, const QString&) {
    ++questions;
    return answer;
  };
  MainWindow window(services);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  ASSERT_TRUE(window.saveCaseTo(path));
  ASSERT_FALSE(window.isWindowModified());
  QFile file(path);
  ASSERT_TRUE(file.remove());
  auto* line = window.form()->findChild<QLineEdit*>("motion.speed");
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, "400");
  EXPECT_FALSE(window.saveCase());
  EXPECT_FALSE(file.exists());
  EXPECT_TRUE(window.messages()->text().contains("not saved")) << window.messages()->text().toStdString();
  EXPECT_TRUE(window.isWindowModified());
  EXPECT_EQ(line->text(), "400");
  EXPECT_FALSE(window.close());
  window.findChild<QAction*>("new")->trigger();
  EXPECT_EQ(questions, 2);
  EXPECT_EQ(line->text(), "400");
  answer = Answer::save;
  EXPECT_FALSE(window.close());  // it cannot be saved
  answer = Answer::discard;
  window.findChild<QAction*>("new")->trigger();
  EXPECT_EQ(line->text(), "30");
  EXPECT_FALSE(window.isWindowModified());
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, "fast");
  EXPECT_FALSE(window.saveCaseTo(path));
  line->selectAll();
  QTest::keyClicks(line, "40\r");
  EXPECT_TRUE(window.saveCaseTo(path));
  EXPECT_TRUE(window.messages()->text().isEmpty()) << window.messages()->text().toStdString();
}

// Some limits are known only once the mesh is made: they are marked where the others are, until the case changes.
TEST(MainWindow, whatARunFindsWrongIsMarkedInTheForm) {
  StudioServices services = tests::services();
  services.runner = [](const cases::CaseDescription&, const simulation::RunOptions&, Monitor&,
                       results::RunResult*) -> results::RunResult {
    throw CaseError({{"motion.beyond", "3 m", "at most 2.48 m for this wheel", "Shorten it"}});
  };
  MainWindow window(services);
  window.show();
  const auto reason = [&] { return window.form()->row("motion.beyond")->reason(); };
  window.startRun();
  ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }));
  EXPECT_TRUE(reason().contains("at most 2.48 m")) << reason().toStdString();
  EXPECT_FALSE(window.form()->blockers().isEmpty());
  window.document().setParameter("motion.beyond", "0.4");
  EXPECT_TRUE(reason().isEmpty()) << reason().toStdString();
  EXPECT_TRUE(window.form()->blockers().isEmpty());
}

// Nothing is asked: it can be undone, for results that are in no file as well.
TEST(MainWindow, aRemovedRunComesBackAsItStood) {
  StudioServices services = tests::services();
  int questions = 0;
  services.asker = [&](QWidget*, const QString&, const QString&) {
    ++questions;
    return Answer::cancel;
  };
  MainWindow window(services);
  RunStore& store = window.store();
  for (const char* label : {"a", "b", "c"})
    store.add({std::make_shared<const results::RunResult>(tests::syntheticResult()), label, {}, false});
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  store.setCurrent(1);
  const auto names = [&] {
    QStringList all;
    for (int row = 0; row < store.rowCount(); ++row) all << store.at(row).label;
    return all.join("");
  };
  QAction* restore = window.findChild<QAction*>("restoreRun");
  EXPECT_FALSE(restore->isEnabled());
  auto* runs = window.findChild<RunsPanel*>();
  runs->table()->setCurrentIndex(runs->indexOf(1));
  QTest::keyClick(runs->table(), Qt::Key_Delete);
  runs->table()->setCurrentIndex(runs->indexOf(0));
  for (auto* button : window.findChildren<QPushButton*>())
    if (button->text() == "Remove") button->click();
  ASSERT_EQ(names(), "c");
  EXPECT_TRUE(window.messages()->text().contains("“a”")) << window.messages()->text().toStdString();
  restore->trigger();
  EXPECT_EQ(names(), "ac");
  EXPECT_TRUE(store.at(0).overlaid);
  EXPECT_EQ(store.current(), 1);  // c, which was shown when the others had gone
  restore->trigger();
  EXPECT_EQ(names(), "abc");
  EXPECT_EQ(store.current(), 1);
  EXPECT_FALSE(restore->isEnabled());
  EXPECT_EQ(store.unsaved().size(), 3U);
  EXPECT_EQ(questions, 0);
}

TEST(MainWindow, everyRunOfAMeasuredFileIsOverlaidAndForcesAreNot) {
  const QTemporaryDir folder;
  const auto write = [&](const QString& name, const QByteArray& head, int runs) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(head);
    for (int run = 1; run <= runs; ++run)
      for (int i = 0; i < 60; ++i)
        file.write(QByteArray::number(run) + ',' + QByteArray::number(i * 1e-3) + ',' + QByteArray::number(i % 7) +
                   '\n');
  };
  write("passages.csv", "run,time [s],aba [m/s2]\n", 3);
  write("force.csv", "run,time [s],force [kN]\n", 1);
  MainWindow window(tests::services());
  EXPECT_TRUE(window.openMeasured(folder.filePath("passages.csv"))) << window.messages()->text().toStdString();
  EXPECT_EQ(window.store().rowCount(), 3);
  EXPECT_FALSE(window.openMeasured(folder.filePath("force.csv")));
  EXPECT_TRUE(window.messages()->text().contains("not an acceleration")) << window.messages()->text().toStdString();
}

// Two boxes, neither time nor rate: the dialog that asks for them says so, and the window no longer does.
TEST(MainWindow, whatADialogSaysStandsThereAlone) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("boxes.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("left box [m/s2],right box [m/s2]\n");
  for (int i = 0; i < 60; ++i) file.write(QByteArray::number(i % 7) + ',' + QByteArray::number(i % 5) + '\n');
  file.close();
  MainWindow window(tests::services());
  window.show();
  ASSERT_FALSE(window.openMeasured(file.fileName()));
  ASSERT_FALSE(window.messages()->isEmpty());
  window.askHowToRead(file.fileName());
  const auto* dialog = window.findChild<MeasuredDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  EXPECT_TRUE(window.messages()->isEmpty()) << window.messages()->text().toStdString();
  const auto* message = dialog->findChild<QLabel*>("measuredMessage");
  EXPECT_TRUE(tests::passes([&] { return message->text().contains("rate"); })) << message->text().toStdString();
}

TEST(MainWindow, darkAndBackKeepsTheWindowAlive) {
  MainWindow window(tests::services());
  window.show();
  window.store().add({std::make_shared<const results::RunResult>(tests::syntheticResult()), "run", {}, false});
  window.setDark(true);
  QTest::qWait(30);
  EXPECT_LT(window.palette().color(QPalette::Window).lightness(), 100);
  window.setDark(false);
  QTest::qWait(30);
  EXPECT_GT(window.palette().color(QPalette::Window).lightness(), 180);
}

}  // namespace
}  // namespace squat::studio
