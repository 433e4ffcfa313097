// Signals of the current run, with others overlaid.
#include <gtest/gtest.h>

#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/SignalViews.h"
#include "gui/Hands.h"
#include "plots/FigureRegistry.h"
#include "render/SyntheticResult.h"
#include "studio/common/Theme.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/CursorPair.h"
#include "studio/signals/FigureTable.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

// The low-pass has nothing to do with the stretch of the spectrum.
TEST(Signals, aWrongStretchCostsTheSpectrumAlone) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.findChild<QDoubleSpinBox*>("psdFrom")->setValue(800);  // to 280
  const auto* problem = panel.findChild<QLabel*>("signalProblem");
  EXPECT_TRUE(problem->text().contains("Spectrum not updated")) << problem->text().toStdString();
  EXPECT_TRUE(problem->text().contains("800 mm")) << problem->text().toStdString();
  const auto curve = [&] { return *panel.view("aba_position")->figure()->graph(0)->data(); };
  const auto largest = [&] {
    double value = 0;
    for (const QCPGraphData& point : curve()) value = std::max(value, std::abs(point.value));
    return value;
  };
  panel.showTab("aba_position");
  const double before = largest();
  panel.findChild<QDoubleSpinBox*>("cutoff")->setValue(100);  // below both lines of the made-up run
  EXPECT_LT(largest(), 0.5 * before);
  panel.findChild<QDoubleSpinBox*>("psdFrom")->setValue(-100);
  EXPECT_TRUE(problem->text().isEmpty()) << problem->text().toStdString();
}

// Points above half the maximum around it.
int widthOfTallestLine(const QCPGraph& graph) {
  const auto& points = *graph.data();
  const auto top = std::max_element(points.constBegin(), points.constEnd(),
                                    [](const auto& a, const auto& b) { return a.value < b.value; });
  auto from = top, to = top;
  while (from != points.constBegin() && from->value > 0.5 * top->value) --from;
  while (to != points.constEnd() && to->value > 0.5 * top->value) ++to;
  return static_cast<int>(to - from);
}

TEST(Signals, theStretchOfTheSpectrumIsItsOwn) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  const QStringList alongTrack{"aba_position", "contact_force", "stft", "scalogram"};
  std::vector<QCPRange> before;
  for (const auto& name : alongTrack) {
    panel.showTab(name);
    before.push_back(panel.view(name)->figure()->xAxis->range());
  }
  panel.showTab("psd");
  const int wide = widthOfTallestLine(*panel.view("psd")->figure()->graph(0));
  panel.findChild<QDoubleSpinBox*>("psdTo")->setValue(50);
  // A shorter stretch resolves less: Hann's main lobe is four steps of 1/T wide, on the same axis of frequencies.
  EXPECT_GT(widthOfTallestLine(*panel.view("psd")->figure()->graph(0)), wide);
  for (int i = 0; i < alongTrack.size(); ++i) {
    panel.showTab(alongTrack[i]);
    panel.view(alongTrack[i])->resetZoom();
    const QCPRange after = panel.view(alongTrack[i])->figure()->xAxis->range();
    EXPECT_DOUBLE_EQ(after.lower, before[static_cast<std::size_t>(i)].lower) << alongTrack[i].toStdString();
    EXPECT_DOUBLE_EQ(after.upper, before[static_cast<std::size_t>(i)].upper) << alongTrack[i].toStdString();
  }
}

TEST(Signals, overlaidRunsAreDrawnWithTheCurrentOne) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "first", {}, false});
  store.add({tests::sharedSyntheticResult(), "second", {}, false});
  const int alone = panel.view("aba_position")->figure()->graphCount();
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(panel.view("aba_position")->figure()->graphCount(), alone + 1);
}

