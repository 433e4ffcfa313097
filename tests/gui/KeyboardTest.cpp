// What the mouse does on figures, cursors and the model, done with keys.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QTest>
#include <cmath>
#include <memory>
#include <vector>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "plots/Figure.h"
#include "render/SyntheticResult.h"
#include "studio/common/FocusFrame.h"
#include "studio/common/KeyboardZoom.h"
#include "studio/common/Theme.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/comparison/MapWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/model/SceneWidget.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/records/RecordStrip.h"
#include "studio/signals/CursorPair.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

constexpr double rounding = 1e-9;  // of numbers of a few hundred
constexpr double notch = 0.85;     // QCustomPlot's factor for one notch of the wheel

void expectRange(const QCPAxis& axis, double lower, double upper) {
  EXPECT_NEAR(axis.range().lower, lower, rounding * std::abs(upper));
  EXPECT_NEAR(axis.range().upper, upper, rounding * std::abs(upper));
}

// Where the focus is: the first of these that holds it.
int paneOf(const std::vector<QWidget*>& panes) {
  const QWidget* focus = QApplication::focusWidget();
  for (std::size_t i = 0; i < panes.size(); ++i)
    if (focus && panes[i]->isAncestorOf(focus)) return static_cast<int>(i);
  return -1;
}

TEST(Keyboard, threeKeysReachEveryPane) {
  MainWindow window(tests::services());
  window.resize(MainWindow::usualSize);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QApplication::setActiveWindow(&window);
  std::vector<QWidget*> panes{window.form(), window.centralWidget()};
  for (const char* dock : {"signalsDock", "runDock", "runsDock"}) panes.push_back(window.findChild<QWidget*>(dock));
  const int count = static_cast<int>(panes.size());
  window.form()->row("motion.speed")->editor()->setFocus();
  for (int i = 1; i <= count; ++i) {
    QTest::keyClick(&window, Qt::Key_F6);
    EXPECT_EQ(paneOf(panes), i % count);
  }
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "motion.speed");  // where it was
  for (int i = 1; i <= count; ++i) {
    QTest::keyClick(&window, Qt::Key_F6, Qt::ShiftModifier);
    EXPECT_EQ(paneOf(panes), count - i);
  }
  EXPECT_LE(count / 2, 3);  // forwards or backwards
}

TEST(Keyboard, inAToolTheSameKeysGoBetweenOptionsAndResults) {
  MainWindow window(tests::services());
  window.findChild<QAction*>("studyAction")->trigger();
  const ToolWindow* tool = window.tool("study");
  QWidget* tools = tool->window();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(tools));
  QApplication::setActiveWindow(tools);
  QTest::keyClick(tools, Qt::Key_F6);
  const bool inOptions = tool->form()->isAncestorOf(QApplication::focusWidget());
  QTest::keyClick(tools, Qt::Key_F6);
  EXPECT_NE(tool->form()->isAncestorOf(QApplication::focusWidget()), inOptions);
}

class KeysOnAFigure : public testing::Test {
 protected:
  void SetUp() override {
    figure_.xAxis->setRange(0, 10);
    figure_.yAxis->setRange(-2, 2);
  }
  void press(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&figure_, static_cast<Qt::Key>(key), modifiers);
  }
  plots::Figure figure_{"keys", plots::lightStyle()};
};

TEST_F(KeysOnAFigure, zoomAboutTheMiddleAndMoveByATenth) {
  bool whole = false;
  new KeyboardZoom(figure_, {.showAll = [&] { whole = true; }});
  press(Qt::Key_Plus);
  expectRange(*figure_.xAxis, 5 - 5 * notch, 5 + 5 * notch);
  press(Qt::Key_Minus);
  expectRange(*figure_.xAxis, 0, 10);
  press(Qt::Key_Equal);  // where + needs Shift
  expectRange(*figure_.xAxis, 5 - 5 * notch, 5 + 5 * notch);
  press(Qt::Key_Minus);
  expectRange(*figure_.yAxis, -2, 2);
  press(Qt::Key_Plus, Qt::ShiftModifier);
  expectRange(*figure_.yAxis, -2 * notch, 2 * notch);
  press(Qt::Key_Underscore, Qt::ShiftModifier);
  expectRange(*figure_.yAxis, -2, 2);
  expectRange(*figure_.xAxis, 0, 10);
  press(Qt::Key_Right);
  expectRange(*figure_.xAxis, 1, 11);
  press(Qt::Key_Left, Qt::KeypadModifier);
  press(Qt::Key_Left);
  expectRange(*figure_.xAxis, -1, 9);
  press(Qt::Key_Up);
  expectRange(*figure_.yAxis, -1.6, 2.4);
  press(Qt::Key_Down, Qt::ControlModifier);  // another key
  expectRange(*figure_.yAxis, -1.6, 2.4);
  EXPECT_FALSE(whole);
  press(Qt::Key_Home);
  EXPECT_TRUE(whole);
}

