// Signals of the current run, with others overlaid.
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "render/SyntheticResult.h"
#include "studio/CursorPair.h"
#include "studio/FigureView.h"
#include "studio/RunStore.h"
#include "studio/SignalSettings.h"
#include "studio/SignalsPanel.h"
#include "studio/Theme.h"

namespace squat::studio {
namespace {

ResultPointer synthetic() { return std::make_shared<const results::RunResult>(tests::syntheticResult()); }

TEST(Signals, aLowerCutoffTakesTheHighLineAway) {
  std::string problem;
  SignalSettings settings;
  const auto wide = analysed(*synthetic(), settings, problem);
  ASSERT_TRUE(problem.empty()) << problem;
  settings.cutoff = 500;
  const auto narrow = analysed(*synthetic(), settings, problem);
  const auto powerNear = [](const results::RunResult& result, double frequency) {
    double power = 0;
    for (std::size_t i = 0; i < result.frequency.size(); ++i)
      if (std::abs(result.frequency[i] - frequency) < 60) power += result.psd[i];
    return power;
  };
  // Order 4 forward and back: an octave above the cut-off the power falls by 2^-16; 0.01 leaves room for leakage.
  EXPECT_LT(powerNear(*narrow, 1000), 0.01 * powerNear(*wide, 1000));
  EXPECT_GT(powerNear(*narrow, 300), 0.5 * powerNear(*wide, 300));
}

TEST(Signals, whatCannotBeDoneIsSaidAndTheOldStays) {
  std::string problem;
  SignalSettings settings;
  settings.cutoff = 13000;  // above half of 25 kHz
  const auto result = synthetic();
  const auto same = analysed(*result, settings, problem);
  EXPECT_FALSE(problem.empty());
  EXPECT_EQ(same->psd, result->psd);
}

TEST(Signals, overlaidRunsAreDrawnWithTheCurrentOne) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({synthetic(), "first", {}, false, false});
  store.add({synthetic(), "second", {}, false, false});
  const int alone = panel.view("aba")->figure()->graphCount();
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(panel.view("aba")->figure()->graphCount(), alone + 1);
}

TEST(Signals, viewsAgainstPositionAreLinked) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({synthetic(), "run", {}, false, false});
  panel.showTab("contact_force");
  panel.showTab("aba");
  panel.view("aba")->figure()->xAxis->setRange(-20, 60);
  EXPECT_DOUBLE_EQ(panel.view("contact_force")->figure()->xAxis->range().upper, 60);
}

TEST(Signals, cursorsGiveDifferencesAndFrequency) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({synthetic(), "run", {}, false, false});
  CursorPair* cursors = panel.view("aba")->cursors();
  cursors->setVisible(true);
  cursors->setPlaces(10, 40);  // mm at 30 m/s: 1 ms
  EXPECT_TRUE(cursors->text().contains("30.00 mm")) << cursors->text().toStdString();
  EXPECT_TRUE(cursors->text().contains("1000.0 Hz")) << cursors->text().toStdString();
}

TEST(Signals, everythingIsExportedInEveryFormat) {
  const QTemporaryDir folder;
  RunStore store;
  SignalsPanel panel(store, figureStyle(true));
  panel.resize(600, 400);
  store.add({synthetic(), "run", {}, false, false});
  const QStringList files = panel.exportAll(folder.path());
  EXPECT_EQ(files.size(), 7 * 4);
  for (const QString& path : files)
    EXPECT_GT(QFileInfo(path).size(), path.endsWith(".csv") ? 20 : 2000) << path.toStdString();
}

TEST(RunStore, removingKeepsACurrentRun) {
  RunStore store;
  for (const char* label : {"a", "b", "c"}) store.add({synthetic(), label, {}, false, false});
  EXPECT_EQ(store.current(), 2);
  store.remove(2);
  EXPECT_EQ(store.current(), 1);
  store.remove(0);
  EXPECT_EQ(store.at(store.current()).label, "b");
  store.remove(0);
  EXPECT_EQ(store.current(), -1);
  EXPECT_FALSE(store.currentResult());
}

}  // namespace
}  // namespace squat::studio