// A run with ten times the signal, laid over: nothing of it runs out of the axes.
TEST(Signals, axesHaveRoomForOverlaidRuns) {
  auto larger = tests::syntheticResult();
  for (auto& channel : larger.signals)
    for (double& value : channel.values) value *= 10;
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({std::make_shared<const results::RunResult>(larger), "larger", {}, true});
  store.add({tests::sharedSyntheticResult(), "shown", {}, false});
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  for (const char* name : {"aba_position", "psd", "contact_force"}) {
    panel.showTab(name);
    const auto* figure = panel.view(name)->figure();
    const QCPRange x = figure->xAxis->range(), y = figure->yAxis->range();
    for (int i = 0; i < figure->graphCount(); ++i)
      for (const QCPGraphData& point : *figure->graph(i)->data())
        if (x.contains(point.key)) {
          ASSERT_TRUE(y.contains(point.value)) << name << " at " << point.key;
        }
  }
}

TEST(Signals, whatCannotBeDrawnCostsItsFigureAlone) {
  auto broken = tests::syntheticResult();
  for (auto& channel : broken.signals)
    if (channel.name == "aba" || channel.name == "aba_filtered") channel.values[channel.values.size() / 2] = NAN;
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({std::make_shared<const results::RunResult>(broken), "broken", {}, false});
  for (const auto& name : panel.names()) {
    panel.showTab(name);
    EXPECT_TRUE(panel.view(name)->figure()) << name.toStdString();
  }
}

TEST(Signals, viewsAgainstPositionAreLinked) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("contact_force");
  panel.showTab("aba_position");
  panel.view("aba_position")->figure()->xAxis->setRange(-20, 60);
  EXPECT_DOUBLE_EQ(panel.view("contact_force")->figure()->xAxis->range().upper, 60);
}

TEST(Signals, cursorsGiveDifferencesAndFrequency) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  CursorPair* cursors = panel.view("aba_position")->cursors();
  cursors->setVisible(true);
  cursors->setLocations(10, 40);  // mm at 30 m/s: 1 ms
  EXPECT_TRUE(cursors->text().contains("30.00 mm")) << cursors->text().toStdString();
  EXPECT_TRUE(cursors->text().contains("1000.0 Hz")) << cursors->text().toStdString();
}

TEST(Signals, everythingIsExportedInEveryFormat) {
  const QTemporaryDir folder;
  RunStore store;
  SignalsPanel panel(store, figureStyle(true));
  panel.resize(600, 400);
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  const QStringList files = panel.exportAll(folder.path());
  // Each figure that the run has something for; the 3-D picture is a PNG.
  const auto fits =
      std::count_if(plots::figureRegistry().begin(), plots::figureRegistry().end(),
                    [run = tests::sharedSyntheticResult()](const auto& row) { return row.applies(*run); });
  EXPECT_EQ(files.size(), (fits - 1) * 4 + 1);
  for (const QString& path : files)
    EXPECT_GT(QFileInfo(path).size(), path.endsWith(".csv") ? 20 : 2000) << path.toStdString();
}

// A measured aba_position.csv may lie in the folder that is chosen.
TEST(Signals, exportAsksBeforeItReplacesFiles) {
  const QTemporaryDir folder;
  QFile measured(folder.filePath("aba_position.csv"));
  ASSERT_TRUE(measured.open(QIODevice::WriteOnly));
  measured.write("measured");
  measured.close();
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  panel.show();
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  tests::FileDialogTyping typing(folder.path());
  tests::BoxAnswer answer("Cancel");
  panel.askForFolder();
  EXPECT_TRUE(typing.done());
  EXPECT_TRUE(answer.done());
  EXPECT_EQ(QFileInfo(measured).size(), 8);
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

// As `sharedSyntheticResult()`, begun some time earlier: the same passage at another time.
ResultPointer earlier(double seconds) {
  auto moved = std::make_shared<results::RunResult>(tests::syntheticResult());
  for (double& time : moved->time) time += seconds;
  return moved;
}

TEST(Signals, zoomIsLinkedThroughTheSpeed) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  for (const char* name : {"scalogram", "stft", "aba_position"}) panel.showTab(name);
  panel.view("aba_position")->figure()->xAxis->setRange(-30, 30);
  EXPECT_DOUBLE_EQ(panel.view("scalogram")->figure()->xAxis->range().upper, 30);
  EXPECT_DOUBLE_EQ(panel.view("stft")->figure()->xAxis->range().lower, -30);
  panel.showTab("aba_time");  // 60 mm at 30 m/s are 2 ms
  const auto run = tests::sharedSyntheticResult();
  const QCPRange seen = panel.view("aba_time")->figure()->xAxis->range();
  EXPECT_NEAR(seen.size(), 2.0, 1e-9);
  EXPECT_NEAR(seen.center(), 1e3 * (run->time.front() - run->position.front() / run->speed), 1e-9);
}

