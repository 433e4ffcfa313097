// Runs in a thread of their own: pause, cancel, failure, and all of it at random moments.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <random>

#include "case/ParameterTable.h"
#include "gui/MadeUpRun.h"
#include "studio/runs/RunController.h"

namespace squat::studio {
namespace {

// Phases are told before they begin, with nothing computed yet: no point of a curve.
TEST(WorkerMonitor, theBeginningOfAPhaseIsNoSample) {
  WorkerMonitor monitor;
  Progress beginning;
  beginning.phase = "rolling";
  monitor.report(beginning);
  EXPECT_TRUE(monitor.takeNews().samples.empty());
  Progress rolling;
  rolling.phase = "rolling";
  rolling.simulatedTime = 1e-4;
  rolling.position = -0.05;
  rolling.contactForce = 9e4;
  monitor.report(rolling);
  const auto news = monitor.takeNews();
  ASSERT_EQ(news.samples.size(), 1u);
  EXPECT_DOUBLE_EQ(news.samples[0].position, -0.05);
}

TEST(RunController, aRunEndsWithItsResult) {
  RunController controller(tests::madeUpRunner(60));
  ResultPointer result;
  std::size_t live = 0;
  QObject::connect(&controller, &RunController::finished, [&](const ResultPointer& done) { result = done; });
  QObject::connect(&controller, &RunController::news,
                   [&](const WorkerMonitor::News& news) { live += news.samples.size(); });
  controller.start(cases::defaultCase(), "stem");
  EXPECT_TRUE(controller.isRunning());
  ASSERT_TRUE(controller.waitFor(10000));
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->complete);
  EXPECT_EQ(result->stem, "stem");
  EXPECT_EQ(live, 59u);  // every report is seen but the first, which stands at time zero; none twice
}

TEST(RunController, cancelKeepsWhatThereIs) {
  RunController controller(tests::madeUpRunner(60000));
  ResultPointer result;
  QObject::connect(&controller, &RunController::finished, [&](const ResultPointer& done) { result = done; });
  controller.start(cases::defaultCase(), "stem");
  QTest::qWait(50);
  controller.cancel();
  ASSERT_TRUE(controller.waitFor(10000));
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->complete);
  EXPECT_EQ(result->stopReason, "cancelled");
}

TEST(RunController, pauseHoldsTheRun) {
  RunController controller(tests::madeUpRunner(400));
  double fraction = 0;
  QObject::connect(&controller, &RunController::news,
                   [&](const WorkerMonitor::News& news) { fraction = news.progress.fraction; });
  controller.start(cases::defaultCase(), "stem");
  ASSERT_TRUE(tests::passes([&] { return fraction > 0; }));
  controller.setPaused(true);
  QTest::qWait(150);  // the step that was going on is done long before
  const double fixed = fraction;
  QTest::qWait(200);
  EXPECT_EQ(fraction, fixed);
  EXPECT_TRUE(controller.isRunning());
  controller.setPaused(false);
  EXPECT_TRUE(controller.waitFor(20000));
}

TEST(RunController, aFailureSaysWhatAndWhere) {
  RunController controller(tests::madeUpRunner(40));
  cases::CaseDescription description = cases::defaultCase();
  description.title = "fails";
  QString sentence, details;
  ResultPointer kept;
  QObject::connect(&controller, &RunController::failed,
                   [&](const QString& text, const QString& more, const ResultPointer& soFar) {
                     sentence = text;
                     details = more;
                     kept = soFar;
                   });
  controller.start(description, "stem");
  ASSERT_TRUE(controller.waitFor(10000));
  EXPECT_TRUE(sentence.contains("energy grew")) << sentence.toStdString();
  EXPECT_TRUE(details.contains("1234") && details.contains("element 77"));
  ASSERT_TRUE(kept);
  EXPECT_FALSE(kept->complete);
}

// 200 runs, each disturbed at a random moment, some destroyed while they run.
TEST(RunController, survivesAnythingAtAnyMoment) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    auto controller = std::make_unique<RunController>(tests::madeUpRunner(30));
    controller->start(cases::defaultCase(), "stem");
    for (int action = 0; action < 4; ++action) {
      QTest::qWait(static_cast<int>(random() % 4));
      switch (random() % 4) {
        case 0:
          controller->setPaused(!controller->isPaused());
          break;
        case 1:
          controller->cancel();
          break;
        case 2:
          controller->start(cases::defaultCase(), "again");  // ignored while one is going on
          break;
        default:
          break;
      }
    }
    if (random() % 2) {
      controller->setPaused(false);
      ASSERT_TRUE(controller->waitFor(10000)) << "round " << round;
    }
    controller.reset();
  }
}

// Memory may be short while the result is written beside itself.
TEST(RunController, aResultThatCannotBeKeptIsAResultAllTheSame) {
  RunController controller(tests::madeUpRunner(5));
  ResultPointer got;
  QObject::connect(&controller, &RunController::finished, [&](const ResultPointer& result) { got = result; });
  controller.start(cases::CaseDescription{}, "run", {}, [](const results::RunResult&) { throw std::bad_alloc(); });
  ASSERT_TRUE(controller.waitFor(60000));
  ASSERT_TRUE(got);
  EXPECT_TRUE(got->complete);
}

}  // namespace
}  // namespace squat::studio
