// The table of runs: names, columns, sorting, filtering, renaming and the menu of a run.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QStyleOptionViewItem>
#include <QTableView>
#include <QTest>

#include "case/MeshPresets.h"
#include "case/ParameterValue.h"
#include "gui/Hands.h"
#include "render/SyntheticResult.h"
#include "studio/runs/RunStore.h"
#include "studio/runs/RunsPanel.h"

namespace squat::studio {
namespace {

// The made-up result as that of the default case with these values, `factor` times as strong.
std::shared_ptr<results::RunResult> runOf(const std::vector<std::pair<const char*, const char*>>& settings,
                                          double factor = 1) {
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  cases::CaseDescription description = cases::defaultCase();
  for (const auto& [key, text] : settings) {
    if (std::string(key) == "mesh.preset") cases::applyPreset(description, *cases::presetNamed(text));
    cases::setValue(description, key, text);
  }
  results::setCase(*result, description);
  result->stem = "untitled";
  result->performance = {{"seconds", "s", "", 100 * factor}};
  for (double& value : result->channel("aba_filtered")->values) value *= factor;
  return result;
}

StoredRun computed(const ResultPointer& result) {
  return {result, QString(), QString(), false, result, nullptr, false};
}

class Runs : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(900, 220);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
  }
  void addThree() {
    store_.add(computed(runOf({{"defect.depth", "0.15"}}, 1)));
    store_.add(computed(runOf({{"defect.depth", "0.3"}, {"mesh.preset", "tiny"}}, 3)));
    store_.add(computed(runOf({{"defect.depth", "0.2"}}, 2)));
  }
  QStringList column(const QString& heading) const {
    const auto& seen = *panel_.table()->model();
    QStringList texts;
    for (int at = 0; at < seen.columnCount(); ++at)
      if (headings()[at] == heading)
        for (int row = 0; row < seen.rowCount(); ++row) texts << seen.index(row, at).data().toString();
    return texts;
  }
  QStringList headings() const {
    QStringList texts;
    for (int at = 0; at < panel_.table()->model()->columnCount(); ++at)
      texts << panel_.table()->model()->headerData(at, Qt::Horizontal).toString().replace('\n', ' ');
    return texts;
  }
  void clickHeading(int section) {
    QHeaderView* bar = panel_.table()->horizontalHeader();
    QTest::mouseClick(bar->viewport(), Qt::LeftButton, {},
                      {bar->sectionViewportPosition(section) + 10, bar->height() / 2});
  }

  RunStore store_;
  RunsPanel panel_{store_};
};

TEST_F(Runs, areCalledByWhatDiffersAndHaveAColumnForIt) {
  store_.add(computed(runOf({})));
  EXPECT_EQ(store_.at(0).label, "untitled");
  EXPECT_EQ(headings(), (QStringList{"Run", "Peak [m/s²]", "Lines [Hz]", "Mesh", "Computed in"}));
  store_.remove(0);
  addThree();
  EXPECT_EQ(headings(), (QStringList{"Run", "Peak [m/s²]", "Lines [Hz]", "Depth [mm]", "Mesh", "Computed in"}));
  EXPECT_EQ(column("Run"), (QStringList{"depth 0.15, draft *", "depth 0.3, tiny *", "depth 0.2, draft *"}));
  EXPECT_EQ(column("Depth [mm]"), (QStringList{"0.15", "0.3", "0.2"}));
  EXPECT_EQ(column("Mesh"), (QStringList{"draft", "tiny", "draft"}));
  EXPECT_EQ(column("Computed in"), (QStringList{"1 min 40 s", "5 min 0 s", "3 min 20 s"}));
  // The made-up lines stand at 300 and 1000 Hz; three times the signal is three times the peak.
  const auto peaks = column("Peak [m/s²]");
  EXPECT_NEAR(peaks[1].toDouble(), 3 * peaks[0].toDouble(), 0.2);
  EXPECT_NEAR(column("Lines [Hz]")[0].section(',', 0, 0).toDouble(), 300, 15) << column("Lines [Hz]")[0].toStdString();
  store_.remove(1);
  EXPECT_EQ(column("Run"), (QStringList{"depth 0.15 *", "depth 0.2 *"}));  // all of one mesh again
}

TEST_F(Runs, areRenamedInPlaceAndKeepTheName) {
  addThree();
  panel_.table()->setFocus();
  panel_.table()->setCurrentIndex(panel_.indexOf(1));
  tests::press(panel_, Qt::Key_F2);
  auto* editor = panel_.table()->findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  EXPECT_EQ(editor->text(), "depth 0.3, tiny");
  tests::type(panel_, "deep one");
  tests::press(panel_, Qt::Key_Return);
  EXPECT_EQ(store_.at(1).label, "deep one");
  EXPECT_EQ(column("Run")[1], "deep one *");
  store_.remove(0);
  EXPECT_EQ(store_.at(0).label, "deep one");
  store_.rename(0, "  ");  // as it was before anybody named it
  EXPECT_EQ(store_.at(0).label, "depth 0.3, tiny");
  store_.rename(1, "the other");  // what is left without a name still says how it differs
  EXPECT_EQ(store_.at(0).label, "depth 0.3, tiny");
}

