// Habits of a desktop program: shortcuts, names for screen readers, files dropped, questions before work is lost.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <set>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "project/MeasuredRecords.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "studio/common/EarlierSettings.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/MessageBar.h"
#include "studio/common/Theme.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/comparison/MapWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/profile/ImportDialog.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/SquatDialog.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/window/HelpWindow.h"

namespace squat::studio {
namespace {

StoredRun madeUp(const QString& label, const QString& path = {}) {
  return {std::make_shared<const results::RunResult>(tests::syntheticResult()), label, path, false};
}

// One strike of `strength` [m/s2] at 0.1 s, in two columns; 0.2 s without a speed.
void writeMeasured(const QString& path, double strength) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("time [s],aba [m/s2],left [m/s2]\n");
  for (int i = 0; i < 400; ++i) {
    const QByteArray value = QByteArray::number(i < 200 ? 0.0 : strength * std::exp(-0.02 * (i - 200)));
    file.write(QByteArray::number(i / 2000.0) + ',' + value + ',' + value + '\n');
  }
}

// Every entry of the menus; those of "Recent" come and go.
void collect(const QList<QAction*>& actions, std::vector<QAction*>& all) {
  for (QAction* action : actions) {
    if (action->menu()) {
      if (!action->text().contains("Recent")) collect(action->menu()->actions(), all);
    } else if (!action->isSeparator()) {
      all.push_back(action);
    }
  }
}

TEST(Habits, everyActionHasAShortcutOfItsOwn) {
  MainWindow window(tests::services());
  std::vector<QAction*> all;
  collect(window.menuBar()->actions(), all);
  EXPECT_GT(all.size(), 40u);
  std::set<QString> taken;
  for (const QAction* action : all) {
    ASSERT_FALSE(action->shortcuts().isEmpty()) << action->text().toStdString();
    for (const QKeySequence& keys : action->shortcuts()) {
      EXPECT_FALSE(keys.isEmpty()) << action->text().toStdString();
      EXPECT_TRUE(taken.insert(keys.toString()).second) << keys.toString().toStdString();
    }
  }
}

// Buttons that stand in no menu have keys of their own as well.
TEST(Habits, everyButtonHasAKeyOrAMenuEntry) {
  MainWindow window(tests::services());
  std::vector<QAction*> actions;
  collect(window.menuBar()->actions(), actions);
  std::set<QString> taken;
  for (const QAction* action : actions)
    for (const QKeySequence& keys : action->shortcuts()) taken.insert(keys.toString());
  const QStringList inMenus{"Save…", "Overlay…", "Picture…", "VTK…",   "Fit",    "Export all…",
                            "Run",   "Resume",   "Pause",    "Cancel", "Compare"};
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
    const bool action =
        (button->inherits("QPushButton") || button->inherits("QToolButton")) && button->text().size() > 2;
    if (!action || inMenus.contains(button->text()) || button->objectName().startsWith("qt_") || button->isCheckable())
      continue;
    EXPECT_FALSE(button->shortcut().isEmpty()) << button->text().toStdString();
    EXPECT_TRUE(taken.insert(button->shortcut().toString()).second) << button->text().toStdString();
  }
}

TEST(Habits, everyControlHasANameForScreenReaders) {
  MainWindow window(tests::services());
  window.store().add(madeUp("run"));
  window.show();
  int seen = 0;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool own = !widget->objectName().startsWith("qt_") && !widget->inherits("QScrollArea");
    if (!own || !(widget->focusPolicy() & Qt::TabFocus) || !widget->isEnabled() || widget->inherits("QTabBar"))
      continue;
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(told, nullptr);
    EXPECT_FALSE(told->text(QAccessible::Name).isEmpty())
        << widget->metaObject()->className() << ' ' << widget->objectName().toStdString() << " in "
        << widget->parentWidget()->metaObject()->className();
    ++seen;
  }
  EXPECT_GT(seen, static_cast<int>(cases::parameterTable().size()));
}

