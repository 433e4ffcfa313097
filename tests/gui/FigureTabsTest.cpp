// The tabs of the studio are the rows of the registry of figures.
#include <gtest/gtest.h>

#include <QTabWidget>
#include <QTemporaryDir>

#include "core/Errors.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "plots/FigureRegistry.h"
#include "render/SyntheticResult.h"
#include "studio/common/Theme.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalFigures.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/window/MainWindow.h"

namespace squat::studio {
namespace {

ResultPointer elastic() {
  auto result = tests::syntheticResult();
  result.permanent = {};
  return std::make_shared<const results::RunResult>(result);
}

TEST(FigureTabs, areTheRowsOfTheRegistry) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  const auto* tabs = panel.findChild<QTabWidget*>();
  QStringList headings, names, expectedHeadings, expectedNames;
  for (int i = 0; i < tabs->count(); ++i) headings << tabs->tabText(i);
  for (const auto& row : plots::figureRegistry()) {
    EXPECT_TRUE(MainWindow::tabNames().contains(QString::fromStdString(row.name))) << row.name;
    if (row.kind == plots::FigureKind::model) continue;
    expectedHeadings << QString::fromStdString(row.tab);
    expectedNames << QString::fromStdString(row.name);
  }
  EXPECT_EQ(headings, expectedHeadings);
  EXPECT_EQ(SignalsPanel::names(), expectedNames);
}

// Out of the way, and neither exported nor lost for the next run.
TEST(FigureTabs, whatTheRunHasNothingForIsHidden) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  const auto* tabs = panel.findChild<QTabWidget*>();
  const int stress = static_cast<int>(SignalsPanel::names().indexOf("residual_stress"));
  ASSERT_GE(stress, 0);
  store.add({elastic(), "elastic", {}, false});
  EXPECT_FALSE(tabs->isTabVisible(stress));
  for (const QString& path : panel.exportPaths("/anywhere")) EXPECT_FALSE(path.contains("residual_stress"));
  store.add({std::make_shared<const results::RunResult>(tests::syntheticResult()), "plastic", {}, false});
  EXPECT_TRUE(tabs->isTabVisible(stress));
  EXPECT_TRUE(panel.exportPaths("/anywhere").contains("/anywhere/residual_stress.csv"));
  EXPECT_TRUE(panel.exportPaths("/anywhere").contains("/anywhere/model.png"));
}

TEST(FigureTabs, anUnknownNameIsAnErrorAndNoOtherFigure) {
  const auto result = elastic();
  EXPECT_THROW(signalFigure("aba", *result, {}, {}, figureStyle(false)), CaseError);
  EXPECT_THROW(signalFigure("model", *result, {}, {}, figureStyle(false)), CaseError);
}

TEST(FigureTabs, everyRowIsDrawnInTheStudio) {
  const auto result = tests::syntheticResult();
  for (const auto& row : plots::figureRegistry()) {
    if (row.kind == plots::FigureKind::model) continue;
    EXPECT_EQ(signalFigure(row.name, result, {}, {}, figureStyle(false))->name().toStdString(), row.name);
  }
}

}  // namespace
}  // namespace squat::studio
