// The seam between the window and the computing thread alone: pause, resume, cancel, start again and close at random
// moments, 200 times. Needs no window, so that the thread sanitizer sees our code and little of Qt's.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "core/Errors.h"
#include "studio/runs/RunController.h"

namespace squat::studio {
namespace {

constexpr int rounds = 200, patience = 60000;  // [ms]

// Reports, tells and asks like simulation::runCase, every 0.2 ms; some runs fail.
results::RunResult madeUpRun(const cases::CaseDescription& description, const simulation::RunOptions&, Monitor& monitor,
                             results::RunResult* partial) {
  results::RunResult result;
  result.title = description.title;
  for (int step = 0; step < 100; ++step) {
    Progress progress;
    progress.phase = step < 30 ? "equilibrium" : "rolling";
    progress.fraction = step / 100.0;
    progress.position = step, progress.simulatedTime = 1e-6 * step;
    if (step == 20) progress.step = 2e-7, progress.limitedBy = "rail";
    monitor.report(progress);
    if (step % 10 == 0) monitor.message("step");
    result.time.push_back(step);
    while (step >= 30 && monitor.paused() && !monitor.cancelled()) std::this_thread::yield();
    if (monitor.cancelled()) {
      result.stopReason = "cancelled";
      return result;
    }
    if (step == 75 && description.title == "fails") {
      *partial = result;
      throw RunError("made to fail", step, 0, "nowhere");
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  result.complete = true;
  return result;
}

void letEventsPass(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

struct Seen {
  std::size_t samples = 0;
  int ends = 0, complete = 0, cancelled = 0, failures = 0;
};

std::unique_ptr<RunController> watched(Seen& seen) {
  auto controller = std::make_unique<RunController>(madeUpRun);
  QObject::connect(controller.get(), &RunController::news, [&](const WorkerMonitor::News& news) {
    seen.samples += news.samples.size();
    if (news.progress.phase == "rolling") {
      EXPECT_EQ(news.progress.limitedBy, "rail");  // told once, kept since
    }
  });
  QObject::connect(controller.get(), &RunController::finished, [&](const ResultPointer& result) {
    (result->complete ? seen.complete : seen.cancelled) += 1;
    EXPECT_FALSE(result->time.empty());
  });
  QObject::connect(controller.get(), &RunController::failed,
                   [&](const QString&, const QString&, const ResultPointer& soFar) {
                     ++seen.failures;
                     ASSERT_TRUE(soFar);
                     EXPECT_FALSE(soFar->complete);
                   });
  QObject::connect(controller.get(), &RunController::ended, [&] { ++seen.ends; });
  return controller;
}

TEST(AnyMoment, theSeamHoldsTwoHundredDisturbedRuns) {
  std::mt19937 random(20140715);
  Seen seen;
  int closedWhileRunning = 0;
  for (int round = 0; round < rounds; ++round) {
    auto controller = watched(seen);
    cases::CaseDescription description;
    description.title = random() % 5 == 0 ? "fails" : "runs";
    controller->start(description, "stem");
    for (int action = 0; action < 4; ++action) {
      letEventsPass(static_cast<int>(random() % 8));
      const auto chosen = random() % 8;
      if (chosen < 2)
        controller->setPaused(true);
      else if (chosen < 5)
        controller->setPaused(false);
      else if (chosen == 5)
        controller->cancel();
      else
        controller->start(description, "again");  // does nothing while one is going on
    }
    if (random() % 2) {
      controller->setPaused(false);
      ASSERT_TRUE(controller->waitFor(patience)) << "round " << round;
    }
    closedWhileRunning += controller->isRunning();
  }
  EXPECT_EQ(seen.ends, seen.complete + seen.cancelled + seen.failures);
  // Otherwise the moments were not random enough to mean anything.
  for (const int count : {seen.complete, seen.cancelled, seen.failures, closedWhileRunning}) EXPECT_GT(count, 5);
  EXPECT_GT(seen.samples, 1000u);
}

// A computation that shows itself far more often than the window looks: the last look is shown, before the end, and
// none after a later one.
TEST(AnyMoment, ofManyLooksTheLastOneIsShown) {
  constexpr int looks = 100000;
  for (int round = 0; round < 5; ++round) {
    std::vector<int> shown;
    int atTheEnd = 0;
    BackgroundJob job;
    QObject::connect(&job, &BackgroundJob::news, [](const WorkerMonitor::News& news) {
      if (news.show) news.show();
    });
    QObject::connect(&job, &BackgroundJob::ended, [&] { atTheEnd = shown.empty() ? 0 : shown.back(); });
    job.start([&](WorkerMonitor& monitor) {
      for (int look = 1; look <= looks; ++look)
        monitor.show([&shown, value = std::make_shared<const int>(look)] { shown.push_back(*value); });
    });
    ASSERT_TRUE(job.waitFor(patience));
    EXPECT_EQ(atTheEnd, looks);
    EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
    EXPECT_LT(shown.size(), 10000u);  // nothing is queued: 20 a second
  }
}

}  // namespace
}  // namespace squat::studio

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
