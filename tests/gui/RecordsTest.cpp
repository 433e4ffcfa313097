// Long records in the studio: the search is that of the command, the strip shows every strike, events lead to figures.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ShippedCases.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "project/FileDigest.h"
#include "project/ProjectFile.h"
#include "studio/common/MessageBar.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/records/EventInspector.h"
#include "studio/records/RecordView.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/EstimateForm.h"
#include "studio/tools/TargetList.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

class Records : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tools");
    record_ = QString::fromStdString((cases::resourcesFolder() / "records/example-record.csv").string());
    window_.show();
    window_.findChild<QAction*>("squatsAction")->trigger();
    tool_ = window_.tool("squats");
    tool_->setFolder(path("studio"));
    form_ = qobject_cast<DetectionForm*>(tool_->form());
    view_ = form_->records();
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void search() {
    form_->addRecord(record_);
    form_->findChild<QDoubleSpinBox*>("recordSpeed")->setValue(30);  // the file has times alone
    tool_->start();
    ASSERT_TRUE(tests::passes([&] { return !tool_->isBusy(); }, tests::patience));
    ASSERT_TRUE(view_->model()->report()) << tool_->messages()->text().toStdString();
  }
  const QAbstractItemModel& seen() const { return *view_->table()->model(); }
  static DetectionForm* formIn(MainWindow& window) {
    return qobject_cast<DetectionForm*>(window.tool("squats")->form());
  }
  // The row of the first event of a kind, as the list stands.
  int rowOf(const QString& kind) const {
    for (int row = 0; row < seen().rowCount(); ++row)
      if (seen().index(row, EventModel::kind).data().toString() == kind) return row;
    return -1;
  }

  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
  QString record_;
  ToolWindow* tool_ = nullptr;
  DetectionForm* form_ = nullptr;
  RecordView* view_ = nullptr;
};

TEST_F(Records, theSearchIsThatOfTheCommand) {
  ASSERT_NO_FATAL_FAILURE(search());
  QProcess program;
  program.setWorkingDirectory(folder_.path());
  program.start(SQUAT_PROGRAM, {"detect", record_, "--speed", "30", "-o", "command", "--no-figures"});
  ASSERT_TRUE(program.waitForFinished(tests::patience));
  ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  EXPECT_EQ(read("studio/squats.csv"), read("command/squats.csv"));
  EXPECT_EQ(read("studio/squats.json"), read("command/squats.json"));
  EXPECT_GT(read("studio/squats.csv").count('\n'), 5);
  EXPECT_EQ(read("studio/passages/squat-0001.csv"), read("command/passages/squat-0001.csv"));
  EXPECT_TRUE(tool_->text().contains("kinds and severities from")) << tool_->text().toStdString();
  EXPECT_FALSE(read("studio/overview.png").isEmpty());
  // The list is that of the file, in its order.
  const auto rows = read("studio/squats.csv").split('\n');
  ASSERT_EQ(seen().rowCount(), rows.size() - 2);
  for (int row = 0; row < seen().rowCount(); ++row)
    EXPECT_NEAR(seen().index(row, EventModel::position).data().toDouble(), rows[row + 1].split(',')[0].toDouble(),
                0.0051);
}

// It has times alone: the speed is asked for.
TEST_F(Records, aRecordIsSeenBeforeAnythingIsLookedForInIt) {
  form_->addRecord(record_);
  EXPECT_TRUE(tests::passes([&] { return tool_->messages()->text().contains("states no speed"); }, tests::patience));
  form_->findChild<QDoubleSpinBox*>("recordSpeed")->setValue(30);
  EXPECT_EQ(tool_->messages()->text(), "");
  const auto* signal = view_->strip()->figure()->graph(0);
  EXPECT_TRUE(tests::passes([&] { return !view_->isReading() && signal->dataCount() > 100; }, tests::patience));
  EXPECT_NEAR(view_->strip()->figure()->xAxis->range().size(), 300, 1);  // [m]: 10 s at 30 m/s
  delete form_->findChild<QListWidget*>()->takeItem(0);
  EXPECT_TRUE(tests::passes([&] { return signal->dataCount() == 0; }, tests::patience));
}

