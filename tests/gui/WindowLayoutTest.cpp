// Where the parts of the main window stand: who gets the width that is added, and the way back to the first layout.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QSettings>
#include <QSplitter>
#include <QTest>
#include <QWindow>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"

namespace squat::studio {
namespace {

class WindowLayout : public testing::Test {
 protected:
  static constexpr int rounding = 2;  // [pixels]
  void SetUp() override {
    for (const char* key : {"geometry", "state", "signalsWidth"}) QSettings().remove(key);
    window_ = std::make_unique<MainWindow>(tests::services());
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    resize(MainWindow::usualSize);
  }
  void TearDown() override {
    for (const char* key : {"geometry", "state", "signalsWidth"}) QSettings().remove(key);
  }
  void resize(QSize size) const {
    window_->resize(size);
    QTest::qWait(30);
    ASSERT_EQ(window_->size(), size);
  }
  void resizeTo(int width) const { resize({width, MainWindow::usualSize.height()}); }
  QDockWidget* dock(const char* name) const { return window_->findChild<QDockWidget*>(name); }
  int signalsWidth() const { return dock("signalsDock")->width(); }
  // By its left edge; the window applies it between events.
  void dragSignals(int distance) const {
    const QWidget* middle = window_->centralWidget();
    const QPoint from((middle->geometry().right() + dock("signalsDock")->geometry().left()) / 2,
                      middle->geometry().center().y());
    const QPoint to = from + QPoint(distance, 0);
    QWindow* handle = window_->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    for (const QPoint& place : {(from + to) / 2, to}) {
      QTest::mouseMove(handle, place);
      QTest::qWait(50);
    }
    QTest::mouseRelease(handle, Qt::LeftButton, {}, to);
  }

  std::unique_ptr<MainWindow> window_;
};

// 2000 pixels more: 1300 for the signals, 700 for the middle, none for the form.
TEST_F(WindowLayout, signalsGetMostOfTheWidthThatIsAdded) {
  const int form = dock("caseDock")->width(), middle = window_->centralWidget()->width(), before = signalsWidth();
  EXPECT_NEAR(before, 480, rounding);
  resizeTo(3500);
  EXPECT_NEAR(signalsWidth() - before, 1300, rounding);
  EXPECT_NEAR(window_->centralWidget()->width() - middle, 700, rounding);
  EXPECT_NEAR(dock("caseDock")->width(), form, rounding);
  resizeTo(1000);  // the form is in a tab there
  resizeTo(1500);
  EXPECT_NEAR(signalsWidth(), before, rounding);
}

TEST_F(WindowLayout, theWidthThatTheUserGaveCounts) {
  const int before = signalsWidth();
  dragSignals(-150);
  const int chosen = signalsWidth();
  ASSERT_GT(chosen, before + 100);  // 150 pixels, less what the style needs to begin a drag
  resizeTo(2500);
  EXPECT_NEAR(signalsWidth(), chosen + 650, rounding);
  resizeTo(1500);
  EXPECT_NEAR(signalsWidth(), chosen, rounding);
  EXPECT_TRUE(window_->close());
  window_ = std::make_unique<MainWindow>(tests::services());
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  resizeTo(1500);
  EXPECT_NEAR(signalsWidth(), chosen, rounding);
}

// Form, middle and signals beside each other, the run and the list of runs below the last two.
TEST_F(WindowLayout, resetPutsEverythingBack) {
  constexpr int close = 20;  // [pixels] a handle and a frame
  const char* docks[] = {"caseDock", "signalsDock", "runDock", "runsDock"};
  window_->resetLayout();
  QTest::qWait(30);
  QRect before[4];
  for (int i = 0; i < 4; ++i) before[i] = dock(docks[i])->geometry();
  const QRect middle = window_->centralWidget()->geometry();
  EXPECT_LT(before[0].right(), middle.left());
  EXPECT_LT(middle.right(), before[1].left());
  EXPECT_NEAR(before[1].width(), 480, rounding);
  EXPECT_LT(middle.bottom(), before[2].top());
  EXPECT_NEAR(before[2].height(), 250, close);
  EXPECT_LT(before[0].right(), before[2].left());
  EXPECT_LT(before[2].right(), before[3].left());
  EXPECT_EQ(before[2].top(), before[3].top());
  auto* splitter = window_->centralWidget()->findChild<QSplitter*>();
  ASSERT_NE(splitter, nullptr);
  const QList<int> sizes = splitter->sizes();
  dock("signalsDock")->setFloating(true);
  dock("runDock")->hide();
  window_->addDockWidget(Qt::RightDockWidgetArea, dock("caseDock"));
  window_->tabifyDockWidget(dock("caseDock"), dock("runsDock"));
  splitter->setSizes({sizes[0] - 100, sizes[1] + 100});
  QTest::qWait(30);
  tests::press(*window_, Qt::Key_L, Qt::ControlModifier | Qt::AltModifier);
  QTest::qWait(30);
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(docks[i]);
    const QRect after = dock(docks[i])->geometry();
    EXPECT_TRUE(dock(docks[i])->isVisible());
    EXPECT_FALSE(dock(docks[i])->isFloating());
    EXPECT_NEAR(after.left(), before[i].left(), close);
    EXPECT_NEAR(after.right(), before[i].right(), close);
    EXPECT_NEAR(after.top(), before[i].top(), close);
    EXPECT_NEAR(after.bottom(), before[i].bottom(), close);
  }
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(splitter->sizes()[i], sizes[i], close) << i;
}

// A narrow window has the form in a tab, where it stays.
TEST_F(WindowLayout, resetLeavesTheFormOfANarrowWindowInItsTab) {
  resize(MainWindow::smallestSize);
  window_->findChild<QAction*>("resetLayout")->trigger();
  QTest::qWait(30);
  EXPECT_FALSE(dock("caseDock")->isVisible());
  for (const char* name : {"signalsDock", "runDock", "runsDock"}) EXPECT_TRUE(dock(name)->isVisible()) << name;
  EXPECT_EQ(window_->size(), MainWindow::smallestSize);
  resizeTo(1500);
  EXPECT_TRUE(dock("caseDock")->isVisible());
}

}  // namespace
}  // namespace squat::studio
