// Where there is nothing to see yet, the next step stands in its place.
#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTest>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "studio/common/Theme.h"
#include "studio/records/RecordView.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/CalibrationForm.h"
#include "studio/tools/DetectionForm.h"
#include "studio/tools/TargetList.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

// Texts within the figure that are seen.
QString wordsIn(const plots::Figure& figure) {
  QStringList words;
  for (int i = 0; i < figure.itemCount(); ++i)
    if (const auto* text = qobject_cast<QCPItemText*>(figure.item(i)); text && text->visible()) words << text->text();
  return words.join(" | ");
}

TEST(EmptyStates, signalsSayWhatToDo) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  const auto* tabs = panel.findChild<QTabWidget*>();
  int seen = 0;
  for (const QString& name : SignalsPanel::names()) {
    if (!tabs->isTabVisible(static_cast<int>(SignalsPanel::names().indexOf(name)))) continue;
    SCOPED_TRACE(name.toStdString());
    panel.showTab(name);
    const plots::Figure& figure = *panel.view(name)->figure();
    EXPECT_FALSE(figure.xAxis->realVisibility());
    EXPECT_FALSE(figure.yAxis->realVisibility());
    const QString words = wordsIn(figure);
    for (const char* step : {"F5", "Ctrl+M", "Ctrl+Shift+O"}) EXPECT_TRUE(words.contains(step)) << words.toStdString();
    EXPECT_FALSE(words.contains("in this result")) << words.toStdString();
    ++seen;
  }
  EXPECT_GE(seen, 5);  // acceleration twice, spectrum, two maps
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("aba_position");
  EXPECT_TRUE(panel.view("aba_position")->figure()->xAxis->realVisibility());
  EXPECT_FALSE(wordsIn(*panel.view("aba_position")->figure()).contains("F5"));
}

// A measured signal alone is drawn; what is drawn of runs alone says so.
TEST(EmptyStates, aMeasuredSignalWithoutARunIsSeen) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({nullptr, "measured", "/nowhere/measured.csv", true, tests::sharedSyntheticResult()});
  panel.showTab("aba_position");
  const plots::Figure& along = *panel.view("aba_position")->figure();
  EXPECT_TRUE(along.xAxis->realVisibility());
  EXPECT_EQ(wordsIn(along), "");
  panel.showTab("scalogram");
  const plots::Figure& map = *panel.view("scalogram")->figure();
  EXPECT_FALSE(map.xAxis->realVisibility());
  EXPECT_TRUE(wordsIn(map).contains("F5")) << wordsIn(map).toStdString();
}

// 300 m: 10 s at 30 m/s, as the manual says of the record that is shipped.
TEST(EmptyStates, theWindowOfRecordsOffersTheSample) {
  QSettings().remove("tools");
  MainWindow window(tests::services());
  window.show();
  window.findChild<QAction*>("squatsAction")->trigger();
  ToolWindow* tool = window.tool("squats");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(tool->window()));
  const auto* form = qobject_cast<DetectionForm*>(tool->form());
  const RecordStrip* strip = form->records()->strip();
  auto* button = strip->findChild<QPushButton*>("openSample");
  ASSERT_TRUE(button && button->isVisible());
  EXPECT_TRUE(strip->rect().contains(button->geometry()));
  EXPECT_FALSE(strip->figure()->xAxis->realVisibility());
  EXPECT_TRUE(wordsIn(*strip->figure()).contains("add one above"));
  button->hide();  // the words alone
  EXPECT_GT(tests::inkShare(strip->figure()->grab().toImage()), 0.001);
  button->show();
  tests::click(*button);
  ASSERT_TRUE(tests::passes([&] { return strip->figure()->graph(0)->dataCount() > 100; }, tests::patience));
  EXPECT_EQ(form->findChild<QListWidget*>()->count(), 1);
  EXPECT_EQ(form->findChild<QDoubleSpinBox*>("recordSpeed")->value(), 30);
  EXPECT_FALSE(button->isVisible());
  EXPECT_TRUE(strip->figure()->xAxis->realVisibility());
  EXPECT_EQ(wordsIn(*strip->figure()), "");
  EXPECT_TRUE(strip->figure()->yAxis->label().contains("[m/s²]")) << strip->figure()->yAxis->label().toStdString();
  ASSERT_TRUE(tests::passes([&] { return !form->records()->isReading(); }, tests::patience));
  EXPECT_NEAR(strip->figure()->xAxis->range().size(), 300, 1);
}

TEST(EmptyStates, aCalibrationSaysThatItNeedsATarget) {
  QSettings().remove("tools");
  MainWindow window(tests::services());
  ToolWindow* tool = window.tool("calibration");
  const auto* text = tool->findChild<QPlainTextEdit*>("toolText");
  EXPECT_TRUE(text->placeholderText().contains("Add a target")) << text->placeholderText().toStdString();
  EXPECT_TRUE(text->placeholderText().contains("Press Start"));
  tool->findChild<TargetList*>()->addFile("paper");
  EXPECT_FALSE(text->placeholderText().contains("Add a target")) << text->placeholderText().toStdString();
  EXPECT_TRUE(text->placeholderText().contains("Press Start"));
}

}  // namespace
}  // namespace squat::studio