TEST_F(Runs, sortAsNumbersAndComeBackInTheirOrder) {
  addThree();
  const int depth = static_cast<int>(headings().indexOf("Depth [mm]"));
  clickHeading(depth);
  EXPECT_EQ(column("Depth [mm]"), (QStringList{"0.15", "0.2", "0.3"}));
  clickHeading(1);
  const auto peaks = column("Peak [m/s²]");
  EXPECT_LT(peaks[0].toDouble(), peaks[1].toDouble());
  EXPECT_LT(peaks[1].toDouble(), peaks[2].toDouble());
  // The row that is clicked is the run that is shown, wherever it stands.
  const QModelIndex third = panel_.table()->model()->index(2, 0);
  QTest::mouseClick(panel_.table()->viewport(), Qt::LeftButton, {}, panel_.table()->visualRect(third).center());
  EXPECT_EQ(store_.current(), 1);
  clickHeading(1);
  clickHeading(1);
  EXPECT_EQ(column("Depth [mm]"), (QStringList{"0.15", "0.3", "0.2"}));
}

// As a project keeps it: by what a column is called, wherever it stands, and whether or not it is there yet.
TEST_F(Runs, standInTheOrderOfAProject) {
  store_.add(computed(runOf({{"defect.depth", "0.15"}}, 1)));
  panel_.setOrder({"defect.depth", true, "", ""});  // of one run there is no such column
  EXPECT_EQ(panel_.table()->horizontalHeader()->sortIndicatorSection(), -1);
  store_.add(computed(runOf({{"defect.depth", "0.3"}, {"mesh.preset", "tiny"}}, 3)));
  store_.add(computed(runOf({{"defect.depth", "0.2"}}, 2)));
  EXPECT_EQ(column("Depth [mm]"), (QStringList{"0.3", "0.2", "0.15"}));
  EXPECT_EQ(panel_.order(), (project::TableOrder{"defect.depth", true, "", ""}));
  // The last column goes on being the one after another one has come before it.
  panel_.setOrder({"computing_time", true, "", ""});
  store_.add(computed(runOf({{"defect.depth", "0.2"}, {"motion.speed", "31"}}, 4)));
  EXPECT_EQ(column("Computed in"), (QStringList{"6 min 40 s", "5 min 0 s", "3 min 20 s", "1 min 40 s"}));
  panel_.setOrder({"no.such", true, "no.such", "depth 0.2"});
  EXPECT_EQ(column("Computed in"), (QStringList{"3 min 20 s", "6 min 40 s"}));  // as they were made
  EXPECT_EQ(panel_.findChild<QLineEdit*>("runFilter")->text(), "depth 0.2");
  panel_.setOrder({});
  EXPECT_EQ(column("Depth [mm]"), (QStringList{"0.15", "0.3", "0.2", "0.2"}));
}

TEST_F(Runs, sayInWhichOrderTheyStand) {
  addThree();
  int changes = 0;
  QObject::connect(&panel_, &RunsPanel::orderChanged, [&] { ++changes; });
  clickHeading(1);
  EXPECT_EQ(panel_.order(), (project::TableOrder{"peak", false, "", ""}));
  clickHeading(1);
  EXPECT_EQ(panel_.order(), (project::TableOrder{"peak", true, "", ""}));
  clickHeading(1);
  EXPECT_EQ(panel_.order(), project::TableOrder());
  panel_.findChild<QLineEdit*>("runFilter")->setText("tiny");
  EXPECT_EQ(panel_.order().filter, "tiny");
  EXPECT_EQ(changes, 4);
}

TEST_F(Runs, areFilteredByNameAndValue) {
  addThree();
  store_.rename(2, "the good one");
  auto* filter = panel_.findChild<QLineEdit*>("runFilter");
  filter->setText("TINY");
  EXPECT_EQ(column("Depth [mm]"), QStringList{"0.3"});
  filter->setText("good");
  EXPECT_EQ(column("Depth [mm]"), QStringList{"0.2"});
  filter->clear();
  EXPECT_EQ(column("Depth [mm]").size(), 3);
}

