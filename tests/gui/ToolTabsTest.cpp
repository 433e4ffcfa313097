// One window with a tab for each tool, tools that are detached from it, and what is remembered of both.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QIcon>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <memory>
#include <thread>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "studio/common/MessageBar.h"
#include "studio/common/Theme.h"
#include "studio/tools/ToolTabs.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

constexpr Qt::KeyboardModifiers controlShift = Qt::ControlModifier | Qt::ShiftModifier;

QTabWidget& tabsOf(const ToolTabs& tools) {
  return *tools.findChild<QTabWidget*>(QString(), Qt::FindDirectChildrenOnly);
}

QStringList titlesOf(const ToolTabs& tools) {
  QStringList titles;
  for (int at = 0; at < tabsOf(tools).count(); ++at) titles << tabsOf(tools).tabText(at);
  return titles;
}

void clickPlace(const ToolWindow& tool) { tests::click(*tool.findChild<QPushButton*>("toolPlace")); }

// The tools of the main window.
class TabsOfTools : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tools");
    window_ = std::make_unique<MainWindow>(tests::services());
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  }
  void TearDown() override {
    window_.reset();
    QSettings().remove("tools");
  }
  ToolWindow& open(const QString& name) const {
    window_->findChild<QAction*>(name + "Action")->trigger();
    ToolWindow& tool = *window_->tool(name);
    EXPECT_TRUE(tool.isVisible());
    EXPECT_TRUE(QTest::qWaitForWindowExposed(tool.window()));
    return tool;
  }
  ToolTabs& tools() const { return *window_->toolTabs(); }

  std::unique_ptr<MainWindow> window_;
};