// Every control has a name, and Tab reaches it; there are `fewest` at least.
void judgeControls(QWidget& window, int fewest) {
  SCOPED_TRACE(window.metaObject()->className());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QApplication::setActiveWindow(&window);
  std::set<const QWidget*> reached;
  for (int i = 0; i < 60; ++i) {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : &window, Qt::Key_Tab);
    reached.insert(QApplication::focusWidget());
  }
  int seen = 0;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool own = !widget->objectName().startsWith("qt_") && !widget->inherits("QScrollArea");
    if (!own || !(widget->focusPolicy() & Qt::TabFocus) || !widget->isEnabled() || !widget->isVisible()) continue;
    const std::string words =
        widget->metaObject()->className() + (' ' + widget->objectName() + ' ' + widget->accessibleName()).toStdString();
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(told, nullptr);
    EXPECT_FALSE(told->text(QAccessible::Name).isEmpty()) << words;
    EXPECT_TRUE(reached.contains(widget)) << words;
    ++seen;
  }
  EXPECT_GE(seen, fewest);
  window.hide();
}

TEST(Habits, everyControlOfADialogHasANameAndIsReachedByTab) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("profile.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("position [mm];height [um]\n-10;0\n0;-50\n10;0\n");
  file.close();
  ASSERT_NO_FATAL_FAILURE(writeMeasured(folder.filePath("measured.csv"), 70));
  const auto style = figureStyle(false);
  ImportDialog profile(file.fileName(), style);
  judgeControls(profile, 14);
  MeasuredDialog measured({folder.filePath("measured.csv").toStdString(), {}, 30}, style);
  const auto* take = measured.findChild<QPushButton*>("takeMeasured");
  ASSERT_TRUE(take && tests::passes([&] { return take->isEnabled(); }, 60000));
  judgeControls(measured, 8);
  RunStore store;
  StoredRun signal = madeUp("signal", "/nowhere/signal.csv");
  signal.result = nullptr;
  signal.reading.options.speed = 30;
  AlignDialog align(store, store.add(signal));
  judgeControls(align, 6);
  SquatDialog squat(cases::defaultCase(), style);
  judgeControls(squat, 6);
  FigureSizeDialog size({});
  judgeControls(size, 4);
  MainWindow window(tests::services());
  for (const char* label : {"one", "two"}) window.store().add(madeUp(label));
  window.comparison()->showMaps();
  judgeControls(*window.comparison()->maps(), 7);
}

// Buttons of a tool bar take no focus: each has its keys.
TEST(Habits, helpIsReadWithTheKeyboard) {
  HelpWindow help(helpPages());
  help.setAttribute(Qt::WA_DeleteOnClose, false);
  judgeControls(help, 1);
  const auto actions = help.findChild<QToolBar*>("helpNavigation")->actions();
  EXPECT_GE(actions.size(), 3);
  for (const QAction* action : actions) EXPECT_FALSE(action->shortcut().isEmpty()) << action->text().toStdString();
}

TEST(Habits, tabWalksThroughTheForm) {
  MainWindow window(tests::services());
  window.resize(MainWindow::usualSize);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QApplication::setActiveWindow(&window);
  auto* search = window.findChild<QLineEdit*>("parameterSearch");
  search->setFocus();
  std::vector<QString> visited;
  for (int i = 0; i < 9; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    visited.push_back(QApplication::focusWidget()->objectName());
  }
  // The keys of the table come in its order, none is left out.
  std::size_t at = 0;
  for (const QString& name : visited)
    for (std::size_t i = 0; i < 6; ++i)
      if (name.toStdString() == cases::parameterTable()[i].key) {
        EXPECT_GE(i, at);
        at = i;
      }
  EXPECT_GE(at, 3u);
}

