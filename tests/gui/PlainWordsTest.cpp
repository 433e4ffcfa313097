// Words of the window that a newcomer can read: abbreviations explained, one name for one thing, entries where they are
// looked for.
#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>

#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "studio/common/Words.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/window/PaperPanel.h"

namespace squat::studio {
namespace {

QStringList entriesOf(const MainWindow& window, const QString& title) {
  QStringList texts;
  for (const QAction* menu : window.menuBar()->actions())
    if (menu->text().remove('&') == title)
      for (const QAction* action : menu->menu()->actions()) texts << action->text().remove('&');
  return texts;
}

TEST(PlainWords, theTabsOfTheMiddleSayWhatTheyHold) {
  MainWindow window(tests::services());
  const auto* paper = window.findChild<PaperPanel*>();
  ASSERT_NE(paper, nullptr);
  QString text;
  for (const auto* tabs : window.findChildren<QTabWidget*>())
    for (int i = 0; i < tabs->count(); ++i)
      if (tabs->widget(i) == paper) text = tabs->tabText(i);
  EXPECT_EQ(text, "Summary");
  EXPECT_TRUE(entriesOf(window, "View").contains("Show summary of the run"));
}

TEST(PlainWords, whatChangesTheViewAloneStandsUnderView) {
  MainWindow window(tests::services());
  EXPECT_TRUE(entriesOf(window, "View").contains("Fit profile to view"));
  EXPECT_FALSE(entriesOf(window, "Edit").contains("Fit profile to view"));
}

// The button says the first word of the menu's entry, and its tool tip the whole.
TEST(PlainWords, overlayingAMeasuredSignalHasOneName) {
  MainWindow window(tests::services());
  EXPECT_TRUE(entriesOf(window, "File").contains("Overlay measured signal…"));
  const auto* button = window.findChild<RunsPanel*>()->findChild<QPushButton*>("Overlay…");
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->toolTip(), "Overlay measured signal");
}

TEST(PlainWords, headingsOfRunsAreExplained) {
  RunStore store;
  const RunsPanel panel(store);
  const auto* model = panel.table()->model();
  ASSERT_GE(model->columnCount(), 5);  // name, peak, lines, mesh, time
  for (int i = 0; i < model->columnCount(); ++i)
    EXPECT_GT(model->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString().size(), 10) << i;
  EXPECT_TRUE(model->headerData(2, Qt::Horizontal, Qt::ToolTipRole).toString().contains("Frequencies"));
}

TEST(PlainWords, abbreviatedFiguresAreExplained) {
  RunStore store;
  SignalsPanel panel(store, plots::lightStyle());
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  const auto* tabs = panel.findChild<QTabWidget*>();
  for (const char* name : {"psd", "stft", "scalogram"}) {
    const int tab = static_cast<int>(SignalsPanel::names().indexOf(name));
    EXPECT_TRUE(tabs->tabToolTip(tab).contains("frequencies")) << tabs->tabToolTip(tab).toStdString();
  }
}

TEST(PlainWords, presetsAreCalledByWhatTheySet) {
  MainWindow window(tests::services());
  EXPECT_EQ(window.form()->row("mesh.preset")->label(), "Fineness");
  for (const char* key : {"wheelset.preset", "track.preset", "rail.preset"})
    EXPECT_EQ(window.form()->row(key)->label(), "Set of values") << key;
  EXPECT_EQ(parameterLabel("pad.stiffness"), "Stiffness");
}

}  // namespace
}  // namespace squat::studio
