// A label that was given by a wrong key is one step away, in the window of long records alone.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "case/CaseFile.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "plots/Style.h"
#include "project/ProjectFile.h"
#include "records/Overview.h"
#include "studio/common/MessageBar.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/records/RecordView.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

constexpr auto withShift = Qt::ControlModifier | Qt::ShiftModifier;

// Squats of one channel, in the order of the positions [m].
ReportPointer squatsAt(const std::vector<double>& positions, const std::string& record = "ride.csv") {
  project::EventList list;
  list.records = {record};
  for (const double position : positions) {
    project::ListedEvent event;
    event.position = position;
    event.record = record;
    event.channel = "aba";
    event.kind = "squat", event.severity = "light";
    event.sureness = 0.8, event.peak = 60, event.speed = 30;
    list.events.push_back(event);
  }
  return reportOf(list, {});
}

QString labelOf(const QAbstractItemModel& model, int row) {
  return model.index(row, EventModel::seen).data().toString();
}

bool setLabel(QAbstractItemModel& model, int row, const QString& label) {
  return model.setData(model.index(row, EventModel::seen), label, Qt::EditRole);
}

TEST(LabelUndo, goesBackAndForthLabelByLabel) {
  EventModel model;
  model.setReport(squatsAt({52.5, 80}));
  QUndoStack& stack = model.undoStack();
  ASSERT_TRUE(setLabel(model, 0, "severe squat"));
  ASSERT_TRUE(setLabel(model, 1, "light squat"));
  ASSERT_TRUE(setLabel(model, 0, "weld"));
  EXPECT_EQ(stack.undoText(), "label of event at 52.50 m");
  const QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  stack.undo();
  EXPECT_EQ(labelOf(model, 0), "severe squat");
  EXPECT_EQ(changes.count(), 1);  // what keeps labels hears of it
  EXPECT_EQ(stack.undoText(), "label of event at 80.00 m");
  stack.undo();
  stack.undo();
  EXPECT_EQ(labelOf(model, 0), "");
  EXPECT_EQ(labelOf(model, 1), "");
  EXPECT_TRUE(model.seenEvents().empty());
  EXPECT_FALSE(stack.canUndo());
  while (stack.canRedo()) stack.redo();
  EXPECT_EQ(labelOf(model, 0), "weld");
  EXPECT_EQ(labelOf(model, 1), "light squat");
}

TEST(LabelUndo, hasStepsForChangesOfTheUserAlone) {
  EventModel model;
  model.setReport(squatsAt({52.5, 80}));
  EXPECT_TRUE(model.see({80, "aba", "weld"}));  // of a project
  EXPECT_EQ(model.undoStack().count(), 0);
  EXPECT_TRUE(setLabel(model, 1, "weld"));  // it is already
  EXPECT_FALSE(setLabel(model, 1, "no label"));
  EXPECT_EQ(model.undoStack().count(), 0);
  EXPECT_TRUE(setLabel(model, 1, ""));
  EXPECT_EQ(model.undoStack().count(), 1);
  model.undoStack().undo();
  EXPECT_EQ(labelOf(model, 1), "weld");
}

// Two events may stand in one place, and rows wherever the list is sorted to.
TEST(LabelUndo, isOfTheEventWhateverItsRow) {
  EventModel model;
  model.setReport(squatsAt({80, 80, 52.5}));
  QSortFilterProxyModel sorted;
  sorted.setSourceModel(&model);
  sorted.setSortRole(EventModel::sortRole);
  ASSERT_TRUE(setLabel(sorted, 1, "weld"));
  ASSERT_TRUE(setLabel(sorted, 2, "joint"));
  sorted.sort(EventModel::position, Qt::AscendingOrder);
  ASSERT_EQ(labelOf(sorted, 0), "joint");  // that at 52.5 m
  model.undoStack().undo();
  model.undoStack().undo();
  for (int row = 0; row < 3; ++row) EXPECT_EQ(labelOf(model, row), "") << row;
  model.undoStack().redo();
  EXPECT_EQ(labelOf(model, 0), "");
  EXPECT_EQ(labelOf(model, 1), "weld");
  EXPECT_EQ(labelOf(model, 2), "");
}