// A shorter record after a long one that the user has zoomed in and out of.
TEST(Signals, aNewRunIsShownOverItsOwnRange) {
  auto shorter = tests::syntheticResult();
  shorter.psdFrom = -0.05, shorter.psdTo = 0.09;
  const auto next = std::make_shared<const results::RunResult>(shorter);
  const QStringList alongTrack{"stft", "scalogram", "contact_force", "aba_position"};
  RunStore store, freshStore;
  SignalsPanel panel(store, figureStyle(false)), fresh(freshStore, figureStyle(false));
  freshStore.add({next, "short", {}, false});
  store.add({tests::sharedSyntheticResult(), "long", {}, false});
  for (const auto& name : alongTrack) panel.showTab(name);
  panel.view("aba_position")->figure()->xAxis->setRange(-30, 30);
  panel.view("aba_position")->resetZoom();
  store.add({next, "short", {}, false});
  for (const auto& name : alongTrack) {
    panel.showTab(name), fresh.showTab(name);
    const QCPRange seen = panel.view(name)->figure()->xAxis->range(), own = fresh.view(name)->figure()->xAxis->range();
    EXPECT_DOUBLE_EQ(seen.lower, own.lower) << name.toStdString();
    EXPECT_DOUBLE_EQ(seen.upper, own.upper) << name.toStdString();
  }
}

// Names that a script can read: no legend texts with extremes, signs or blanks, none twice.
TEST(Signals, curvesInATableHaveShortNames) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "Site A, north #1", {}, false});
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  std::set<QByteArray> names;
  for (const QByteArray& line : figureTable(*panel.view("aba_position")->figure()).split('\n').mid(1))
    if (!line.isEmpty()) names.insert(line.left(line.indexOf(',')));
  EXPECT_TRUE(names.count("axle_box"));
  EXPECT_TRUE(names.count("site_a_north_1"));
  for (const QByteArray& name : names)
    EXPECT_TRUE(QRegularExpression("^[a-z][a-z0-9_]*$").match(QString::fromUtf8(name)).hasMatch())
        << name.toStdString();
  panel.showTab("psd");
  EXPECT_TRUE(figureTable(*panel.view("psd")->figure()).startsWith("curve,frequency [Hz],psd [(m/s2)2/Hz]\n"));
}

TEST(Signals, overlaidRunsPassTheDefectAtTheSameMoment) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({earlier(0.5), "earlier", {}, false});
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("aba_time");
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  const auto* figure = panel.view("aba_time")->figure();
  const auto* own = figure->graph(0);
  const auto* other = figure->graph(figure->graphCount() - 1);
  ASSERT_EQ(own->dataCount(), other->dataCount());
  for (const int i : {0, own->dataCount() / 2, own->dataCount() - 1})
    EXPECT_NEAR(own->data()->at(i)->key, other->data()->at(i)->key, 1e-9);  // ms
}

TEST(Signals, theScalogramFollowsTheCutoff) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("scalogram");
  // Largest power between 800 and 1200 Hz, where the made-up run has a line.
  const auto highLine = [&] {
    plots::Figure* figure = panel.view("scalogram")->figure();
    double largest = 0;
    for (int i = 0; i < figure->plottableCount(); ++i)
      if (const auto* map = qobject_cast<const QCPColorMap*>(figure->plottable(i)))
        for (int row = 0; row < map->data()->valueSize(); ++row)
          for (int column = 0; column < map->data()->keySize(); ++column) {
            const double frequency = cellLocation(*map, column, row).y();
            if (frequency > 800 && frequency < 1200) largest = std::max(largest, map->data()->cell(column, row));
          }
    return largest;
  };
  const double before = highLine();
  auto* cutoff = panel.findChild<QDoubleSpinBox*>("cutoff");
  cutoff->setValue(400);
  EXPECT_LT(highLine(), 0.05 * before);  // an octave above order 4 forward and back: 2^-16, room for the line at 300
}

