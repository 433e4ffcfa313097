// A whole working day by mouse and keys: open, edit, undo, redo, run, watch, cancel, run again, overlay a measured
// signal, export, save, reopen.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "case/CaseFile.h"
#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "results/SignalTable.h"
#include "studio/LivePlot.h"
#include "studio/MessageBar.h"
#include "studio/ProfileEditor.h"
#include "studio/ProfilePlot.h"
#include "studio/RunPanel.h"
#include "studio/SignalsPanel.h"

namespace squat::studio {
namespace {

TEST(WorkingDay, fromOpeningToReopening) {
  const QTemporaryDir folder;
  MainWindow window(tests::services(300));
  window.resize(1500, 920);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QApplication::setActiveWindow(&window);  // an X server without a window manager activates nothing by itself
  window.findChild<QAction*>("shipped light-defect")->trigger();
  ASSERT_EQ(window.document().name(), "light-defect");

  // Edit the profile: the deepest point a little deeper.
  ProfilePlot* plot = window.profile()->plot();
  plot->replot(QCustomPlot::rpImmediateRefresh);
  const auto& points = window.document().description().defect.points;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].height < points[deepest].height) deepest = i;
  const double before = points[deepest].height;
  const QPoint from = plot->placeOf(deepest).toPoint();
  QTest::mousePress(plot, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 4; ++i) QTest::mouseMove(plot, from + QPoint(0, 3 * i));
  QTest::mouseRelease(plot, Qt::LeftButton, {}, from + QPoint(0, 12));
  const double deeper = window.document().description().defect.points[deepest].height;
  EXPECT_LT(deeper, before);
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window.document().description().defect.points[deepest].height, before);
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window.document().description().defect.points[deepest].height, deeper);

  // Run, watch, cancel, run again.
  auto* run = window.findChild<QPushButton*>("run");
  auto* cancel = window.findChild<QPushButton*>("cancel");
  auto* panel = window.findChild<RunPanel*>();
  ASSERT_TRUE(run->isEnabled()) << run->toolTip().toStdString();
  QTest::mouseClick(run, Qt::LeftButton);
  ASSERT_TRUE(tests::passes([&] { return panel->live()->sampleCount() > 5; }));
  EXPECT_FALSE(run->isEnabled());
  QTest::mouseClick(cancel, Qt::LeftButton);
  ASSERT_TRUE(tests::passes([&] { return !window.controller().isRunning(); }));
  ASSERT_EQ(window.store().rowCount(), 1);
  EXPECT_FALSE(window.store().currentResult()->complete);
  QTest::keyClick(&window, Qt::Key_F5);
  ASSERT_TRUE(tests::passes([&] { return window.store().rowCount() == 2; }, 20000));
  EXPECT_TRUE(window.store().currentResult()->complete);

  // A measured signal over it.
  results::writeSignalTable(folder.filePath("measured.csv").toStdString(), tests::syntheticResult());
  ASSERT_TRUE(window.openMeasured(folder.filePath("measured.csv"))) << window.messages()->text().toStdString();
  EXPECT_EQ(window.store().overlays().size(), 1u);
  // The same signal: its impact lies where the run's does.
  const auto& measured = *window.store().overlays()[0].result;
  EXPECT_NEAR(measured.position.front(), tests::syntheticResult().position.front(), 2e-3);  // a sample is 1.2 mm

  EXPECT_EQ(window.signalsPanel()->exportAll(folder.path()).size(), 28);
  ASSERT_TRUE(window.saveCaseTo(folder.filePath("day.toml")));
  const cases::CaseDescription saved = window.document().description();
  ASSERT_TRUE(window.close());

  MainWindow tomorrow(tests::services());
  ASSERT_TRUE(tomorrow.openAny(folder.filePath("day.toml")));
  EXPECT_TRUE(sameCase(tomorrow.document().description(), saved));
}

}  // namespace
}  // namespace squat::studio
