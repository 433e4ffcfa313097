// A project of 200 real runs on `draft`: how soon it can be worked with, how it scrolls, what memory it takes. Slow:
// the run is computed first. Ask for it on a machine that does nothing else.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/Monitor.h"
#include "gui/LinkedProject.h"
#include "gui/MadeUpRun.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"
#include "studio/project/RunReader.h"

namespace squat::studio {
namespace {

constexpr int count = 200;

// [MB] of this process, "VmRSS" or "VmHWM".
double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(name + ":", 0) == 0) return std::stod(line.substr(name.size() + 1)) * 1e-3;
  return 0;
}

class LargeProject : public testing::Test {
 protected:
  // Returns the project's path.
  QString make() {
    MainWindow window(tests::services());
    window.openCase("light-defect");
    window.document().setParameter("mesh.preset", "draft");
    Monitor silent;
    auto result = simulation::runCase(window.document().description(), {}, silent);
    result.stem = "light-defect";
    results::writeResult(file(), result);
    return QString::fromStdString(tests::writeLinkedProject(folder_.path().toStdString(), count));
  }
  std::string file() const { return tests::runFile(folder_.path().toStdString(), 0); }
  QTemporaryDir folder_;
};

// The promise: 2 s until the current run is seen, below 1 GB with all of them, 60 frames a second in the table.
TEST_F(LargeProject, opensAtOnceScrollsSmoothlyAndStaysBelowAGigabyte) {
  const QString project = make();
  MainWindow window(tests::services(20, Answer::discard));
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const double before = memory("VmRSS");
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(window.openProject(project));
  ASSERT_TRUE(tests::passes([&] { return window.store().current() == count - 1; }, 60000));
  const double seen = 1e-3 * static_cast<double>(clock.elapsed());
  ASSERT_TRUE(window.reader()->waitFor(600000));
  const double all = 1e-3 * static_cast<double>(clock.elapsed());
  for (int row = 0; row < count; ++row) ASSERT_FALSE(window.store().at(row).isMissing()) << row;
  window.showTab("runs");
  auto* table = window.findChild<QTableView*>("runs");
  ASSERT_NE(table, nullptr);
  QScrollBar& bar = *table->verticalScrollBar();
  ASSERT_GT(bar.maximum(), 50);
  QElapsedTimer frames;
  frames.start();
  for (int value = 0; value <= bar.maximum(); ++value) {
    bar.setValue(value);
    table->viewport()->repaint();
  }
  const double frame = static_cast<double>(frames.elapsed()) / (bar.maximum() + 1);
  // Looking at runs one after the other fetches their fields; the last four are kept.
  for (int row = 0; row < 20; ++row) {
    window.store().setCurrent(row);
    ASSERT_TRUE(tests::passes([&] { return window.store().at(row).fields == Fields::both; }, 20000)) << row;
  }
  const double size = 1e-6 * static_cast<double>(std::filesystem::file_size(file()));
  std::printf(
      "seen after %.2f s, all read after %.1f s, %.1f ms a frame, memory %.0f MB before, %.0f MB after, at most "
      "%.0f MB; a result file has %.1f MB\n",
      seen, all, frame, before, memory("VmRSS"), memory("VmHWM"), size);
  EXPECT_LT(seen, 2);
  EXPECT_LT(frame, 1000.0 / 60);
  EXPECT_LT(memory("VmHWM"), 1000);
}

}  // namespace
}  // namespace squat::studio