// The steps before are of events that are not listed any more. Labels of the same record stay.
TEST(LabelUndo, endsWithAnotherList) {
  EventModel model;
  model.setReport(squatsAt({52.5, 80}));
  ASSERT_TRUE(setLabel(model, 1, "weld"));
  model.setReport(squatsAt({80.1}));  // searched again: within half a metre
  EXPECT_EQ(labelOf(model, 0), "weld");
  EXPECT_EQ(model.undoStack().count(), 0);
  ASSERT_TRUE(setLabel(model, 0, "joint"));
  model.setReport(squatsAt({80}, "other.csv"));
  EXPECT_EQ(labelOf(model, 0), "");
  EXPECT_EQ(model.undoStack().count(), 0);
  ASSERT_TRUE(setLabel(model, 0, "joint"));
  model.setReport(nullptr);
  EXPECT_EQ(model.undoStack().count(), 0);
}

class LabelKeys : public testing::Test {
 protected:
  void SetUp() override {
    view_.setReport(squatsAt({52.5, 80}), folder_.path());
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
    view_.table()->setFocus();
    view_.table()->setCurrentIndex(list().index(0, 0));
  }
  const QAbstractItemModel& list() const { return *view_.table()->model(); }
  QAction* action(const char* name) const { return view_.findChild<QAction*>(name); }
  void undo() { tests::press(view_, Qt::Key_Z, Qt::ControlModifier); }

  QTemporaryDir folder_;
  RecordView view_{plots::lightStyle()};
};

TEST_F(LabelKeys, takeBackTheLabelOfAWrongKey) {
  EXPECT_FALSE(action("undoLabel")->isEnabled());
  EXPECT_EQ(action("undoLabel")->text(), "&Undo");
  tests::press(view_, Qt::Key_3);
  tests::press(view_, Qt::Key_N);
  tests::press(view_, Qt::Key_5);
  ASSERT_EQ(labelOf(list(), 0), EventModel::labels()[3]);
  ASSERT_EQ(labelOf(list(), 1), EventModel::labels()[5]);
  EXPECT_EQ(action("undoLabel")->text(), "&Undo label of event at 80.00 m");
  const QSignalSpy changes(&view_, &RecordView::changed);
  undo();
  EXPECT_EQ(labelOf(list(), 1), "");
  EXPECT_EQ(view_.table()->currentIndex().row(), 1);
  undo();
  EXPECT_EQ(labelOf(list(), 0), "");
  EXPECT_EQ(view_.table()->currentIndex().row(), 0) << "the event whose label changes is shown";
  EXPECT_EQ(changes.count(), 2);
  EXPECT_FALSE(view_.findChild<QPushButton*>("saveLabels")->isEnabled());
  EXPECT_FALSE(action("undoLabel")->isEnabled());
  EXPECT_EQ(action("redoLabel")->text(), "&Redo label of event at 52.50 m");
  tests::press(view_, Qt::Key_Z, withShift);
  EXPECT_EQ(labelOf(list(), 0), EventModel::labels()[3]);
  EXPECT_EQ(labelOf(list(), 1), "");
}

// Rows that the filter hides have no place in the list; their labels go back all the same.
TEST_F(LabelKeys, workWhereTheEventIsFilteredAway) {
  tests::press(view_, Qt::Key_3);
  view_.table()->setCurrentIndex(list().index(1, 0));
  view_.findChild<QLineEdit*>("eventFilter")->setText("80.00");
  ASSERT_EQ(list().rowCount(), 1);
  undo();
  EXPECT_EQ(view_.table()->currentIndex().row(), 0) << "the other event stays chosen";
  EXPECT_TRUE(view_.model()->seenEvents().empty());
}

