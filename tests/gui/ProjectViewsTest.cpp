// What a project keeps of how its runs are looked at: what is enlarged of the figures, and the order of the table.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>

#include "case/ParameterValue.h"
#include "gui/MadeUpRun.h"
#include "project/ProjectFile.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "studio/common/MessageBar.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

class ProjectViews : public testing::Test {
 protected:
  std::unique_ptr<MainWindow> open() const {
    auto window = std::make_unique<MainWindow>(tests::services(20, Answer::cancel));
    window->show();
    return window;
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  QByteArray saved() const {
    QFile file(path("day.squat-project"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  std::vector<project::FigureRange> keptRanges() const {
    return project::readProject(path("day.squat-project").toStdString()).figures->ranges;
  }
  // Of the open project, with the fields of the run in front.
  static bool isRead(MainWindow& window) {
    const RunStore& store = window.store();
    const auto whole = [&] { return store.current() >= 0 && store.at(store.current()).fields == Fields::both; };
    return window.reader()->waitFor(30000) && tests::passes(whole, 30000);
  }
  static plots::Figure& figure(MainWindow& window, const QString& name) {
    window.signalsPanel()->showTab(name);
    return *window.signalsPanel()->view(name)->figure();
  }
  QTemporaryDir folder_;
};

TEST_F(ProjectViews, keepWhatIsEnlarged) {
  results::writeResult(path("one.h5").toStdString(), tests::syntheticResult());
  {
    const auto window = open();
    ASSERT_TRUE(window->openResult(path("one.h5")));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    EXPECT_TRUE(keptRanges().empty());
    figure(*window, "psd").xAxis->setRange(200, 900);
    figure(*window, "aba_position").xAxis->setRange(-30, 45.5);
    figure(*window, "aba_position").yAxis->setRange(-20, 60);
    figure(*window, "contact_force");                                                // follows along the track
    EXPECT_TRUE(tests::passes([this] { return keptRanges().size() == 2; }, 20000));  // saved by itself
    ASSERT_TRUE(window->close());
  }
  // SI, where the axes are in mm and kN.
  const auto kept = keptRanges();
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].figure, "aba_position");
  EXPECT_EQ(kept[0].x->low, -0.03);
  EXPECT_EQ(kept[0].x->high, 0.0455);
  EXPECT_EQ(kept[0].x->unit, "m");
  EXPECT_EQ(kept[0].y->high, 60);
  EXPECT_EQ(kept[0].y->unit, "m/s²");
  EXPECT_EQ(kept[1].figure, "psd");
  EXPECT_EQ(kept[1].x->high, 900);
  EXPECT_FALSE(kept[1].y);

  const QByteArray before = saved();
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project"))) << window->messages()->text().toStdString();
  window->keeper()->saveNow();  // before the run is read
  EXPECT_EQ(saved(), before);
  ASSERT_TRUE(isRead(*window));
  window->keeper()->saveNow();
  EXPECT_EQ(saved(), before);
  for (const char* name : {"aba_position", "contact_force"}) {
    EXPECT_NEAR(figure(*window, name).xAxis->range().lower, -30, 1e-6) << name;  // nine digits are kept
    EXPECT_NEAR(figure(*window, name).xAxis->range().upper, 45.5, 1e-6) << name;
  }
  EXPECT_EQ(figure(*window, "aba_position").yAxis->range(), QCPRange(-20, 60));
  EXPECT_EQ(figure(*window, "psd").xAxis->range(), QCPRange(200, 900));
  // Seen whole again, nothing is kept.
  for (const char* name : {"aba_position", "psd"}) window->signalsPanel()->view(name)->resetZoom();
  window->keeper()->saveNow();
  EXPECT_TRUE(keptRanges().empty());
}

// Forces are in kN; beyond the axes as they are without zoom there are data as well.
TEST_F(ProjectViews, keepWhatIsSeenBesideTheDefect) {
  results::writeResult(path("one.h5").toStdString(), tests::syntheticResult());
  {
    const auto window = open();
    ASSERT_TRUE(window->openResult(path("one.h5")));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    figure(*window, "contact_force").xAxis->setRange(-190, -110);  // the axis begins at -100
    figure(*window, "contact_force").yAxis->setRange(50, 120);
    ASSERT_TRUE(window->close());
  }
  ASSERT_EQ(keptRanges().size(), 1U);
  EXPECT_EQ(keptRanges()[0].y->high, 120000);
  EXPECT_EQ(keptRanges()[0].y->unit, "N");
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project")));
  ASSERT_TRUE(isRead(*window));
  EXPECT_NEAR(figure(*window, "contact_force").xAxis->range().upper, -110, 1e-6);
  EXPECT_NEAR(figure(*window, "contact_force").yAxis->range().upper, 120, 1e-6);
}

TEST_F(ProjectViews, areWholeWhereTheDataHaveGone) {
  auto result = tests::syntheticResult();
  results::writeResult(path("one.h5").toStdString(), result);
  {
    const auto window = open();
    ASSERT_TRUE(window->openResult(path("one.h5")));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    figure(*window, "aba_time").xAxis->setRange(5, 10);
    figure(*window, "psd").xAxis->setRange(200, 900);
    ASSERT_TRUE(window->close());
  }
  for (double& time : result.time) time += 1;
  results::writeResult(path("one.h5").toStdString(), result);
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project")));
  ASSERT_TRUE(isRead(*window));
  EXPECT_TRUE(window->messages()->text().contains("1 file")) << window->messages()->text().toStdString();
  EXPECT_GT(figure(*window, "aba_time").xAxis->range().lower, 900);  // [ms]
  EXPECT_FALSE(window->signalsPanel()->view("aba_time")->isZoomed());
  EXPECT_EQ(figure(*window, "psd").xAxis->range(), QCPRange(200, 900));  // there are frequencies as before
}

// Sorted and grouped by columns that come when the runs have been read.
TEST_F(ProjectViews, keepTheOrderOfTheRuns) {
  const std::vector<const char*> depths{"0.15", "0.3", "0.2"};
  const auto file = [this](const char* depth) { return path(QString("depth-%1.h5").arg(depth)); };
  for (const char* depth : depths) {
    auto result = tests::syntheticResult();
    auto description = cases::defaultCase();
    cases::setValue(description, "defect.depth", depth);
    results::setCase(result, description);
    results::writeResult(file(depth).toStdString(), result);
  }
  const project::TableOrder order{"defect.depth", true, "mesh.preset", "0."};
  {
    const auto window = open();
    for (const char* depth : depths) ASSERT_TRUE(window->openResult(file(depth)));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    auto* panel = window->findChild<RunsPanel*>();
    constexpr int depthColumn = 3;  // after name, peak and lines
    panel->table()->sortByColumn(depthColumn, Qt::DescendingOrder);
    auto* groups = panel->findChild<QComboBox*>("runGroups");
    groups->setCurrentIndex(groups->findText("Groups: Mesh"));
    Q_EMIT groups->activated(groups->currentIndex());
    panel->findChild<QLineEdit*>("runFilter")->setText("0.");
    EXPECT_EQ(panel->order(), order);
    EXPECT_TRUE(tests::passes([this] { return saved().contains("\"run_order\""); }, 20000));  // by itself
    ASSERT_TRUE(window->close());
  }
  const QByteArray before = saved();
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project"))) << window->messages()->text().toStdString();
  const auto* panel = window->findChild<RunsPanel*>();
  window->keeper()->saveNow();  // before a run is read
  EXPECT_EQ(saved(), before);
  ASSERT_TRUE(isRead(*window));
  window->keeper()->saveNow();
  EXPECT_EQ(saved(), before);
  EXPECT_EQ(panel->order(), order);
  EXPECT_EQ(panel->findChild<QComboBox*>("runGroups")->currentText(), "Groups: Mesh");
  std::vector<int> rows;
  for (int row = 1; row < panel->table()->model()->rowCount(); ++row)  // after the heading of the group
    rows.push_back(panel->rowOf(panel->table()->model()->index(row, 0)));
  EXPECT_EQ(rows, (std::vector<int>{1, 2, 0}));
  ASSERT_TRUE(window->closeProject());  // the next work begins without
  EXPECT_EQ(panel->order(), project::TableOrder());
}

}  // namespace
}  // namespace squat::studio