TEST(Signals, theShortTimeTransformHasItsWindow) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("stft");
  panel.findChild<QSpinBox*>("stftSegment")->setValue(256);
  panel.findChild<QSpinBox*>("stftHop")->setValue(16);
  EXPECT_EQ(panel.settings().segment, 256u);
  EXPECT_EQ(panel.settings().hop, 16u);
}

int marksOn(const plots::Figure& figure) {
  int marks = 0;
  for (int i = 0; i < figure.itemCount(); ++i) marks += qobject_cast<QCPItemTracer*>(figure.item(i)) != nullptr;
  return marks;
}

TEST(Signals, peaksAreMarked) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  for (const auto& name : panel.names()) panel.showTab(name);
  EXPECT_EQ(marksOn(*panel.view("aba_position")->figure()), 2);
  EXPECT_EQ(marksOn(*panel.view("contact_force")->figure()), 2);
  for (const char* name : {"stft", "scalogram"}) {
    EXPECT_GE(marksOn(*panel.view(name)->figure()), 1) << name;
    EXPECT_LE(marksOn(*panel.view(name)->figure()), 3) << name;
  }
}

// Texts that are seen and do not lie wholly within the axes.
QStringList cutTexts(plots::Figure& figure) {
  figure.replot(QCustomPlot::rpImmediateRefresh);
  const QRectF room = QRectF(figure.axisRect()->rect()).adjusted(-1, -1, 1, 1);
  QStringList cut;
  for (int i = 0; i < figure.itemCount(); ++i) {
    const auto* text = qobject_cast<QCPItemText*>(figure.item(i));
    if (!text || !text->realVisibility()) continue;
    if (!room.contains(QRectF(text->topLeft->pixelPosition(), text->bottomRight->pixelPosition()))) cut << text->text();
  }
  return cut;
}

// A text that is cut off reads as another number. The impact stands where the text has the least room on either side.
TEST(Signals, textsAtMarksAreWhole) {
  for (const double shift : {-0.095, 0.02, 0.15, 0.17, 0.27}) {
    auto moved = tests::syntheticResult();
    for (double& position : moved.position) position += shift;
    RunStore store;
    SignalsPanel panel(store, figureStyle(false));
    panel.show();
    store.add({std::make_shared<const results::RunResult>(moved), "run", {}, false});
    for (const int width : {280, 320, 480})
      for (const char* name : {"aba_position", "contact_force", "scalogram"}) {
        panel.showTab(name);
        plots::Figure& figure = *panel.view(name)->figure();
        figure.setFixedSize(width, 260);
        const QStringList cut = cutTexts(figure);
        EXPECT_TRUE(cut.isEmpty()) << name << ' ' << width << ' ' << shift << ": " << cut.join("; ").toStdString();
      }
  }
}

TEST(Signals, namesOfPeaksAreWholeWithOverlaidRuns) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  panel.resize(480, 400);
  panel.show();
  for (const char* label : {"first", "second"}) store.add({tests::sharedSyntheticResult(), label, {}, false});
  store.setData(store.index(0), Qt::Checked, Qt::CheckStateRole);
  panel.showTab("psd");
  QTest::qWait(30);
  const QStringList cut = cutTexts(*panel.view("psd")->figure());
  EXPECT_TRUE(cut.isEmpty()) << cut.join("; ").toStdString();
}