// Who scrolls means to scroll; what has the focus may be turned.
TEST(Habits, theWheelScrollsAndChangesNothing) {
  MainWindow window(tests::services());
  ASSERT_TRUE(window.openCase("light-defect"));
  window.store().add(madeUp("run"));
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QApplication::setActiveWindow(&window);
  window.findChild<QLineEdit*>("parameterSearch")->setFocus();
  const auto before = window.document().description();
  const auto settings = window.signalsPanel()->settings();
  int turned = 0;
  for (QWidget* panel : {static_cast<QWidget*>(window.form()), static_cast<QWidget*>(window.profile()),
                         static_cast<QWidget*>(window.signalsPanel())})
    for (auto* widget : panel->findChildren<QWidget*>())
      if (widget->inherits("QComboBox") || widget->inherits("QAbstractSpinBox") || widget->inherits("QSlider")) {
        tests::turnWheel(*widget);
        ++turned;
      }
  EXPECT_GT(turned, 20);
  EXPECT_TRUE(sameCase(window.document().description(), before));
  EXPECT_EQ(window.signalsPanel()->settings().cutoff, settings.cutoff);
  EXPECT_EQ(window.signalsPanel()->settings().segment, settings.segment);
  EXPECT_EQ(window.signalsPanel()->settings().window, settings.window);
  const auto* scroll = window.form()->findChild<QScrollArea*>();
  EXPECT_GT(scroll->verticalScrollBar()->value(), 0);
  auto* lateral = window.form()->findChild<QComboBox*>("defect.lateral");
  ASSERT_TRUE(lateral);
  lateral->setFocus();
  lateral->setCurrentIndex(0);
  tests::turnWheel(*lateral);
  EXPECT_EQ(lateral->currentIndex(), 1);
}

// A field that has nothing typed in it has nothing to undo: the keys are those of the case.
TEST(Habits, undoInAFieldUndoesTheCase) {
  MainWindow window(tests::services());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const auto speed = [&] { return window.document().description().motion.speed; };
  auto* line = window.form()->findChild<QLineEdit*>("motion.speed");
  const auto typeSpeed = [&](const QString& text) {
    line->setFocus();
    line->selectAll();
    tests::type(window, text);
  };
  typeSpeed("40");
  tests::press(window, Qt::Key_Return);
  ASSERT_EQ(speed(), 40);
  ASSERT_TRUE(line->hasFocus());
  tests::press(window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(speed(), 30);
  EXPECT_EQ(line->text(), "30");
  tests::press(window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(speed(), 40);
  EXPECT_EQ(line->text(), "40");
  typeSpeed("55");
  tests::press(window, Qt::Key_Z, Qt::ControlModifier);  // of the typing
  EXPECT_EQ(speed(), 40);
  EXPECT_NE(line->text(), "55");
}

TEST(Habits, undoInASpinBoxUndoesTheCase) {
  MainWindow window(tests::services());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const auto length = [&] { return window.document().description().defect.length; };
  const double before = length();
  auto* number = window.profile()->findChild<QDoubleSpinBox*>("number defect.length");
  ASSERT_TRUE(number && number->isVisible());
  number->setFocus();
  number->selectAll();
  tests::type(window, "33");
  tests::press(window, Qt::Key_Return);
  ASSERT_DOUBLE_EQ(length(), 0.033);
  tests::press(window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(length(), before);
  EXPECT_DOUBLE_EQ(number->value(), 1e3 * before);
}

TEST(Habits, aDroppedCaseIsOpened) {
  const QTemporaryDir folder;
  cases::CaseDescription description = cases::defaultCase();
  description.motion.speed = 21;
  cases::saveCase(description, folder.filePath("dropped.toml").toStdString());
  MainWindow window(tests::services());
  window.show();
  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(folder.filePath("dropped.toml"))});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
  EXPECT_EQ(window.document().name(), "dropped");
  EXPECT_DOUBLE_EQ(window.document().description().motion.speed, 21);
}

// By another name of the file as well. A file that was written anew is shown as it is now, called and coloured as
// before.
TEST(Habits, aResultThatIsOpenedAgainIsListedOnce) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("run.h5"), link = folder.filePath("link.h5");
  auto result = tests::syntheticResult();
  results::writeResult(path.toStdString(), result);
  ASSERT_TRUE(QFile::link(path, link));
  MainWindow window(tests::services());
  RunStore& store = window.store();
  ASSERT_TRUE(window.openResult(path));
  store.add(madeUp("another"));
  store.rename(0, "mine");
  store.setColour(0, QColor("#123456"));
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  ASSERT_TRUE(window.openResult(link)) << window.messages()->text().toStdString();
  EXPECT_EQ(store.rowCount(), 2);
  EXPECT_EQ(store.current(), 0);
  for (double& value : result.channel("aba")->values) value *= 2;
  results::writeResult(path.toStdString(), result);
  ASSERT_TRUE(window.openResult(link)) << window.messages()->text().toStdString();
  ASSERT_EQ(store.rowCount(), 2);
  EXPECT_EQ(*store.currentResult()->signal("aba"), *result.signal("aba"));
  const StoredRun& now = store.at(store.current());
  EXPECT_EQ(now.label, "mine");
  EXPECT_EQ(now.colour, QColor("#123456"));
  EXPECT_TRUE(now.overlaid);
  EXPECT_EQ(now.path, path);
}