TEST_F(TabsOfTools, areOfOneWindow) {
  const ToolWindow &study = open("study"), &growth = open("growth");
  EXPECT_EQ(study.window(), &tools());
  EXPECT_EQ(growth.window(), &tools());
  EXPECT_FALSE(study.isVisible());
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Study", "Growth"}));
  EXPECT_EQ(tools().windowTitle(), "Growth under traffic - Squat Studio");
  open("study");
  EXPECT_FALSE(growth.isVisible());
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Study", "Growth"}));
  EXPECT_EQ(tools().windowTitle(), "Study - Squat Studio");
  tests::press(tools(), Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_TRUE(growth.isVisible());
  tests::press(tools(), Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_TRUE(study.isVisible());
  tests::press(tools(), Qt::Key_PageUp, Qt::ControlModifier);
  EXPECT_TRUE(growth.isVisible());
}

// Closed, its tab goes to where it was when the tool is opened again.
TEST_F(TabsOfTools, aTabThatWasClosedComesBackToItsPlace) {
  ToolWindow& study = open("study");
  open("calibration");
  open("growth");
  EXPECT_TRUE(tools().isOpen(study)) << "behind another tab";
  Q_EMIT tabsOf(tools()).tabCloseRequested(0);
  EXPECT_FALSE(tools().isOpen(study));
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Calibration", "Growth"}));
  open("study");
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Study", "Calibration", "Growth"}));
  EXPECT_EQ(tabsOf(tools()).currentWidget(), &study);
  tools().close();
  EXPECT_FALSE(tools().isOpen(study));
  open("growth");
  EXPECT_TRUE(tools().isOpen(study)) << "the window's tabs are those that it had";
}

TEST_F(TabsOfTools, areDetachedAndAttached) {
  ToolWindow& study = open("study");
  const auto* place = study.findChild<QPushButton*>("toolPlace");
  EXPECT_EQ(place->text(), "Detach");
  clickPlace(study);
  ASSERT_TRUE(tests::passes([&] { return study.isWindow() && study.isVisible(); }));
  EXPECT_EQ(place->text(), "Attach");
  EXPECT_EQ(study.windowTitle(), "Study - Squat Studio");
  EXPECT_FALSE(tools().isVisible()) << "it was the only tab";
  const ToolWindow& growth = open("growth");
  EXPECT_TRUE(study.isVisible());
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Growth"}));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&study));
  tests::press(study, Qt::Key_D, controlShift);
  ASSERT_TRUE(tests::passes([&] { return !study.isWindow() && study.isVisible(); }));
  EXPECT_EQ(place->text(), "Detach");
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Study", "Growth"}));
  EXPECT_FALSE(growth.isVisible());
}

TEST_F(TabsOfTools, aDoubleClickOnTheTabDetaches) {
  const ToolWindow &study = open("study"), &growth = open("growth");
  QTabBar* bar = tabsOf(tools()).tabBar();
  QTest::mouseDClick(bar, Qt::LeftButton, {}, bar->tabRect(0).center());
  EXPECT_TRUE(tests::passes([&] { return study.isWindow() && study.isVisible(); }));
  EXPECT_FALSE(growth.isWindow());
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Growth"}));
}

// It stays detached: the next time it opens in its window.
TEST_F(TabsOfTools, closingADetachedOneHidesIt) {
  ToolWindow& study = open("study");
  tools().detach(study);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&study));
  EXPECT_TRUE(tools().isOpen(study));
  tests::press(study, Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(study.isVisible());
  EXPECT_FALSE(tools().isOpen(study));
  open("study");
  EXPECT_TRUE(study.isWindow());
  EXPECT_FALSE(tools().isVisible());
}

// "Start" has the same key in all of them. A calibration without targets says what is missing.
TEST_F(TabsOfTools, keysOfButtonsAreThoseOfTheTabInFront) {
  ToolWindow &study = open("study"), &calibration = open("calibration");
  QApplication::setActiveWindow(&tools());
  tests::press(tools(), Qt::Key_S, Qt::AltModifier);
  EXPECT_TRUE(tests::passes([&] { return !calibration.messages()->isEmpty(); }));
  EXPECT_TRUE(study.messages()->isEmpty()) << study.messages()->text().toStdString();
  EXPECT_FALSE(study.isBusy());
}

TEST_F(TabsOfTools, theLayoutIsReset) {
  ToolWindow& study = open("study");
  const ToolWindow& growth = open("growth");
  tools().detach(study);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&study));
  window_->findChild<QAction*>("resetLayout")->trigger();
  EXPECT_FALSE(study.isWindow());
  EXPECT_TRUE(tools().isOpen(study));
  EXPECT_EQ(tabsOf(tools()).currentWidget(), &growth);
  EXPECT_EQ(titlesOf(tools()), (QStringList{"Study", "Growth"}));
  EXPECT_FALSE(QSettings().contains("tools/study/geometry"));
  open("study");
  EXPECT_FALSE(study.isWindow());
}

// All of them, with room for every tab.
TEST_F(TabsOfTools, fitASmallScreen) {
  constexpr QSize smallScreen(1024, 700);
  for (const char* name : {"study", "calibration", "growth", "receptance", "squats", "estimate"}) open(name);
  const QSize least = tools().minimumSizeHint();
  EXPECT_LE(least.width(), smallScreen.width());
  EXPECT_LE(least.height(), smallScreen.height());
  tools().resize(smallScreen);
  QTest::qWait(20);
  const QTabBar* bar = tabsOf(tools()).tabBar();
  EXPECT_LE(bar->sizeHint().width(), bar->width());
}

// A tool that computes until it is cancelled.
class Endless : public ToolForm {
 public:
  explicit Endless(const QString& name) : name_(name) {}
  QString name() const override { return name_; }
  QString title() const override { return "Tool " + name_; }
  QString shortTitle() const override { return name_; }
  QString explanation() const override { return "Computes until it is cancelled."; }
  QString subject() const override { return "The work"; }
  bool usesCase() const override { return false; }
  ToolWork work() override {
    return [](const ToolInput&, Monitor& monitor) {
      while (!monitor.cancelled()) std::this_thread::yield();
      return ToolResult();
    };
  }