// The made-up run rings at 300 Hz and 1000 Hz: a wavelet spreads a line over some percent.
TEST(Signals, markedLinesAreWhereTheLinesAre) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("scalogram");
  plots::Figure& figure = *panel.view("scalogram")->figure();
  double nearest = 1e9;
  for (int i = 0; i < figure.itemCount(); ++i)
    if (const auto* ring = qobject_cast<QCPItemTracer*>(figure.item(i)))
      nearest = std::min(nearest, std::abs(ring->position->value() / 300 - 1));
  EXPECT_LT(nearest, 0.2);
}

TEST(Signals, theTableOfAFigureHoldsWhatIsSeen) {
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  const ResultPointer run = tests::sharedSyntheticResult();
  store.add({run, "run", {}, false});
  for (const char* name : {"scalogram", "aba_position"}) panel.showTab(name);
  plots::Figure* figure = panel.view("aba_position")->figure();
  figure->xAxis->setRange(-10, 10);
  const auto lines = QString::fromUtf8(figureTable(*figure)).split('\n', Qt::SkipEmptyParts);
  const auto within = std::count_if(run->position.begin(), run->position.end(),
                                    [](double position) { return std::abs(position) <= 0.01; });
  EXPECT_NEAR(static_cast<double>(within), 20 / 1.2, 1);  // 20 mm, a sample every 1.2 mm
  EXPECT_EQ(lines.size(), 1 + within * figure->graphCount());
  // The rows of the first curve are the samples that were computed.
  const auto first = std::find_if(run->position.begin(), run->position.end(), [](double x) { return x >= -0.01; });
  const auto row = lines.value(1).split(',');
  ASSERT_EQ(row.size(), 3);
  EXPECT_NEAR(row[1].toDouble(), 1e3 * *first, 1e-9);
  std::string ignored;
  const ResultPointer filtered = analysis::resultThrough(panel.settings(), *run, ignored);
  EXPECT_NEAR(row[2].toDouble(),
              (*filtered->signal("aba_filtered"))[static_cast<std::size_t>(first - run->position.begin())], 1e-6);
  const QByteArray map = figureTable(*panel.view("scalogram")->figure());
  EXPECT_TRUE(map.startsWith("curve,position [mm],frequency [Hz],power [(m/s2)2 s]\n")) << map.left(80).toStdString();
  EXPECT_TRUE(lines[0] == "curve,position [mm],acceleration [m/s2]");
  EXPECT_GT(map.count("\nmap,"), 1000);
}

TEST(RunStore, removingKeepsACurrentRun) {
  RunStore store;
  for (const char* label : {"a", "b", "c"}) store.add({tests::sharedSyntheticResult(), label, {}, false});
  EXPECT_EQ(store.current(), 2);
  store.remove(2);
  EXPECT_EQ(store.current(), 1);
  store.remove(0);
  EXPECT_EQ(store.at(store.current()).label, "b");
  store.remove(0);
  EXPECT_EQ(store.current(), -1);
  EXPECT_FALSE(store.currentResult());
}

// A measured signal is laid over a run; it is never the run that is shown, saved and compared with.
TEST(RunStore, aMeasuredSignalIsNeverTheCurrentRun) {
  RunStore store;
  store.add({nullptr, "measured first", {}, true, tests::sharedSyntheticResult()});
  EXPECT_EQ(store.current(), -1);
  store.remove(0);
  store.add({tests::sharedSyntheticResult(), "one", {}, false});
  for (const char* label : {"measured", "measured too"})
    store.add({nullptr, label, {}, true, tests::sharedSyntheticResult()});
  store.add({tests::sharedSyntheticResult(), "two", {}, false});
  store.setCurrent(0);
  store.remove(0);
  ASSERT_GE(store.current(), 0);
  EXPECT_EQ(store.at(store.current()).label, "two");
  store.remove(store.current());
  EXPECT_EQ(store.current(), -1);
  EXPECT_EQ(store.rowCount(), 2);
  store.add({tests::sharedSyntheticResult(), "three", {}, false});
  store.add({tests::sharedSyntheticResult(), "four", {}, false});
  store.remove(3);
  EXPECT_EQ(store.at(store.current()).label, "three");  // the one before, where none comes after
}

}  // namespace
}  // namespace squat::studio