// Four decades from 1 to 10000: the middle is 100, a notch leaves 3.4 decades, a tenth are 0.4.
TEST_F(KeysOnAFigure, takeALogarithmicAxisInDecades) {
  new KeyboardZoom(figure_, {.showAll = [] {}});
  for (QCPAxis* axis : {figure_.xAxis, figure_.yAxis}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setRange(1, 1e4);
  }
  press(Qt::Key_Plus);
  expectRange(*figure_.xAxis, std::pow(10, 2 - 2 * notch), std::pow(10, 2 + 2 * notch));
  press(Qt::Key_Minus);
  press(Qt::Key_Right);
  expectRange(*figure_.xAxis, std::pow(10, 0.4), std::pow(10, 4.4));
  press(Qt::Key_Down);
  expectRange(*figure_.yAxis, std::pow(10, -0.4), std::pow(10, 3.6));
}

TEST_F(KeysOnAFigure, zoomAboutAPlaceThatIsSeen) {
  double fixed = 8;
  new KeyboardZoom(figure_, {.showAll = [] {}, .fixed = [&] { return std::optional(fixed); }});
  press(Qt::Key_Plus);
  expectRange(*figure_.xAxis, 8 - 8 * notch, 8 + 2 * notch);
  figure_.xAxis->setRange(0, 10);
  fixed = 20;
  press(Qt::Key_Plus);
  expectRange(*figure_.xAxis, 5 - 5 * notch, 5 + 5 * notch);
}

TEST_F(KeysOnAFigure, theFrameIsSeenWithTheFocus) {
  new KeyboardZoom(figure_, {.showAll = [] {}});
  figure_.resize(300, 200);
  figure_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&figure_));
  QApplication::setActiveWindow(&figure_);
  figure_.setFocus();
  const auto* frame = figure_.findChild<FocusFrame*>();
  ASSERT_NE(frame, nullptr);
  EXPECT_TRUE(frame->isVisible());
  EXPECT_EQ(frame->geometry(), figure_.rect());
  figure_.clearFocus();
  EXPECT_FALSE(frame->isVisible());
}

// Without a curve the cursor moves by pixels.
TEST_F(KeysOnAFigure, cursorsMoveByPixelsWhereThereIsNoCurve) {
  CursorPair cursors(figure_, 0, "mm");
  figure_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&figure_));
  figure_.replot(QCustomPlot::rpImmediateRefresh);
  press(Qt::Key_B);
  EXPECT_TRUE(cursors.isVisible());
  EXPECT_EQ(cursors.lastMoved(), 1);
  EXPECT_DOUBLE_EQ(cursors.location(1), 5);
  press(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(cursors.location(1), 5 - 10.0 / figure_.axisRect()->width(), rounding);
}

class KeysOnASignal : public testing::Test {
 protected:
  void SetUp() override {
    store_.add({tests::sharedSyntheticResult(), "run", {}, false});
    panel_.showTab("aba_position");
    panel_.resize(700, 500);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    QApplication::setActiveWindow(&panel_);
    figure()->setFocus();
  }
  FigureView& view() { return *panel_.view("aba_position"); }
  plots::Figure* figure() { return view().figure(); }
  void press(int key, Qt::KeyboardModifiers modifiers = {}) { tests::press(panel_, key, modifiers); }
  RunStore store_;
  SignalsPanel panel_{store_, figureStyle(false)};
};