// The same column again: overlaid where it was hidden, laid as it was, with the values that the file has now.
TEST(Habits, aMeasuredSignalThatIsOpenedAgainIsListedOnce) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("measured.csv");
  ASSERT_NO_FATAL_FAILURE(writeMeasured(path, 70));
  MainWindow window(tests::services());
  RunStore& store = window.store();
  const auto largest = [&] {
    const auto& values = *store.at(0).record->signal("aba");
    return *std::max_element(values.begin(), values.end());
  };
  ASSERT_TRUE(window.openMeasured(path)) << window.messages()->text().toStdString();
  auto reading = store.at(0).reading;
  reading.gain = 1.5;
  store.setMeasured(0, project::realigned({store.at(0).record, store.at(0).reading}, reading));
  store.setData(store.index(0), Qt::Unchecked, Qt::CheckStateRole);
  ASSERT_TRUE(window.openMeasured(path)) << window.messages()->text().toStdString();
  ASSERT_EQ(store.rowCount(), 1);
  EXPECT_TRUE(store.at(0).overlaid);
  EXPECT_DOUBLE_EQ(largest(), 1.5 * 70);
  ASSERT_NO_FATAL_FAILURE(writeMeasured(path, 80));
  ASSERT_TRUE(window.openMeasured(path)) << window.messages()->text().toStdString();
  ASSERT_EQ(store.rowCount(), 1);
  EXPECT_DOUBLE_EQ(largest(), 1.5 * 80);
  // At another speed it is another signal.
  window.document().setParameter("motion.speed", "40");
  ASSERT_TRUE(window.openMeasured(path)) << window.messages()->text().toStdString();
  EXPECT_EQ(store.rowCount(), 2);
}

TEST(Habits, unsavedResultsAreAskedAboutOnClosing) {
  std::vector<QString> questions;
  Answer answer = Answer::cancel;
  StudioServices services = tests::services();
  services.asker = [&](QWidget*, const QString& question, const QString&) {
    questions.push_back(question);
    return answer;
  };
  MainWindow window(services);
  window.show();
  window.store().add(madeUp("kept", "/somewhere/kept.h5"));
  EXPECT_TRUE(window.close());
  EXPECT_TRUE(questions.empty());  // it is in a file
  window.show();
  window.store().add(madeUp("fresh"));
  EXPECT_FALSE(window.close());
  ASSERT_EQ(questions.size(), 1u);
  EXPECT_TRUE(questions[0].contains("fresh")) << questions[0].toStdString();
  answer = Answer::discard;
  EXPECT_TRUE(window.close());
}

TEST(Habits, savingOnClosingAsksForAPlace) {
  const QTemporaryDir folder;
  StudioServices services = tests::services(50, Answer::save);
  MainWindow window(services);
  window.show();
  window.store().add(madeUp("fresh"));
  tests::FileDialogTyping typing(folder.filePath("fresh.h5"));
  EXPECT_TRUE(window.close());
  EXPECT_TRUE(typing.done());
  EXPECT_TRUE(QFileInfo::exists(folder.filePath("fresh.h5")));
}

// An upgrade finds the settings of the version before, once; what the new one keeps stays.
TEST(EarlierSettings, areTakenWhereThereAreNoneYet) {
  const QString name = QApplication::applicationName();
  QApplication::setApplicationName("upgraded");  // the settings of the other tests stay
  QSettings own, earlier("Another name", "upgraded");
  earlier.setValue("records/folder", "day 1");
  earlier.sync();
  takeSettingsFrom("Another name");
  EXPECT_EQ(own.value("records/folder").toString(), "day 1");
  own.setValue("records/folder", "day 2");
  takeSettingsFrom("Another name");
  EXPECT_EQ(own.value("records/folder").toString(), "day 2");
  QApplication::setApplicationName(name);
}

}  // namespace
}  // namespace squat::studio
