// Runs and measured signals side by side: the window around analysis/ComparisonTable.h.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "analysis/ComparisonTable.h"
#include "analysis/FileComparison.h"
#include "case/ParameterValue.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "readers/SignalFile.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/runs/RunTable.h"
#include "studio/runs/RunsPanel.h"
#include "text/Numbers.h"

namespace squat::studio {
namespace {

// The made-up result as that of the default case of this depth [mm], `factor` times as strong.
ResultPointer runAtDepth(const char* depth, double factor) {
  auto result = std::make_shared<results::RunResult>(tests::syntheticResult());
  cases::CaseDescription description = cases::defaultCase();
  cases::setValue(description, "defect.depth", depth);
  results::setCase(*result, description);
  result->stem = "dip";
  for (const char* name : {"aba", "aba_filtered"})
    for (double& value : result->channel(name)->values) value *= factor;
  return result;
}

// 30 m of rest before and behind one strike that rings at 300 Hz, at 30 m/s: far more than is drawn. No speed in it.
QByteArray longRecord() {
  QByteArray text = "time [s],aba [m/s2]\n";
  for (int i = 0; i < 20000; ++i) {
    const double t = i / 10000.0, since = t - 1;
    const double rest = 0.2 * std::sin(400 * t);
    const double value = since < 0 ? rest : rest + 80 * std::exp(-since / 0.01) * std::sin(2 * M_PI * 300 * since);
    text += QByteArray::number(t, 'g', 12) + ',' + QByteArray::number(value, 'g', 12) + '\n';
  }
  return text;
}

class ComparisonOfRuns : public testing::Test {
 protected:
  void SetUp() override {
    QFile file(folder_.filePath("measured.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(longRecord());
    file.close();
    for (const auto& result : {runAtDepth("0.15", 1), runAtDepth("0.3", 2)})
      window_.store().add({result, QString(), QString(), false, result, nullptr, false});
    ASSERT_TRUE(window_.openMeasured(file.fileName())) << "measured.csv";
    window_.show();
    window_.showTab("comparison");
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.comparison()));
    ASSERT_TRUE(waits());
  }
  bool waits() const {
    return tests::passes([&] { return !window_.comparison()->isBusy(); }, 60000);
  }
  const QAbstractItemModel& seen() const { return *window_.comparison()->table()->model(); }
  QStringList headings() const {
    QStringList texts;
    for (int at = 0; at < seen().columnCount(); ++at)
      texts << seen().headerData(at, Qt::Horizontal).toString().replace('\n', ' ');
    return texts;
  }
  QString cell(int row, const QString& heading) const {
    return seen().index(row, static_cast<int>(headings().indexOf(heading))).data().toString();
  }
  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
};

// What the commands print for the same files, with four digits.
TEST_F(ComparisonOfRuns, showsTheNumbersOfTheCommands) {
  EXPECT_EQ(headings(),
            (QStringList{"Signal", "Depth [mm]", "Peak [m/s²]", "Line 1 [Hz]", "Line 2 [Hz]", "Line 3 [Hz]",
                         "Wavelength by crossings [m]", "Power 130-320 Hz [(m/s²)²]", "Power 200-400 Hz [(m/s²)²]",
                         "Power 1000-1200 Hz [(m/s²)²]", "Peak ratio", "Correlation"}));
  EXPECT_EQ(cell(0, "Depth [mm]"), "0.15");
  EXPECT_EQ(cell(2, "Depth [mm]"), "-");
  const std::string result = folder_.filePath("dip.h5").toStdString();
  const std::string measured = folder_.filePath("measured.csv").toStdString();
  results::writeResult(result, *window_.store().at(1).result);
  analysis::FileComparisonOptions options;
  options.second.speed = 30;  // squat compare dip.h5 measured.csv --speed 30
  Monitor monitor;
  const auto pair = analysis::compareFiles(result, {measured}, options, monitor).at(0).comparison;
  const auto printed = [](double value) { return QString::fromStdString(text::roundedText(value)); };
  EXPECT_EQ(cell(1, "Peak [m/s²]"), printed(pair.firstFeatures.peak));
  EXPECT_EQ(cell(1, "Power 200-400 Hz [(m/s²)²]"), printed(pair.firstFeatures.bands[1].power));
  EXPECT_EQ(cell(1, "Correlation"), printed(pair.correlation));
  EXPECT_EQ(cell(1, "Peak ratio"), printed(pair.peakRatio));
  // The measured signal's own, whole: squat analyse measured.csv --speed 30.
  readers::SignalFileOptions reading;
  reading.speed = 30;
  for (const auto& [name, value] : analysis::signalNumbers(readers::readSignals(measured, reading).at(0)))
    if (name == "peak [m/s2]" || name == "wavelength by crossings [m]") {
      const QString heading = name == "peak [m/s2]" ? "Peak [m/s²]" : "Wavelength by crossings [m]";
      EXPECT_EQ(cell(2, heading), printed(value)) << name;
    }
}

TEST_F(ComparisonOfRuns, comparesWithTheReferenceThatIsChosen) {
  auto* reference = window_.comparison()->findChild<QComboBox*>("reference");
  EXPECT_EQ(reference->currentText(), "measured");  // a measured signal is what computed ones are judged by
  EXPECT_EQ(cell(2, "Correlation"), "1");
  QMenu menu;
  window_.comparison()->fillMenu(menu, 0);
  menu.findChild<QAction*>("useAsReference")->trigger();
  EXPECT_EQ(window_.store().reference(), 0);
  EXPECT_EQ(reference->currentText(), "depth 0.15");
  ASSERT_TRUE(waits());
  // Of the same signal, twice as strong; shifted by up to a fortieth of a sample, which costs some of the peak.
  EXPECT_NEAR(cell(1, "Peak ratio").toDouble(), 2, 0.01);
  EXPECT_NEAR(cell(1, "Correlation").toDouble(), 1, 1e-3);
  QTest::keyClick(reference, Qt::Key_Down);  // by keyboard
  EXPECT_EQ(window_.store().reference(), 1);
  window_.store().remove(1);
  EXPECT_EQ(reference->currentText(), "measured");
}

TEST_F(ComparisonOfRuns, isCopiedAndExportedAsItIsSorted) {
  const int peak = static_cast<int>(headings().indexOf("Peak [m/s²]"));
  window_.comparison()->table()->sortByColumn(peak, Qt::DescendingOrder);
  QStringList order;
  for (int row = 0; row < 3; ++row) order << cell(row, "Signal");
  EXPECT_LT(order.indexOf("depth 0.3"), order.indexOf("depth 0.15"));
  tests::press(*window_.comparison(), Qt::Key_C, Qt::ControlModifier);
  const QStringList lines = QApplication::clipboard()->text().split('\n');
  ASSERT_EQ(lines.size(), 5);  // the heading, three signals, the end
  EXPECT_TRUE(lines[0].startsWith("signal\tdepth [mm]\tpeak [m/s²]\t")) << lines[0].toStdString();
  for (int row = 0; row < 3; ++row) EXPECT_EQ(lines[row + 1].section('\t', 0, 0), order[row]);
  EXPECT_EQ(lines[1].section('\t', 2, 2), cell(0, "Peak [m/s²]"));
  const QString path = folder_.filePath("table.csv");
  {
    tests::FileDialogTyping typing(path);
    tests::click(*window_.comparison()->findChild<QPushButton*>("Export CSV…"));
    ASSERT_TRUE(typing.done());
  }
  QFile written(path);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const auto rows = written.readAll().split('\n');
  EXPECT_EQ(QString::fromUtf8(rows[1]).section(',', 0, 0), order[0]);
  // Every digit of what is shown with four.
  EXPECT_EQ(text::roundedText(rows[1].split(',')[2].toDouble()), cell(0, "Peak [m/s²]").toStdString());
}

TEST_F(ComparisonOfRuns, aFileThatIsGoneCostsItsRowAlone) {
  window_.store().remove(2);
  ASSERT_TRUE(window_.openMeasured(folder_.filePath("measured.csv")));
  ASSERT_TRUE(QFile::remove(folder_.filePath("measured.csv")));  // before anybody has looked
  ASSERT_TRUE(waits());
  EXPECT_EQ(cell(2, "Peak [m/s²]"), "-");
  EXPECT_TRUE(seen().index(2, 0).data(Qt::ToolTipRole).toString().contains("measured.csv"));
  EXPECT_NE(cell(0, "Peak [m/s²]"), "-");
}

// A selected row is blue, and so is the curve of the current run.
TEST_F(ComparisonOfRuns, theColourOfASelectedRunIsSeen) {
  auto* panel = window_.findChild<RunsPanel*>();
  QTableView* table = panel->table();
  table->selectRow(1);
  ASSERT_EQ(window_.store().current(), 1);
  const QImage picture = table->viewport()->grab().toImage();
  const QRect row = table->visualRect(panel->indexOf(1));
  const QColor curve = curveColour(window_.store().at(1), true), ground = table->palette().color(QPalette::Base);
  int framed = 0;
  for (int x = row.left() + 1; x < row.right(); ++x)
    if (picture.pixelColor(x, row.center().y()) == curve && picture.pixelColor(x - 1, row.center().y()) == ground)
      ++framed;
  EXPECT_GE(framed, 1);
}

}  // namespace
}  // namespace squat::studio
