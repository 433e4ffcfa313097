// The studio around the real computation, at the coarsest mesh and over a short stretch.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <iostream>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "simulation/RunCase.h"
#include "studio/common/MessageBar.h"
#include "studio/document/ParameterForm.h"
#include "studio/runs/LivePlot.h"
#include "studio/runs/RunPanel.h"

namespace squat::studio {
namespace {

class RealRun : public testing::Test {
 protected:
  void SetUp() override {
    StudioServices services = tests::services();
    services.runner = simulation::runCase;
    services.threads = 1;  // other tests may hold the second core
    services.runsFolder = folder_.path();
    window_ = std::make_unique<MainWindow>(services);
    ASSERT_TRUE(window_->openCase("light-defect"));
    window_->document().setParameter("mesh.preset", "tiny");
    window_->document().setParameter("motion.run_up", "0.06");
    window_->document().setParameter("motion.beyond", "0.07");
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    ASSERT_TRUE(window_->form()->blockers().isEmpty()) << window_->form()->blockers().join('\n').toStdString();
  }
  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(RealRun, runsToItsEndWhileTheWindowStaysAliveAndAStoppedOneResumesToTheSameBits) {
  std::vector<double> gaps;  // [ms] between turns of a timer of 5 ms
  QElapsedTimer clock;
  QTimer pulse;
  QObject::connect(&pulse, &QTimer::timeout, [&] { gaps.push_back(clock.restart() - 5.0); });
  clock.start();
  pulse.start(5);
  window_->startRun();
  ASSERT_TRUE(tests::passes([&] { return !window_->controller().isRunning(); }, tests::patience));
  pulse.stop();
  ASSERT_EQ(window_->store().rowCount(), 1) << window_->messages()->text().toStdString();
  const ResultPointer result = window_->store().currentResult();
  EXPECT_TRUE(result->complete);
  EXPECT_GT(result->time.size(), 50u);
  EXPECT_FALSE(result->snapshots.empty());
  EXPECT_GT(window_->findChild<RunPanel*>()->live()->sampleCount(), 3);
  // Printed, not judged: what else the machine does is not known here.
  std::sort(gaps.begin(), gaps.end());
  if (!gaps.empty())
    std::cout << "event loop latency: 99th percentile " << gaps[gaps.size() * 99 / 100] << " ms, largest "
              << gaps.back() << " ms, " << gaps.size() << " turns\n";

  window_->startRun();
  auto* live = window_->findChild<RunPanel*>()->live();
  ASSERT_TRUE(tests::passes([&] { return live->sampleCount() > 1; }, tests::patience));
  clock.start();
  tests::press(*window_, Qt::Key_F5, Qt::ShiftModifier);
  ASSERT_TRUE(tests::passes([&] { return !window_->controller().isRunning(); }, tests::patience));
  std::cout << "cancelled after " << clock.elapsed() << " ms\n";
  ASSERT_EQ(window_->store().rowCount(), 2);
  EXPECT_FALSE(window_->store().currentResult()->complete);

  std::vector<std::string> phases;
  QObject::connect(&window_->controller(), &RunController::news,
                   [&](const WorkerMonitor::News& news) { phases.push_back(news.progress.phase); });
  tests::press(*window_, Qt::Key_F5, Qt::ControlModifier);
  ASSERT_TRUE(window_->controller().isRunning());
  ASSERT_TRUE(tests::passes([&] { return !window_->controller().isRunning(); }, tests::patience));
  EXPECT_EQ(std::count(phases.begin(), phases.end(), "equilibrium"), 0);  // is in the checkpoint
  // What there was of it is replaced by the whole.
  ASSERT_EQ(window_->store().rowCount(), 2) << window_->messages()->text().toStdString();
  const ResultPointer resumed = window_->store().currentResult();
  ASSERT_TRUE(resumed->complete && resumed->signal("aba") && result->signal("aba"));
  EXPECT_EQ(*resumed->signal("aba"), *result->signal("aba"));
  EXPECT_EQ(resumed->snapshots.size(), result->snapshots.size());
}

}  // namespace
}  // namespace squat::studio