// What stands in the line and in the figures is of the event that is chosen, with its ranges.
TEST_F(Records, anEventIsSeenClose) {
  ASSERT_NO_FATAL_FAILURE(search());
  const auto* words = view_->findChild<QLabel*>("eventWords");
  EXPECT_EQ(words->text(), "");
  view_->table()->setFocus();
  view_->table()->setCurrentIndex(seen().index(0, 0));
  QTest::keyClick(view_->table(), Qt::Key_N);
  QTest::keyClick(view_->table(), Qt::Key_N);
  EXPECT_EQ(view_->table()->currentIndex().row(), 2);
  QTest::keyClick(view_->table(), Qt::Key_P);
  EXPECT_EQ(view_->table()->currentIndex().row(), 1);
  const int row = rowOf("squat");
  ASSERT_GE(row, 0);
  view_->table()->setCurrentIndex(seen().index(row, 0));
  const auto& rows = read("studio/squats.csv").split('\n');
  const auto names = rows[0].split(','), values = rows[row + 1].split(',');
  const auto figure = [&](const char* name) { return values[names.indexOf(name)].toDouble(); };
  for (const char* name : {"length [mm]", "length low [mm]", "length high [mm]"})
    EXPECT_TRUE(words->text().contains(QString::number(figure(name), 'f', 0))) << name << words->text().toStdString();
  const auto figures = view_->inspector()->findChildren<plots::Figure*>();
  ASSERT_EQ(figures.size(), 2);
  for (const plots::Figure* each : figures) {
    EXPECT_TRUE(each->isVisible());
    EXPECT_LE(each->xAxis->range().size(), 1500);  // [mm]
  }
  // Keys set the label that the list has at that place.
  QTest::keyClick(view_->table(), Qt::Key_3);
  EXPECT_EQ(seen().index(row, EventModel::seen).data().toString(), EventModel::labels()[3]);
  QTest::keyClick(view_->table(), Qt::Key_0);
  EXPECT_EQ(seen().index(row, EventModel::seen).data().toString(), "");
}

TEST_F(Records, theStripShowsTheRecordAndItsEvents) {
  ASSERT_NO_FATAL_FAILURE(search());
  const plots::Figure* figure = view_->strip()->figure();
  const QCPRange whole = figure->xAxis->range();
  EXPECT_GT(whole.size(), 100);  // some hundred metres
  ASSERT_GT(figure->graphCount(), 1);
  // The signal reaches up to the strongest event of the channel, which filters may have lowered a little.
  double strongest = 0;
  for (int row = 0; row < view_->model()->rowCount(); ++row)
    if (const auto& event = view_->model()->at(row).event;
        QString::fromStdString(event.channel) == view_->strip()->channel())
      strongest = std::max(strongest, event.peak);
  double largest = 0;
  for (const auto& point : *figure->graph(0)->data()) largest = std::max(largest, std::abs(point.value));
  EXPECT_GT(largest, 0.8 * strongest);
  // A row shows its place, a double click the whole again.
  const int row = rowOf("squat");
  ASSERT_GE(row, 0);
  view_->table()->setCurrentIndex(seen().index(row, 0));
  EXPECT_NEAR(view_->strip()->figure()->xAxis->range().center(), seen().index(row, 0).data().toDouble(), 0.01);
  view_->strip()->showWhole();
  EXPECT_EQ(view_->strip()->figure()->xAxis->range(), whole);
}

TEST_F(Records, theListIsFilteredAndSorted) {
  ASSERT_NO_FATAL_FAILURE(search());
  const int all = seen().rowCount();
  view_->findChild<QLineEdit*>("eventFilter")->setText("squat");
  EXPECT_LT(seen().rowCount(), all);
  EXPECT_GT(seen().rowCount(), 0);
  for (int row = 0; row < seen().rowCount(); ++row)
    EXPECT_EQ(seen().index(row, EventModel::kind).data().toString(), "squat");
  view_->table()->sortByColumn(EventModel::peak, Qt::DescendingOrder);
  for (int row = 1; row < seen().rowCount(); ++row)
    EXPECT_GE(seen().index(row - 1, EventModel::peak).data(EventModel::sortRole).toDouble(),
              seen().index(row, EventModel::peak).data(EventModel::sortRole).toDouble());
}