// Two of one depth: chosen from the list as a user does, sorted, closed, filtered.
class GroupedRuns : public Runs {
 protected:
  void SetUp() override {
    Runs::SetUp();
    addThree();
    store_.add(computed(runOf({{"defect.depth", "0.3"}}, 4)));  // on draft; the other one of this depth on tiny
  }
  void groupBy(const QString& choice) {
    auto* list = panel_.findChild<QComboBox*>("runGroups");
    ASSERT_GE(list->findText(choice), 0) << choice.toStdString();
    list->setFocus();
    list->setCurrentIndex(list->findText(choice));
    Q_EMIT list->activated(list->currentIndex());
  }
  QStringList rows() const { return column("Run"); }
  void clickRow(int row) {
    const QModelIndex at = panel_.table()->model()->index(row, 0);
    QTest::mouseClick(panel_.table()->viewport(), Qt::LeftButton, {}, panel_.table()->visualRect(at).center());
  }
};

TEST_F(GroupedRuns, standUnderHeadingsInTheOrderOfTheTable) {
  groupBy("Groups: Depth");
  EXPECT_EQ(rows(),
            (QStringList{"▾ Depth [mm]: 0.15 (1)", "depth 0.15, draft *", "▾ Depth [mm]: 0.3 (2)", "depth 0.3, tiny *",
                         "depth 0.3, draft *", "▾ Depth [mm]: 0.2 (1)", "depth 0.2, draft *"}));
  EXPECT_EQ(panel_.table()->columnSpan(2, 0), panel_.table()->model()->columnCount());
  EXPECT_EQ(panel_.table()->columnSpan(3, 0), 1);
  clickHeading(1);  // by peak: 1, 2, 3, 4 times the made-up signal
  EXPECT_EQ(rows(),
            (QStringList{"▾ Depth [mm]: 0.15 (1)", "depth 0.15, draft *", "▾ Depth [mm]: 0.2 (1)", "depth 0.2, draft *",
                         "▾ Depth [mm]: 0.3 (2)", "depth 0.3, tiny *", "depth 0.3, draft *"}));
  clickHeading(1);  // from the largest
  EXPECT_EQ(rows().mid(0, 3), (QStringList{"▾ Depth [mm]: 0.3 (2)", "depth 0.3, draft *", "depth 0.3, tiny *"}));
  EXPECT_EQ(panel_.table()->columnSpan(0, 0), panel_.table()->model()->columnCount());
  EXPECT_EQ(panel_.order(), (project::TableOrder{"peak", true, "defect.depth", ""}));
  groupBy("Groups: Mesh");
  EXPECT_EQ(rows()[0], "▾ Mesh: draft (3)");
  EXPECT_EQ(rows()[4], "▾ Mesh: tiny (1)");
  groupBy("No groups");
  EXPECT_EQ(rows().size(), 4);
  EXPECT_EQ(panel_.table()->columnSpan(0, 0), 1);
}

TEST_F(GroupedRuns, areTheRunsThatTheirRowsShow) {
  groupBy("Groups: Depth");
  clickRow(3);
  EXPECT_EQ(store_.current(), 1);
  EXPECT_EQ(panel_.table()->currentIndex().row(), 3);
  EXPECT_EQ(panel_.rowOf(panel_.table()->model()->index(2, 0)), -1);  // a heading is no run
  panel_.table()->setFocus();
  tests::press(panel_, Qt::Key_F2);
  tests::type(panel_, "deep one");
  tests::press(panel_, Qt::Key_Return);
  EXPECT_EQ(store_.at(1).label, "deep one");
  EXPECT_EQ(rows()[3], "deep one *");
  panel_.table()->model()->setData(panel_.indexOf(3), Qt::Checked, Qt::CheckStateRole);
  EXPECT_TRUE(store_.at(3).overlaid);
}

TEST_F(GroupedRuns, closeByMouseAndByKeyboard) {
  groupBy("Groups: Depth");
  clickRow(2);
  EXPECT_EQ(rows(), (QStringList{"▾ Depth [mm]: 0.15 (1)", "depth 0.15, draft *", "▸ Depth [mm]: 0.3 (2)",
                                 "▾ Depth [mm]: 0.2 (1)", "depth 0.2, draft *"}));
  panel_.table()->setFocus();
  EXPECT_EQ(panel_.table()->currentIndex().row(), 2);  // the heading that was clicked
  for (const int key : {Qt::Key_Right, Qt::Key_Return}) {
    tests::press(panel_, key);
    EXPECT_EQ(rows()[3], "depth 0.3, tiny *") << key;
    tests::press(panel_, key == Qt::Key_Right ? Qt::Key_Left : Qt::Key_Space);
    EXPECT_EQ(rows().size(), 5) << key;
  }
  EXPECT_EQ(store_.current(), 3);  // a heading makes no run the current one
  store_.setCurrent(0);
  store_.setCurrent(3);  // what is shown is to be seen in the table
  EXPECT_EQ(rows()[2], "▾ Depth [mm]: 0.3 (2)");
  EXPECT_EQ(panel_.table()->currentIndex(), panel_.indexOf(3));
}

