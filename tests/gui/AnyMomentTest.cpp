// Pause, resume, cancel, start and close at random moments, 200 times, around runs in threads of their own. Meant for
// the sanitizers (.ci/sanitizers); passes in seconds without them.
#include <gtest/gtest.h>

#include <QTest>
#include <memory>
#include <random>

#include "gui/MadeUpRun.h"
#include "simulation/RunCase.h"

namespace squat::studio {
namespace {

constexpr int rounds = 200;
constexpr int everyReal = 20;    // every so many rounds the real computation runs
constexpr int patience = 60000;  // [ms] for sanitizers

cases::CaseDescription shortCase(MainWindow& window) {
  window.openCase("light-defect");
  window.document().setParameter("mesh.preset", "tiny");
  window.document().setParameter("motion.run_up", "0.05");
  window.document().setParameter("motion.beyond", "0.05");
  return window.document().description();
}

// Four actions a round, a few milliseconds (a real run: some hundred) apart.
void disturb(MainWindow& window, std::mt19937& random, int longest) {
  RunController& controller = window.controller();
  for (int action = 0; action < 4; ++action) {
    QTest::qWait(static_cast<int>(random() % static_cast<unsigned>(longest)));
    switch (random() % 4) {
      case 0:
        controller.setPaused(true);
        break;
      case 1:
        controller.setPaused(false);
        break;
      case 2:
        controller.cancel();
        break;
      default:
        window.startRun();  // does nothing while one is going on
        break;
    }
  }
}

TEST(AnyMoment, windowsSurviveTwoHundredDisturbedRuns) {
  std::mt19937 random(20140715);
  int stoppedByClosing = 0;
  for (int round = 0; round < rounds; ++round) {
    const bool real = round % everyReal == 0;
    StudioServices services = tests::services(30);
    if (real) services.runner = simulation::runCase;
    services.threads = 2;
    auto window = std::make_unique<MainWindow>(services);
    shortCase(*window);
    window->show();
    window->startRun();
    ASSERT_TRUE(window->controller().isRunning()) << "round " << round;
    disturb(*window, random, real ? 400 : 5);
    const unsigned ending = random() % 3;
    if (ending == 0) {
      window->controller().setPaused(false);
      if (real) window->controller().cancel();
      ASSERT_TRUE(window->controller().waitFor(patience)) << "round " << round;
    }
    stoppedByClosing += window->controller().isRunning();
    if (ending == 1) {
      ASSERT_TRUE(window->close()) << "round " << round;
      EXPECT_FALSE(window->controller().isRunning());
    }
    window.reset();  // also in the middle of a run
  }
  // Otherwise the moments were not random enough to mean anything.
  EXPECT_GT(stoppedByClosing, rounds / 10);
}

}  // namespace
}  // namespace squat::studio