TEST_F(Records, anEventLeadsToTheFiguresAndToItsProfile) {
  ASSERT_NO_FATAL_FAILURE(search());
  auto* show = view_->findChild<QPushButton*>("showEvent");
  EXPECT_FALSE(show->isEnabled());
  view_->table()->setCurrentIndex(seen().index(rowOf("squat"), 0));
  ASSERT_TRUE(show->isEnabled());
  show->click();
  ASSERT_EQ(window_.store().rowCount(), 1) << window_.messages()->text().toStdString();
  EXPECT_TRUE(window_.store().at(0).isMeasured());
  EXPECT_EQ(window_.signalsPanel()->currentTab(), "aba_position");
  // What is no squat as well.
  for (int row = 0; row < seen().rowCount(); ++row) {
    if (seen().index(row, EventModel::kind).data().toString() == "squat") continue;
    view_->table()->setCurrentIndex(seen().index(row, 0));
    show->click();
    EXPECT_EQ(window_.store().rowCount(), 2) << window_.messages()->text().toStdString();
    break;
  }
  view_->table()->setCurrentIndex(seen().index(rowOf("squat"), 0));
  view_->findChild<QPushButton*>("estimateEvent")->click();
  const auto* estimate = qobject_cast<EstimateForm*>(window_.tool("estimate")->form());
  ASSERT_EQ(estimate->passages()->files().size(), 1);
  EXPECT_EQ(window_.store().rowCount(), 2) << "the passage of this squat is overlaid already";
  const QString first = estimate->passages()->files()[0];
  EXPECT_TRUE(first.contains("passages/squat-")) << first.toStdString();
  // Another event takes its place: it is another defect.
  view_->table()->setCurrentIndex(seen().index(rowOf("squat") + 2, 0));
  view_->findChild<QPushButton*>("estimateEvent")->click();
  ASSERT_EQ(estimate->passages()->files().size(), 1);
  EXPECT_NE(estimate->passages()->files()[0], first);
  EXPECT_EQ(window_.store().rowCount(), 3) << "its signal is overlaid on the runs as well";
}

TEST_F(Records, whatWasSeenIsSavedAsLabels) {
  ASSERT_NO_FATAL_FAILURE(search());
  auto* save = view_->findChild<QPushButton*>("saveLabels");
  EXPECT_FALSE(save->isEnabled());
  const int first = rowOf("squat");
  QAbstractItemModel& list = *view_->table()->model();
  ASSERT_TRUE(list.setData(list.index(first, EventModel::seen), "severe squat", Qt::EditRole));
  ASSERT_TRUE(list.setData(list.index(first + 2, EventModel::seen), "light squat", Qt::EditRole));
  ASSERT_TRUE(save->isEnabled());
  {
    tests::FileDialogTyping typing(path("labels.csv"));
    save->click();
    ASSERT_TRUE(typing.done());
  }
  const auto labels = detection::readLabels(path("labels.csv").toStdString());
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_NEAR(labels[0].position, list.index(first, EventModel::position).data().toDouble(), 0.0051);
  EXPECT_EQ(labels[0].kind, detection::Kind::squat);
  EXPECT_EQ(labels[0].severity, detection::Severity::severe);
  EXPECT_EQ(labels[1].severity, detection::Severity::light);
  EXPECT_FALSE(labels[1].hasSize()) << "a severity says no size";
  // The next search takes it, and lists it so.
  EXPECT_EQ(form_->findChild<QLineEdit*>("labels")->text(), path("labels.csv"));
  tool_->start();
  ASSERT_TRUE(tests::passes([&] { return !tool_->isBusy(); }, tests::patience));
  EXPECT_TRUE(tool_->text().contains("2 labels of")) << tool_->text().toStdString();
  ASSERT_EQ(view_->model()->seenEvents().size(), 2U);  // they are still there
  EXPECT_EQ(view_->model()->seenEvents()[0].severity, detection::Severity::severe);
  EXPECT_EQ(read("studio/squats.csv").count("as labelled"), 2);
}

