// The table of a study's runs, without a study: what it shows of each state, and that its rows stay where they are.
#include "studio/tools/StudyView.h"

#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

namespace squat::studio {
namespace {

using studies::RowState;
using studies::RunState;

class StudyTableView : public testing::Test {
 protected:
  void SetUp() override {
    view_.resize(900, 300);
    view_.show();
  }
  // Depths 0.1, 0.2, 0.3 mm; nothing is computed yet.
  static studies::StudyProgress threeRuns() {
    studies::StudyDefinition definition;
    definition.variations = {{"defect.depth", {"0.1", "0.2", "0.3"}}};
    return studies::progressOf(studies::emptyTable(definition));
  }
  static void end(studies::RunProgress& run, double peak) {
    auto row = *run.row;
    row.state = RowState::done;
    row.features = {{"peak [m/s2]", peak}, {"largest contact force [N]", 123400}};
    run = {std::make_shared<const studies::StudyRow>(row), RunState::done, 0};
  }
  static void fail(studies::RunProgress& run, const std::string& reason) {
    auto row = *run.row;
    row.state = RowState::failed;
    row.message = reason;
    run = {std::make_shared<const studies::StudyRow>(row), RunState::failed, 0};
  }
  void show(const studies::StudyProgress& study) {
    view_.setStudy(std::make_shared<const studies::StudyProgress>(study));
  }
  const QAbstractItemModel& rows() const { return *table_->model(); }
  QString cell(int row, int column) const { return rows().index(row, column).data().toString(); }
  QStringList states() const {
    QStringList all;
    for (int row = 0; row < rows().rowCount(); ++row) all << cell(row, 1);
    return all;
  }
  QString heading(int column) const { return rows().headerData(column, Qt::Horizontal).toString(); }

  StudyView view_;
  QTableView* table_ = view_.findChild<QTableView*>("studyRows");
  QLabel* says_ = view_.findChild<QLabel*>("studyState");
  QPushButton* open_ = view_.findChild<QPushButton*>("studyShowRun");
};

TEST_F(StudyTableView, hasARowForEachRunAndFillsIt) {
  EXPECT_TRUE(says_->text().contains("Press Start")) << says_->text().toStdString();
  auto study = threeRuns();
  show(study);
  EXPECT_EQ(heading(0), "Depth\n[mm]");
  EXPECT_EQ(heading(2), "Peak\n[m/s²]");
  EXPECT_EQ(states(), (QStringList{"waiting", "waiting", "waiting"}));
  study.runs[0].state = RunState::computing, study.runs[0].fraction = 0.439;
  show(study);
  EXPECT_EQ(states(), (QStringList{"computing 43 %", "waiting", "waiting"}));
  end(study.runs[0], 98.76);
  fail(study.runs[1], "contact lost");
  show(study);
  EXPECT_EQ(states(), (QStringList{"done", "failed", "waiting"}));
  EXPECT_EQ(cell(0, 0), "0.1");
  EXPECT_EQ(cell(0, 2), "98.76");
  EXPECT_EQ(cell(0, 4), "123.4");  // kN
  EXPECT_EQ(cell(0, 3), "–");      // done, but without this feature
  EXPECT_EQ(cell(1, 2), "");
  EXPECT_EQ(cell(1, rows().columnCount() - 1), "contact lost");
  EXPECT_EQ(says_->text(), "1 of 3 runs done, 1 failed");
}

TEST_F(StudyTableView, saysWhatBecameOfARunThatDidNotEnd) {
  auto study = threeRuns();
  study.runs[0].state = RunState::cancelled;
  study.runs[1].state = RunState::computing;  // the last that was heard of it
  show(study);
  view_.conclude();
  EXPECT_EQ(states(), (QStringList{"cancelled", "cancelled", "not computed"}));
  show(threeRuns());  // started again
  EXPECT_EQ(states(), (QStringList{"waiting", "waiting", "waiting"}));
  view_.clear();
  EXPECT_EQ(rows().rowCount(), 0);
}

// Rows, widths and what is chosen stay, whatever comes in; a click on a heading sorts once.
TEST_F(StudyTableView, nothingMovesWhileItFills) {
  auto study = threeRuns();
  show(study);
  table_->selectRow(1);
  std::vector<int> widths;
  for (int column = 0; column < rows().columnCount(); ++column) widths.push_back(table_->columnWidth(column));
  const QSignalSpy resets(&rows(), &QAbstractItemModel::modelReset);
  const QSignalSpy moves(&rows(), &QAbstractItemModel::layoutChanged);
  end(study.runs[2], 10), end(study.runs[0], 30);
  study.definition = std::make_shared<const studies::StudyDefinition>(*study.definition);  // of the resumed study
  show(study);
  EXPECT_EQ(resets.count() + moves.count(), 0);
  EXPECT_EQ(table_->selectionModel()->selectedRows().value(0).row(), 1);
  for (int column = 0; column < rows().columnCount(); ++column)
    EXPECT_EQ(table_->columnWidth(column), widths[static_cast<std::size_t>(column)]) << column;
  table_->sortByColumn(2, Qt::DescendingOrder);  // by the peak
  EXPECT_EQ(cell(0, 2), "30");
  const QString second = cell(1, 0), third = cell(2, 0);
  end(study.runs[1], 200);
  show(study);  // larger than all others, and yet where it was
  EXPECT_EQ(cell(0, 2), "30");
  EXPECT_EQ(cell(1, 0), second);
  EXPECT_EQ(cell(2, 0), third);
}

TEST_F(StudyTableView, aDoubleClickEnterOrTheButtonAskForARunThatIsDone) {
  std::vector<std::size_t> asked;
  QObject::connect(&view_, &StudyView::runRequested,
                   [&](const studies::StudyPoint& point) { asked.push_back(point.index); });
  auto study = threeRuns();
  end(study.runs[2], 10);
  show(study);
  EXPECT_FALSE(open_->isEnabled());
  table_->selectRow(0);
  EXPECT_FALSE(open_->isEnabled());  // it has not ended
  QTest::keyClick(table_, Qt::Key_Return);
  EXPECT_TRUE(asked.empty());
  table_->selectRow(2);
  EXPECT_TRUE(open_->isEnabled());
  open_->click();
  QTest::keyClick(table_, Qt::Key_Return);
  const QPoint middle = table_->visualRect(rows().index(2, 1)).center();
  QTest::mouseClick(table_->viewport(), Qt::LeftButton, {}, middle);
  QTest::mouseDClick(table_->viewport(), Qt::LeftButton, {}, middle);
  EXPECT_EQ(asked, (std::vector<std::size_t>{2, 2, 2}));
  // The run that is chosen ends: the button knows without another click.
  table_->selectRow(0);
  end(study.runs[0], 20);
  show(study);
  EXPECT_TRUE(open_->isEnabled());
}

}  // namespace
}  // namespace squat::studio