 private:
  QString name_;
};

// Tools without a main window.
class RememberedTabs : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().remove("tools");
    start();
  }
  void TearDown() override {
    tools_.reset();
    QSettings().remove("tools");
  }
  // As when the program starts again.
  void start() {
    tools_.reset();
    tools_ = std::make_unique<ToolTabs>();
    made_.clear();
    for (const char* name : {"one", "two", "three"}) {
      made_.push_back(new ToolWindow(
          document_, new Endless(name), [] { return QString(); }, figureStyle(false)));
      tools_->add(made_.back());
    }
  }
  void openAll() {
    for (ToolWindow* tool : made_) tools_->open(*tool);
  }

  CaseDocument document_;
  std::unique_ptr<ToolTabs> tools_;
  std::vector<ToolWindow*> made_;
};

TEST_F(RememberedTabs, comeBackInTheirOrder) {
  openAll();
  EXPECT_EQ(titlesOf(*tools_), (QStringList{"one", "two", "three"}));
  tabsOf(*tools_).tabBar()->moveTab(2, 0);
  EXPECT_EQ(titlesOf(*tools_), (QStringList{"three", "one", "two"}));
  made_[0]->close();
  tabsOf(*tools_).tabBar()->moveTab(0, 1);  // "one" keeps its place between them
  start();
  EXPECT_EQ(titlesOf(*tools_), QStringList()) << "none is open before it is asked for";
  EXPECT_FALSE(tools_->isVisible());
  openAll();
  EXPECT_EQ(titlesOf(*tools_), (QStringList{"two", "one", "three"}));
}

TEST_F(RememberedTabs, detachedOnesComeBackInTheirWindows) {
  openAll();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(tools_.get()));
  tools_->detach(*made_[1]);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(made_[1]));
  const QSize size = made_[1]->minimumSizeHint() + QSize(13, 27);
  made_[1]->resize(size);
  QTest::qWait(20);
  ASSERT_EQ(made_[1]->size(), size);
  start();
  openAll();
  EXPECT_TRUE(made_[1]->isWindow());
  EXPECT_TRUE(made_[1]->isVisible());
  EXPECT_EQ(made_[1]->size(), size);
  EXPECT_EQ(titlesOf(*tools_), (QStringList{"one", "three"}));
}

// A dot in the tab, the words in its tool tip; closing the tab stops nothing.
TEST_F(RememberedTabs, aTabShowsThatItsToolComputes) {
  openAll();
  const QTemporaryDir folder;
  made_[0]->setFolder(folder.path());
  const auto hasDot = [this](int at) {
    const QImage dot = tabsOf(*tools_).tabIcon(at).pixmap(16, 16).toImage();
    return dot.pixelColor(dot.rect().center()).alpha() > 0;
  };
  const QTabBar* bar = tabsOf(*tools_).tabBar();
  EXPECT_FALSE(hasDot(0));
  const QRect before = bar->tabRect(1);
  made_[0]->start();
  EXPECT_TRUE(hasDot(0));
  EXPECT_FALSE(hasDot(1));
  EXPECT_EQ(bar->tabToolTip(0), "Tool one: " + made_[0]->progress());
  EXPECT_EQ(bar->accessibleTabName(0), "Tool one, computing");
  EXPECT_EQ(bar->tabRect(1), before);
  made_[0]->close();
  EXPECT_TRUE(made_[0]->isComputing());
  tools_->open(*made_[0]);
  EXPECT_TRUE(hasDot(0));
  made_[0]->cancel();
  ASSERT_TRUE(made_[0]->waitFor(tests::patience));
  EXPECT_FALSE(hasDot(0));
  EXPECT_EQ(bar->tabToolTip(0), "Tool one");
}

}  // namespace
}  // namespace squat::studio