// Record, options, list and labels: the same after a night, whatever the window of records was used for meanwhile.
TEST_F(Records, comeBackInAProject) {
  form_->findChild<QLineEdit*>("chainage")->setText("12+300");
  ASSERT_TRUE(window_.saveProjectTo(path("day.squat-project"))) << window_.messages()->text().toStdString();
  ASSERT_NO_FATAL_FAILURE(search());
  QFile labels(path("labels.csv"));  // for the next search
  ASSERT_TRUE(labels.open(QIODevice::WriteOnly));
  labels.close();
  form_->findChild<QLineEdit*>("labels")->setText(labels.fileName());
  const int squat = rowOf("squat");
  ASSERT_GE(squat, 0);
  view_->table()->model()->setData(seen().index(squat, EventModel::seen), "severe squat", Qt::EditRole);
  QStringList before;
  for (int row = 0; row < seen().rowCount(); ++row)
    for (const int column : {EventModel::kind, EventModel::severity, EventModel::channel, EventModel::passes,
                             EventModel::sureness, EventModel::seen})
      before << seen().index(row, column).data().toString();
  const double first = seen().index(0, EventModel::position).data().toDouble();
  EXPECT_GT(first, 12000);  // from the chainage that was typed
  // Saved by itself.
  EXPECT_TRUE(tests::passes([this] { return read("day.squat-project").contains("severe squat"); }, 20000));
  ASSERT_TRUE(window_.closeProject());
  EXPECT_FALSE(view_->model()->report());
  const QByteArray saved = read("day.squat-project");

  MainWindow tomorrow(tests::services());
  tomorrow.show();
  ASSERT_TRUE(tomorrow.openProject(path("day.squat-project"))) << tomorrow.messages()->text().toStdString();
  EXPECT_TRUE(tomorrow.messages()->isEmpty()) << tomorrow.messages()->text().toStdString();
  EXPECT_TRUE(tomorrow.tool("squats")->isVisible());  // as it was
  const DetectionForm* form = formIn(tomorrow);
  const auto* list = form->findChild<QListWidget*>();
  ASSERT_EQ(list->count(), 1);
  EXPECT_EQ(list->item(0)->text(), record_);
  EXPECT_EQ(form->findChild<QDoubleSpinBox*>("recordSpeed")->value(), 30);
  EXPECT_EQ(form->findChild<QLineEdit*>("chainage")->text(), "12+300");
  EXPECT_EQ(form->findChild<QLineEdit*>("labels")->text(), path("labels.csv"));
  EXPECT_EQ(tomorrow.tool("squats")->findChild<QLineEdit*>("toolFolder")->text(), path("studio"));
  RecordView* view = form->records();
  ASSERT_TRUE(tests::passes([&] { return !view->isReading(); }, tests::patience));
  EXPECT_TRUE(tomorrow.tool("squats")->messages()->isEmpty())
      << tomorrow.tool("squats")->messages()->text().toStdString();
  const QAbstractItemModel& again = *view->table()->model();
  QStringList after;
  for (int row = 0; row < again.rowCount(); ++row)
    for (const int column : {EventModel::kind, EventModel::severity, EventModel::channel, EventModel::passes,
                             EventModel::sureness, EventModel::seen})
      after << again.index(row, column).data().toString();
  EXPECT_EQ(after, before);
  // The file has millimetres, the table centimetres.
  EXPECT_NEAR(again.index(0, EventModel::position).data().toDouble(), first, 0.0101);
  EXPECT_GT(view->strip()->figure()->graph(0)->dataCount(), 100);  // the record itself
  EXPECT_GT(view->strip()->figure()->graphCount(), 1);             // and the marks
  tomorrow.keeper()->saveNow();
  EXPECT_EQ(read("day.squat-project"), saved);
  // The passages are where they were; the signal over another event is in no file before the next search.
  view->table()->setCurrentIndex(again.index(squat, 0));
  view->findChild<QPushButton*>("showEvent")->click();
  EXPECT_EQ(tomorrow.store().rowCount(), 1) << tomorrow.messages()->text().toStdString();
  for (int row = 0; row < again.rowCount(); ++row) {
    if (again.index(row, EventModel::kind).data().toString() == "squat") continue;
    view->table()->setCurrentIndex(again.index(row, 0));
    view->findChild<QPushButton*>("showEvent")->click();
    EXPECT_TRUE(tomorrow.tool("squats")->messages()->text().contains("Start the search again"));
    EXPECT_FALSE(QFile::exists(path("studio/other-events")));
    break;
  }
  EXPECT_EQ(tomorrow.store().rowCount(), 1);
}