TEST_F(LabelKeys, restDuringASearch) {
  tests::press(view_, Qt::Key_3);
  view_.follow(std::make_shared<records::Overview>());
  EXPECT_FALSE(action("undoLabel")->isEnabled());
  view_.stopFollowing();  // it was cancelled: the list is the one before
  EXPECT_TRUE(action("undoLabel")->isEnabled());
  view_.table()->setFocus();  // which it lost while it was disabled
  undo();
  EXPECT_EQ(labelOf(list(), 0), "");
}

class LabelsOfAProject : public testing::Test {
 protected:
  void SetUp() override {
    write("ride.csv", "time [s],speed [m/s],aba [m/s2]\n0,30,1\n0.001,30,2\n0.002,30,1\n");
    write("squats.json", R"({"schema": "squat-detection", "schema_version": 1, "records": [{"path": "ride.csv"}],
    "events": [{"position_m": 100, "time_s": 1, "record": "ride.csv", "channel": "aba", "kind": "squat",
                "severity": "light", "length_mm": [45, 30, 60], "depth_mm": [0.2, 0.1, 0.3], "sureness": 0.8,
                "peak_m_s2": 60, "speed_m_s": 30, "passes": 1, "passes_there": 1}]})");
    project::Project project;
    project.open = {"dip", "", false, cases::writeCase(cases::defaultCase())};
    project.records.files = {path("ride.csv").toStdString()};
    project.records.events = path("squats.json").toStdString();
    project::writeProject(path("ride.squat-project").toStdString(), project);
    window_.show();
    ASSERT_TRUE(window_.openProject(path("ride.squat-project"))) << window_.messages()->text().toStdString();
    window_.findChild<QAction*>("squatsAction")->trigger();
    tool_ = window_.tool("squats");
    ASSERT_TRUE(QTest::qWaitForWindowExposed(tool_));
    view_ = qobject_cast<DetectionForm*>(tool_->form())->records();
    ASSERT_TRUE(view_->model()->report()) << tool_->messages()->text().toStdString();
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  void write(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  QString label() const { return labelOf(*view_->model(), 0); }
  std::vector<project::SeenEvent> saved() {
    window_.keeper()->saveNow();
    return project::readProject(path("ride.squat-project").toStdString()).records.seen;
  }

  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
  ToolWindow* tool_ = nullptr;
  RecordView* view_ = nullptr;
};

TEST_F(LabelsOfAProject, areKeptAsTheyAreAfterUndo) {
  view_->table()->setFocus();
  view_->table()->setCurrentIndex(view_->table()->model()->index(0, 0));
  tests::press(*tool_, Qt::Key_3);
  ASSERT_EQ(saved().size(), 1U);
  tests::press(*tool_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(saved().empty());
  tool_->form()->findChild<QLineEdit*>("channels")->setFocus();  // nothing is typed there
  tests::press(*tool_, Qt::Key_Z, withShift);
  const auto again = saved();
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].seenAs, EventModel::labels()[3].toStdString());
  EXPECT_EQ(view_->model()->undoStack().count(), 1);
  ASSERT_TRUE(window_.closeProject());
  EXPECT_EQ(view_->model()->undoStack().count(), 0);
}

// Each window undoes what was done in it.
TEST_F(LabelsOfAProject, andTheCaseDoNotMix) {
  EXPECT_FALSE(window_.document().isModified());
  view_->table()->setFocus();
  view_->table()->setCurrentIndex(view_->table()->model()->index(0, 0));
  tests::press(*tool_, Qt::Key_3);
  EXPECT_FALSE(window_.document().isModified());
  ASSERT_FALSE(window_.document().setParameter("motion.speed", "25"));
  tests::press(*tool_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(label(), "");
  EXPECT_EQ(window_.document().description().motion.speed, 25);
  tests::press(*tool_, Qt::Key_Z, Qt::ControlModifier);  // no label is left, and the case is out of reach
  EXPECT_EQ(window_.document().description().motion.speed, 25);
  tests::press(*tool_, Qt::Key_Z, withShift);
  EXPECT_NE(label(), "");
  window_.document().undoStack().undo();
  EXPECT_NE(label(), "");
  EXPECT_FALSE(window_.document().isModified());
}

}  // namespace
}  // namespace squat::studio
