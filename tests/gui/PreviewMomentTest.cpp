// Previews disturbed at any moment: cases changed, switched off, held and closed in every phase. The thread alone, then
// the window around it.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSettings>
#include <QTest>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <random>
#include <thread>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "gui/PreviewSolvers.h"
#include "studio/preview/PreviewController.h"

namespace squat::studio {
namespace {

std::shared_ptr<const cases::CaseDescription> caseWith(const std::vector<std::pair<std::string, std::string>>& values) {
  return std::make_shared<const cases::CaseDescription>(cases::loadCase("light-defect", {"draft", values}));
}

// Waits for the end of the newest wish without any event loop.
class Watched {
 public:
  Watched(const std::shared_ptr<tests::PreviewCalls>& calls, int start, int run)
      : worker_(tests::madeUpPreviewSolver(calls, start, run), 1, [this] {
          const std::lock_guard lock(mutex_);
          if (const auto preview = worker_.take(); !preview.position.empty())
            farthest_ = std::max(farthest_, preview.position.back());
          news_.notify_all();
        }) {}
  PreviewWorker* operator->() { return &worker_; }
  bool settles() {
    std::unique_lock lock(mutex_);
    return news_.wait_for(lock, std::chrono::milliseconds(tests::patience), [this] { return !worker_.isBusy(); });
  }
  double farthest() {  // [m] that a picture has shown
    const std::lock_guard lock(mutex_);
    return farthest_;
  }
  template <class Condition>
  bool comesTo(const Condition& condition) {
    for (int i = 0; i < tests::patience && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return condition();
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  double farthest_ = -1;
  PreviewWorker worker_;
};

double depthOf(const Preview& preview) { return preview.result->resolvedCase->description.defect.depth; }

TEST(PreviewWorker, theNewestWishWins) {
  const auto calls = std::make_shared<tests::PreviewCalls>();
  Watched worker(calls, 2, 40);
  for (const char* depth : {"0.10", "0.11", "0.12", "0.13"}) {
    worker->ask(caseWith({{"defect.depth", depth}}));
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
  }
  ASSERT_TRUE(worker.settles());
  const auto preview = worker->take();
  ASSERT_EQ(preview.phase, PreviewPhase::done);
  EXPECT_DOUBLE_EQ(depthOf(preview), 0.13e-3);
  EXPECT_EQ(calls->complete, 1);
  EXPECT_EQ(calls->made, 1);
}

// A drag does not begin the equilibrium again and again.
TEST(PreviewWorker, aStateInTheMakingServesAChangedProfile) {
  const auto calls = std::make_shared<tests::PreviewCalls>();
  Watched worker(calls, 100, 2);
  worker->ask(caseWith({}));
  for (const char* depth : {"0.10", "0.11", "0.12"}) {
    ASSERT_TRUE(worker.comesTo([&] { return calls->started == 1; }));
    worker->ask(caseWith({{"defect.depth", depth}}));
  }
  ASSERT_TRUE(worker.settles());
  EXPECT_EQ(calls->started, 1);
  EXPECT_EQ(calls->made, 1);
  EXPECT_DOUBLE_EQ(depthOf(worker->take()), 0.12e-3);
}

TEST(PreviewWorker, aStateInTheMakingStopsForAnotherCase) {
  const auto calls = std::make_shared<tests::PreviewCalls>();
  Watched worker(calls, 2000, 2);
  worker->ask(caseWith({}));
  ASSERT_TRUE(worker.comesTo([&] { return calls->started == 1; }));
  worker->ask(caseWith({{"motion.speed", "20"}}));
  ASSERT_TRUE(worker.comesTo([&] { return calls->started == 2; }));
  EXPECT_EQ(calls->made, 0);
  worker->ask(nullptr);
  EXPECT_FALSE(worker->isBusy());
}

// The start is kept while nothing is wished for: what is switched on again is there at once.
TEST(PreviewWorker, aStopKeepsTheState) {
  const auto calls = std::make_shared<tests::PreviewCalls>();
  Watched worker(calls, 2, 20);
  worker->ask(caseWith({}));
  ASSERT_TRUE(worker.settles());
  worker->ask(nullptr);
  worker->ask(caseWith({{"defect.depth", "0.1"}}));
  ASSERT_TRUE(worker.settles());
  EXPECT_EQ(calls->made, 1);
  EXPECT_EQ(calls->complete, 2);
}

// Wishes every 20 ms, while a run takes 200: without patience none would ever be seen whole.
TEST(PreviewWorker, aDragIsNotBlind) {
  const auto calls = std::make_shared<tests::PreviewCalls>();
  Watched worker(calls, 2, 200);
  for (int step = 0; step < 100; ++step) {
    worker->ask(caseWith({{"defect.depth", std::to_string(0.1 + 0.001 * step)}}));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_GT(worker.farthest(), 0.03) << "[m]: 20 mm behind a defect that ends at 12 mm";
  EXPECT_GT(calls->cancelled, 10);
  // What stops everything stops a wish that is rolled on as well.
  worker->ask(nullptr);
  EXPECT_TRUE(worker.comesTo([&] { return calls->cancelled + calls->complete >= calls->begun; }));
}

TEST(AnyMoment, thePreviewThreadSurvivesTwoHundredDisturbances) {
  std::mt19937 random(20140715);
  const auto calls = std::make_shared<tests::PreviewCalls>();
  const std::vector<std::shared_ptr<const cases::CaseDescription>> wishes{caseWith({}),
                                                                          caseWith({{"defect.depth", "0.1"}}),
                                                                          caseWith({{"defect.length", "30"}}),
                                                                          caseWith({{"defect.length", "90"}}),
                                                                          caseWith({{"motion.speed", "20"}}),
                                                                          caseWith({{"defect.shape", "none"}}),
                                                                          caseWith({{"defect.move_nodes", "true"}}),
                                                                          caseWith({{"title", "fails"}}),
                                                                          nullptr};
  int closedWhileBusy = 0;
  for (int round = 0; round < 200; ++round) {
    Watched worker(calls, 4, 6);
    for (int action = 0; action < 4; ++action) {
      worker->ask(wishes[random() % wishes.size()]);
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 8000));
      worker->take();
    }
    if (random() % 3 == 0) {
      worker->ask(wishes.front());
      ASSERT_TRUE(worker.settles()) << "round " << round;
      ASSERT_EQ(worker->take().phase, PreviewPhase::done) << "round " << round;
    }
    closedWhileBusy += worker->isBusy();
  }
  // Otherwise the moments were not random enough to mean anything.
  EXPECT_GT(closedWhileBusy, 20);
  EXPECT_GT(calls->cancelled, 20);
  EXPECT_GT(calls->complete, 20);
}

// The real solver every now and then; the window goes in the middle of whatever is under way.
TEST(AnyMoment, windowsSurviveDisturbedPreviews) {
  std::mt19937 random(20140715);
  QSettings().remove("preview");
  constexpr int rounds = 40, everyReal = 10;
  int busyAtTheEnd = 0;
  for (int round = 0; round < rounds; ++round) {
    const bool real = round % everyReal == 0;
    StudioServices services = tests::services(20);
    services.threads = 1;
    const auto calls = std::make_shared<tests::PreviewCalls>();
    services.preview = real ? tests::realPreviewSolver() : tests::madeUpPreviewSolver(calls, 5, 10);
    auto window = std::make_unique<MainWindow>(services);
    window->openCase("light-defect");
    window->show();
    for (int action = 0; action < 6; ++action) {
      QTest::qWait(static_cast<int>(random() % (real ? 300 : 8)));
      auto& document = window->document();
      switch (random() % 7) {
        case 0:
          document.setParameter("defect.depth", std::to_string(0.05 + 0.001 * static_cast<double>(random() % 100)));
          break;
        case 1:
          document.setParameter("pad.stiffness", std::to_string(500 + random() % 500));
          break;
        case 2:
          window->preview().setOn(!window->preview().isOn());
          break;
        case 3:
          window->startRun();
          break;
        case 4:
          window->controller().cancel();
          break;
        case 5:
          window->setDark(random() % 2 == 0);
          break;
        default:
          window->openCase("class-c-squat");
          break;
      }
    }
    busyAtTheEnd += window->preview().isBusy();
    if (random() % 2 == 0) {
      EXPECT_TRUE(window->close());
      EXPECT_FALSE(window->preview().isBusy());
    }
    window.reset();
  }
  QSettings().remove("preview");
  EXPECT_GT(busyAtTheEnd, 3);
}

}  // namespace
}  // namespace squat::studio