class RecordsOfAProject : public Records {
 protected:
  // The example, without a list, and nothing else.
  project::Project madeUp() const {
    project::Project project;
    project.open = {"dip", "", false, cases::writeCase(cases::defaultCase())};
    project.records.files = {record_.toStdString()};
    project.records.speed = 30;
    return project;
  }
  void write(const project::Project& project) const {
    project::writeProject(path("day.squat-project").toStdString(), project);
  }
  static QString detailsOf(const MessageBar& messages) { return messages.text() + messages.details(); }
};

// Gigabytes are not read for a window that nobody looks at.
TEST_F(RecordsOfAProject, areReadWhenTheyAreLookedAt) {
  write(madeUp());
  tool_->hide();
  ASSERT_TRUE(window_.openProject(path("day.squat-project"))) << window_.messages()->text().toStdString();
  EXPECT_FALSE(tool_->isVisible());
  EXPECT_FALSE(view_->isReading());
  window_.findChild<QAction*>("squatsAction")->trigger();
  EXPECT_TRUE(view_->isReading());
  ASSERT_TRUE(tests::passes([this] { return !view_->isReading(); }, tests::patience));
  EXPECT_GT(view_->strip()->figure()->graph(0)->dataCount(), 100);
  EXPECT_GT(view_->strip()->figure()->xAxis->range().size(), 100);
  // Left in the middle of it: nothing of it comes later.
  ASSERT_TRUE(window_.closeProject());
  EXPECT_EQ(view_->strip()->figure()->graph(0)->dataCount(), 0);
  ASSERT_TRUE(window_.openProject(path("day.squat-project")));
  ASSERT_TRUE(window_.closeProject());
  EXPECT_FALSE(tests::passes([this] { return view_->strip()->figure()->graph(0)->dataCount() > 0; }, 500));
  EXPECT_EQ(form_->findChild<QListWidget*>()->count(), 0);
}

TEST_F(RecordsOfAProject, thatAreMissingAreNamedAndStay) {
  auto project = madeUp();
  project.records.files.push_back(path("gone.csv").toStdString());
  project.records.labels = path("labels.csv").toStdString();
  project.records.events = path("found/squats.json").toStdString();
  project.records.seen = {{12.5, "left", "light squat"}};
  project.notes = "a note\n";
  write(project);
  ASSERT_TRUE(window_.openProject(path("day.squat-project")));
  EXPECT_TRUE(window_.messages()->text().contains("3 files")) << window_.messages()->text().toStdString();
  for (const char* name : {"gone.csv", "labels.csv", "found/squats.json"})
    EXPECT_TRUE(detailsOf(*window_.messages()).contains(path(name))) << name;
  // The record that is there is read for all that.
  ASSERT_TRUE(tests::passes([this] { return !view_->isReading(); }, tests::patience));
  EXPECT_GT(view_->strip()->figure()->graph(0)->dataCount(), 100);
  EXPECT_TRUE(detailsOf(*tool_->messages()).contains("squats.json"));
  window_.keeper()->saveNow();
  const auto kept = project::readProject(path("day.squat-project").toStdString());
  EXPECT_EQ(kept.records.files, project.records.files);
  EXPECT_EQ(kept.records.labels, project.records.labels);
  EXPECT_EQ(kept.records.events, project.records.events);
  ASSERT_EQ(kept.records.seen.size(), 1U);
  EXPECT_EQ(kept.records.seen[0].seenAs, "light squat");
  EXPECT_EQ(kept.notes, "a note\n");
}