// The made-up run has samples every 1.2 mm (30 m/s, 25 kHz) from -200 mm on.
TEST_F(KeysOnASignal, cursorsAreSetAndMovedByKeys) {
  constexpr double first = -200, sample = 1.2;  // [mm]
  const auto* box = panel_.findChild<QCheckBox*>("cursors");
  const double middle = figure()->xAxis->range().center();
  EXPECT_TRUE(figure()->accessibleDescription().contains("Home"));
  press(Qt::Key_A);
  EXPECT_TRUE(box->isChecked());
  const CursorPair& cursors = *view().cursors();
  ASSERT_TRUE(cursors.isVisible());
  EXPECT_DOUBLE_EQ(cursors.location(0), middle);
  const double other = cursors.location(1);
  press(Qt::Key_Right, Qt::ControlModifier);
  const double next = first + sample * std::ceil((middle - first) / sample);
  EXPECT_NEAR(cursors.location(0), next, 1e-6);
  press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(cursors.location(0), next + sample, 1e-6);
  press(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(cursors.location(0), next - 9 * sample, 1e-6);
  EXPECT_EQ(cursors.location(1), other);
  EXPECT_EQ(figure()->accessibleDescription(), cursors.text());  // what is read out is what is shown
  // B is in sight and stays where it is, until it is moved.
  press(Qt::Key_B);
  EXPECT_EQ(cursors.location(1), other);
  press(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_LT(cursors.location(1), other);
  press(Qt::Key_Escape);
  EXPECT_FALSE(cursors.isVisible());
  EXPECT_FALSE(box->isChecked());
  EXPECT_TRUE(figure()->accessibleDescription().contains("Home"));
}

TEST_F(KeysOnASignal, homeShowsAllAgain) {
  const QCPRange whole = figure()->xAxis->range();
  press(Qt::Key_Plus);
  EXPECT_NEAR(figure()->xAxis->range().size(), notch * whole.size(), rounding * whole.size());
  EXPECT_TRUE(view().isZoomed());
  press(Qt::Key_Home);
  EXPECT_EQ(figure()->xAxis->range(), whole);
}

// The figure is another one, which has the focus and the cursors of the one before.
TEST_F(KeysOnASignal, keysStayWithAFigureThatIsDrawnAnew) {
  press(Qt::Key_B);
  store_.add({tests::sharedSyntheticResult(), "another", {}, false});
  store_.setData(store_.index(0), Qt::Checked, Qt::CheckStateRole);
  EXPECT_TRUE(figure()->hasFocus());
  const double before = view().cursors()->location(1);
  press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_GT(view().cursors()->location(1), before);
}

TEST_F(KeysOnASignal, theViewIsZoomedAboutTheCursor) {
  press(Qt::Key_A);
  view().cursors()->setLocations(40, 50);
  figure()->xAxis->setRange(0, 200);
  press(Qt::Key_Plus);
  expectRange(*figure()->xAxis, 40 - 40 * notch, 40 + 160 * notch);
}

// Escape takes the cursors away, and never a window in which one works; Ctrl+W does that.
TEST(Keyboard, escapeIsOfTheInnermostThing) {
  MainWindow window(tests::services());
  for (const char* label : {"one", "two"}) window.store().add({tests::sharedSyntheticResult(), label, {}, false});
  window.comparison()->showMaps();
  MapWindow& maps = *window.comparison()->maps();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&maps));
  QApplication::setActiveWindow(&maps);
  FigureView& view = *maps.view(0);
  view.figure()->setFocus();
  tests::press(maps, Qt::Key_A);
  ASSERT_TRUE(view.cursors()->isVisible());
  tests::press(maps, Qt::Key_Escape);
  EXPECT_FALSE(view.cursors()->isVisible());
  EXPECT_TRUE(maps.isVisible());
  tests::press(maps, Qt::Key_Escape);
  EXPECT_TRUE(maps.isVisible());
  tests::press(maps, Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(maps.isVisible());
}

// A record of 100 m with a sample every 0.5 m.
TEST(Keyboard, theStripOfARecordIsZoomedAndScrolled) {
  records::RecordLayout layout;
  layout.channels = {{"aba", "m/s2"}};
  records::RecordBlock block;
  block.values.resize(1);
  for (int i = 0; i < 200; ++i) {
    block.position.push_back(0.5 * i + 0.05);
    block.values[0].push_back(i % 7);
  }
  const auto overview = std::make_shared<records::Overview>();
  overview->add(layout, block);
  RecordStrip strip(figureStyle(false));
  strip.follow(overview);
  strip.showWhole();
  const QCPAxis& along = *strip.figure()->xAxis;
  const QCPRange whole = along.range(), up = strip.figure()->yAxis->range();
  const double middle = whole.center(), half = 0.5 * notch * whole.size();
  EXPECT_NEAR(whole.size(), 100, 1);
  QTest::keyClick(strip.figure(), Qt::Key_Plus);
  expectRange(along, middle - half, middle + half);
  QTest::keyClick(strip.figure(), Qt::Key_Right);
  expectRange(along, middle - 0.8 * half, middle + 1.2 * half);
  QTest::keyClick(strip.figure(), Qt::Key_Up);  // the height follows the signal
  EXPECT_EQ(strip.figure()->yAxis->range(), up);
  QTest::qWait(300);  // the strip looks for news of the record, and leaves the view alone
  expectRange(along, middle - 0.8 * half, middle + 1.2 * half);
  QTest::keyClick(strip.figure(), Qt::Key_Home);
  EXPECT_EQ(along.range(), whole);
}

TEST(Keyboard, theModelIsTurnedMovedAndZoomed) {
  SceneWidget scene;
  scene.resize(400, 300);
  scene.setResult(tests::sharedSyntheticResult());
  scene.lookFrom(scene::StandardView::side);
  ASSERT_TRUE(scene.isAvailable()) << scene.reason().toStdString();
  constexpr double tolerance = 1e-6;  // [degrees] or [m]: turning by sine and cosine
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&scene, key, modifiers);
  };
  const scene::Eye before = scene.eye();
  EXPECT_NEAR(before.azimuth, -90, tolerance);  // from the side of negative y
  EXPECT_NEAR(before.elevation, 0, tolerance);
  press(Qt::Key_Left);
  EXPECT_NEAR(scene.eye().azimuth, -85, tolerance);
  press(Qt::Key_Right);
  press(Qt::Key_Right);
  EXPECT_NEAR(scene.eye().azimuth, -95, tolerance);
  press(Qt::Key_Down);
  EXPECT_NEAR(scene.eye().elevation, 5, tolerance);
  EXPECT_NEAR(scene.eye().azimuth, -95, tolerance);
  press(Qt::Key_Up);
  EXPECT_NEAR(scene.eye().elevation, 0, tolerance);
  press(Qt::Key_Plus);
  EXPECT_NEAR(scene.eye().reach, before.reach / 1.15, tolerance);  // as a notch of the wheel
  press(Qt::Key_Minus);
  EXPECT_NEAR(scene.eye().reach, before.reach, tolerance);
  // From the side x runs to the right: the model moves there by a tenth of the height, which is 2 x reach.
  scene.lookFrom(scene::StandardView::side);
  press(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(scene.eye().target[0], before.target[0] - 0.2 * before.reach, tolerance);
  press(Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(scene.eye().target[2], before.target[2] - 0.2 * before.reach, tolerance);
  press(Qt::Key_Home);
  const scene::Eye home = scene.eye();
  scene.lookFrom(scene::StandardView::overview);
  EXPECT_NEAR(home.azimuth, scene.eye().azimuth, tolerance);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(home.target[axis], scene.eye().target[axis], tolerance);
}

// Share that one key leaves of the range of the abscissa.
double zoomedShare(plots::Figure& figure) {
  const auto length = [&] {
    const QCPRange range = figure.xAxis->range();
    return figure.xAxis->scaleType() == QCPAxis::stLogarithmic ? std::log(range.upper / range.lower) : range.size();
  };
  const double before = length();
  QTest::keyClick(&figure, Qt::Key_Plus);
  return length() / before;
}

// Every figure in `window` on which the mouse zooms; how many there are.
int judgeFigures(const QWidget& window) {
  int seen = 0;
  for (auto* figure : window.findChildren<plots::Figure*>()) {
    if (!figure->isVisible() || !figure->interactions().testFlag(QCP::iRangeZoom)) continue;
    SCOPED_TRACE(figure->objectName().toStdString());
    EXPECT_TRUE(figure->focusPolicy() & Qt::TabFocus);
    EXPECT_FALSE(figure->accessibleName().isEmpty());
    for (const char* words : {"zoom", "move the view", "Home"})
      EXPECT_TRUE(figure->accessibleDescription().contains(words)) << words;
    EXPECT_NE(figure->findChild<FocusFrame*>(), nullptr);
    EXPECT_NEAR(zoomedShare(*figure), notch, 1e-6);
    ++seen;
  }
  return seen;
}

TEST(Keyboard, everyFigureThatTheMouseZoomsTakesKeys) {
  MainWindow window(tests::services());
  ASSERT_TRUE(window.openCase("light-defect"));
  for (const char* label : {"one", "two"}) window.store().add({tests::sharedSyntheticResult(), label, {}, false});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  int seen = 0;
  for (const QString& tab : MainWindow::tabNames()) {
    window.showTab(tab);
    QTest::qWait(20);
    seen += judgeFigures(window);
  }
  EXPECT_GT(seen, 10);  // profile and signals
  EXPECT_TRUE(window.findChild<SceneWidget*>()->accessibleDescription().contains("Home"));
  window.comparison()->showMaps();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.comparison()->maps()));
  EXPECT_EQ(judgeFigures(*window.comparison()->maps()), 3);
  window.findChild<QAction*>("squatsAction")->trigger();
  const ToolWindow* squats = window.tool("squats");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(squats->window()));
  EXPECT_EQ(judgeFigures(*squats), 1);  // the strip
}

}  // namespace
}  // namespace squat::studio