TEST_F(GroupedRuns, followTheFilterAndRunsThatGo) {
  groupBy("Groups: Depth");
  auto* filter = panel_.findChild<QLineEdit*>("runFilter");
  filter->setText("tiny");
  EXPECT_EQ(rows(), (QStringList{"▾ Depth [mm]: 0.3 (1)", "depth 0.3, tiny *"}));
  filter->clear();
  EXPECT_EQ(rows().size(), 7);
  store_.remove(2);
  EXPECT_EQ(rows().size(), 5);
  store_.remove(0);  // all of one depth: no column, no groups
  EXPECT_EQ(rows(), (QStringList{"tiny *", "draft *"}));
  EXPECT_EQ(panel_.findChild<QComboBox*>("runGroups")->currentText(), "No groups");
  store_.add(computed(runOf({{"defect.depth", "0.15"}})));  // the column is back
  EXPECT_EQ(rows()[0], "▾ Depth [mm]: 0.3 (2)");
  EXPECT_EQ(panel_.findChild<QComboBox*>("runGroups")->currentText(), "Groups: Depth");
}

// By the mouse, as a user does: the box overlays, the name makes the run the current one.
TEST_F(Runs, tickingARunDoesNotMakeItTheCurrentOne) {
  for (const char* label : {"a", "b"}) {
    const auto result = runOf({});
    store_.add({result, label, {}, false});
  }
  QTableView* table = panel_.table();
  const QModelIndex first = panel_.indexOf(0);
  QStyleOptionViewItem option;
  option.initFrom(table);
  option.features = QStyleOptionViewItem::HasCheckIndicator | QStyleOptionViewItem::HasDisplay;
  option.rect = table->visualRect(first);
  const QRect box = table->style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, table);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, box.center());
  EXPECT_TRUE(store_.at(0).overlaid);
  EXPECT_EQ(store_.current(), 1);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, box.center() + QPoint(box.width() + 8, 0));
  EXPECT_EQ(store_.current(), 0);
}

// A run keeps its colour while others come and go, in every figure.
TEST_F(Runs, overlaysKeepTheirColours) {
  addThree();
  const auto tick = [&](int row, bool on) {
    store_.setData(store_.index(row), on ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
  };
  for (const int row : {0, 1, 2}) tick(row, true);
  EXPECT_EQ(store_.at(1).colourIndex, 1u);
  tick(0, false);
  EXPECT_EQ(store_.at(1).colourIndex, 1u);
  EXPECT_EQ(store_.at(2).colourIndex, 2u);
  tick(0, true);
  EXPECT_EQ(store_.at(0).colourIndex, 0u) << "the one that had become free";
  int drawnAnew = 0;
  QObject::connect(&store_, &RunStore::overlaysChanged, [&] { ++drawnAnew; });
  store_.setColour(0, Qt::red);
  EXPECT_EQ(store_.at(0).colour, QColor(Qt::red));
  EXPECT_EQ(drawnAnew, 1);
}

TEST_F(Runs, theMenuOfARunDoesWhatItSays) {
  addThree();
  QStringList folders;
  QObject::connect(&panel_, &RunsPanel::folderRequested, [&](const QString& path) { folders << path; });
  store_.setPath(0, "/somewhere/first.h5");
  QMenu menu;
  panel_.fillMenu(menu, 0);
  const auto action = [&](const char* name) { return menu.findChild<QAction*>(name); };
  action("runFolder")->trigger();
  EXPECT_EQ(folders, QStringList{"/somewhere"});
  action("runShow")->trigger();
  EXPECT_EQ(store_.current(), 0);
  action("runOverlay")->trigger();
  EXPECT_TRUE(store_.at(0).overlaid);
  EXPECT_FALSE(action("runNameAnew")->isEnabled());  // nobody has named it
  std::vector<int> removed, saved;
  QObject::connect(&panel_, &RunsPanel::removeRequested, [&](int row) { removed.push_back(row); });
  QObject::connect(&panel_, &RunsPanel::saveRunRequested, [&](int row) { saved.push_back(row); });
  QMenu second;
  panel_.fillMenu(second, 1);
  EXPECT_FALSE(second.findChild<QAction*>("runFolder")->isEnabled());  // in no file yet
  store_.remove(0);                                                    // while the menu stands
  second.findChild<QAction*>("runSave")->trigger();
  second.findChild<QAction*>("runRemove")->trigger();
  EXPECT_EQ(saved, std::vector<int>{0});
  EXPECT_EQ(removed, std::vector<int>{0});
  store_.remove(0);
  second.findChild<QAction*>("runRemove")->trigger();  // it is gone
  EXPECT_EQ(removed.size(), 1u);
}

}  // namespace
}  // namespace squat::studio