// Size and both ends are compared, in a thread; said once, as of runs.
TEST_F(RecordsOfAProject, thatHaveChangedAreNamed) {
  QFile record(path("record.csv"));
  ASSERT_TRUE(QFile::copy(record_, record.fileName()));
  ASSERT_TRUE(record.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
  auto project = madeUp();
  project.records.files = {record.fileName().toStdString()};
  write(project);
  const auto digest = [this] {
    const auto digests = project::readProject(path("day.squat-project").toStdString()).records.digests;
    return digests.empty() ? std::string() : digests.at(0);
  };
  const auto isKept = [&] { return digest() == project::fileDigest(record.fileName().toStdString()); };
  ASSERT_TRUE(window_.openProject(path("day.squat-project"))) << window_.messages()->text().toStdString();
  EXPECT_TRUE(tests::passes(isKept, 20000));  // of a project that had none
  ASSERT_TRUE(window_.closeProject());
  ASSERT_TRUE(window_.openProject(path("day.squat-project")));
  ASSERT_TRUE(tests::passes([this] { return !view_->isReading(); }, tests::patience));
  EXPECT_TRUE(window_.messages()->isEmpty()) << window_.messages()->text().toStdString();  // it is as it was
  ASSERT_TRUE(window_.closeProject());
  ASSERT_TRUE(record.open(QIODevice::Append));
  record.write("999,0,0\n");
  record.close();
  ASSERT_TRUE(window_.openProject(path("day.squat-project")));
  EXPECT_TRUE(tests::passes([this] { return window_.messages()->text().contains("1 file"); }, 20000));
  EXPECT_TRUE(detailsOf(*window_.messages()).contains(record.fileName() + " holds other values"))
      << detailsOf(*window_.messages()).toStdString();
  EXPECT_TRUE(tests::passes(isKept, 20000));
  ASSERT_TRUE(window_.closeProject());
  // Missing for a day, it is known again.
  const std::string before = digest();
  ASSERT_TRUE(record.rename(path("elsewhere.csv")));
  ASSERT_TRUE(window_.openProject(path("day.squat-project")));
  ASSERT_TRUE(window_.closeProject());
  EXPECT_EQ(digest(), before);
}

TEST_F(RecordsOfAProject, areListedInItsOrder) {
  auto project = madeUp();
  project.records.order = {"peak", true, "", "squat"};
  write(project);
  ASSERT_TRUE(window_.openProject(path("day.squat-project"))) << window_.messages()->text().toStdString();
  const QHeaderView* heading = view_->table()->horizontalHeader();
  const auto* filter = view_->findChild<QLineEdit*>("eventFilter");
  EXPECT_EQ(heading->sortIndicatorSection(), EventModel::peak);
  EXPECT_EQ(heading->sortIndicatorOrder(), Qt::DescendingOrder);
  EXPECT_EQ(filter->text(), "squat");
  view_->table()->sortByColumn(EventModel::seen, Qt::AscendingOrder);
  window_.keeper()->saveNow();
  EXPECT_EQ(project::readProject(path("day.squat-project").toStdString()).records.order,
            (project::TableOrder{"seen_as", false, "", "squat"}));
  ASSERT_TRUE(window_.closeProject());  // the next work begins without
  EXPECT_EQ(heading->sortIndicatorSection(), -1);
  EXPECT_EQ(filter->text(), "");
}

// A search writes its list into the project that is open when it ends: that must not be another one.
TEST_F(RecordsOfAProject, areNotExchangedDuringASearch) {
  write(madeUp());
  form_->addRecord(record_);
  form_->findChild<QDoubleSpinBox*>("recordSpeed")->setValue(30);
  tool_->start();
  ASSERT_TRUE(tool_->isBusy());
  EXPECT_FALSE(window_.openProject(path("day.squat-project")));
  EXPECT_TRUE(window_.messages()->text().contains("search")) << window_.messages()->text().toStdString();
  EXPECT_FALSE(window_.closeProject());
  tool_->cancel();
  ASSERT_TRUE(tool_->waitFor(tests::patience));
  EXPECT_TRUE(window_.openProject(path("day.squat-project"))) << window_.messages()->text().toStdString();
}

TEST_F(Records, whatCannotBeReadIsSaid) {
  QFile file(path("nothing.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no record\n");
  file.close();
  tool_->start();
  ASSERT_TRUE(tests::passes([&] { return !tool_->isBusy(); }, tests::patience));
  EXPECT_TRUE(tool_->messages()->text().contains("Add a record")) << tool_->messages()->text().toStdString();
  form_->addRecord(file.fileName());
  tool_->start();
  ASSERT_TRUE(tests::passes([&] { return !tool_->isBusy(); }, tests::patience));
  EXPECT_TRUE(tool_->messages()->text().contains("nothing.csv")) << tool_->messages()->text().toStdString();
}

}  // namespace
}  // namespace squat::studio
