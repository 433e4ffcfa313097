// What the live preview costs, with the real solver: how soon the curve is there, and whether the window keeps
// answering while previews restart twenty times a second. Wall times are printed, as other programs may be busy.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gui/EventWaits.h"
#include "gui/MadeUpRun.h"
#include "gui/PreviewSolvers.h"
#include "studio/preview/CurvePlot.h"
#include "studio/preview/PreviewPanel.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfileModel.h"
#include "studio/profile/ProfilePlot.h"

namespace squat::studio {
namespace {

constexpr int patience = 240000;  // [ms]

std::unique_ptr<MainWindow> windowWithPreview(const QString& name = "light-defect") {
  StudioServices services = tests::services();
  services.preview = tests::realPreviewSolver();
  auto window = std::make_unique<MainWindow>(services);
  window->resize(1500, 920);
  window->openCase(name);
  window->showTab("preview");
  window->show();
  return window;
}

TEST(PreviewSpeed, fromTheChangeToTheCurve) {
  auto window = windowWithPreview();
  ASSERT_TRUE(window->preview().waitFor(patience));
  std::vector<double> behindBottom, whole;  // [s]
  for (int round = 0; round < 7; ++round) {
    QElapsedTimer clock;
    double seen = 0;
    const auto watch = QObject::connect(&window->preview(), &PreviewController::changed, [&](const Preview& preview) {
      if (seen == 0 && preview.phase == PreviewPhase::rolling && preview.position.back() > 0)
        seen = 1e-3 * static_cast<double>(clock.elapsed());
    });
    clock.start();
    window->document().setParameter("defect.depth", std::to_string(0.1 + 0.01 * round));
    ASSERT_TRUE(window->preview().waitFor(patience));
    whole.push_back(1e-3 * static_cast<double>(clock.elapsed()));
    behindBottom.push_back(seen);
    QObject::disconnect(watch);
    ASSERT_EQ(window->preview().latest().phase, PreviewPhase::done);
  }
  std::sort(behindBottom.begin(), behindBottom.end());
  std::sort(whole.begin(), whole.end());
  std::printf("preview of a changed depth, fastest and median of %zu:\n", whole.size());
  std::printf("  first point behind the bottom %.3f, %.3f s (0.25 s asked)\n", behindBottom[0], behindBottom[3]);
  std::printf("  whole preview                 %.3f, %.3f s (0.6 s asked)\n", whole[0], whole[3]);
}

// A drag at twenty changes a second, every event of it delivered. The pulse is a timer of the window's own thread: what
// it is late is what any event has to wait.
TEST(PreviewSpeed, theWindowAnswersWhilePreviewsRestartForAMinute) {
  auto window = windowWithPreview();
  ASSERT_TRUE(window->preview().waitFor(patience));
  tests::EventWaits waits;
  const int shown = tests::dragAtTwentyChangesASecond(*window, 60000);
  waits.stop();
  waits.print("previews that restart 20 times a second for a minute");
  std::printf("  %d pictures of the preview were shown\n", shown);
  EXPECT_GT(shown, 100);
  EXPECT_LT(waits.processorTime(1), 50) << "a turn of the event loop";
}

// A point of a profile is dragged for five seconds, sixty times a second: each move is drawn before the next one.
TEST(PreviewSpeed, theFramesOfADrag) {
  auto window = windowWithPreview();
  window->showTab("profile");
  window->document().edit("points", asPoints(window->document().description()));
  ASSERT_TRUE(window->preview().waitFor(patience));
  ProfilePlot& plot = *window->profile()->plot();
  const QPointF from = plot.locationOf(window->document().description().defect.points.size() / 2);
  QTest::mousePress(&plot, Qt::LeftButton, {}, from.toPoint());
  constexpr int frames = 300, every = 16;  // [ms]
  std::vector<double> wall, busy;          // [ms]
  QElapsedTimer clock;
  for (int i = 0; i < frames; ++i) {
    const QPointF to = from + QPointF(0, 25 * std::sin(0.05 * i));
    const double before = tests::threadMilliseconds();
    clock.start();
    QMouseEvent move(QEvent::MouseMove, to, plot.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&plot, &move);
    QApplication::processEvents();
    wall.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    busy.push_back(tests::threadMilliseconds() - before);
    QTest::qWait(std::max(0, every - static_cast<int>(clock.elapsed())));
  }
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, from.toPoint());
  std::sort(wall.begin(), wall.end());
  std::sort(busy.begin(), busy.end());
  constexpr std::size_t middle = frames / 2, last = frames * 99 / 100;
  std::printf(
      "a point that is dragged, %d frames: 50 %% %.1f, 99 %% %.1f, largest %.1f ms; of processor time %.1f, %.1f, "
      "%.1f ms\n",
      frames, wall[middle], wall[last], wall.back(), busy[middle], busy[last], busy.back());
  EXPECT_LT(busy[last], 33);  // thirty frames a second
  EXPECT_EQ(window->document().undoStack().count(), 2);
}

}  // namespace
}  // namespace squat::studio
