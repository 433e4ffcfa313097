// The figures of the signal analysis as files, with no display: every format, text that is text, nothing cut, and
// beside their baselines in tests/render/baselines (see BaselineTest.cpp for how to renew one).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "plots/ComparisonFigures.h"
#include "plots/FigureBuilders.h"
#include "plots/FigureFiles.h"
#include "plots/PaperFigures.h"
#include "plots/StudyFigures.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "render/SyntheticSheets.h"
#include "render/WithoutDisplay.h"

namespace squat {
namespace {

using testing::Contains;

class FigureSheets : public tests::WithoutDisplay {
 protected:
  static void SetUpTestSuite() {
    WithoutDisplay::SetUpTestSuite();
    everySheet = new std::vector<plots::FigureSheet>(tests::syntheticSheets());
  }
  static void TearDownTestSuite() { delete everySheet; }
  static void expectEmptyBorder(const QImage& image, const std::string& name) {
    const QRgb background = image.pixel(0, 0);
    for (int x = 0; x < image.width(); ++x) {
      ASSERT_EQ(image.pixel(x, 0), background) << name << " top, column " << x;
      ASSERT_EQ(image.pixel(x, image.height() - 1), background) << name << " bottom, column " << x;
    }
    for (int y = 0; y < image.height(); ++y) {
      ASSERT_EQ(image.pixel(0, y), background) << name << " left, line " << y;
      ASSERT_EQ(image.pixel(image.width() - 1, y), background) << name << " right, line " << y;
    }
  }
  static inline std::vector<plots::FigureSheet>* everySheet = nullptr;
};

TEST_F(FigureSheets, allKindsAreThere) {
  std::vector<std::string> names;
  for (const auto& sheet : *everySheet) names.push_back(sheet.name);
  EXPECT_THAT(names,
              testing::ElementsAre("run_1_history", "run_1_psd", "run_1_stft", "run_1_scalogram", "run_2_history",
                                   "run_2_psd", "run_2_stft", "run_2_scalogram", "scatter_time", "scatter_position",
                                   "measured_comparison", "measured_comparison_scalograms", "measured_comparison_stft",
                                   "smooth_comparison", "smooth_comparison_scalograms", "smooth_comparison_stft",
                                   "study_defect_length", "study_defect_depth", "paper_figure_04", "paper_figure_05",
                                   "paper_figure_06", "paper_figure_08", "paper_figure_09", "paper_figure_10",
                                   "paper_figure_11", "track_receptance", "estimate"));
}

TEST_F(FigureSheets, eachInEveryFormatWithTextAsText) {
  const std::string folder = tests::freshFolder("sheets");
  for (const auto& sheet : *everySheet) {
    const auto paths = plots::writeSheet(sheet, folder, {});
    ASSERT_EQ(paths.size(), 3u) << sheet.name;
    for (const auto& path : paths) EXPECT_GT(std::filesystem::file_size(path), 5000u) << path;
    EXPECT_GT(tests::inkShare(QImage(QString::fromStdString(paths[0]))), 0.03) << paths[0] << " is nearly empty";
    const auto texts = textsOf(contents(paths[1]));
    for (const auto& panel : sheet.panels)
      for (const QCPAxis* axis : {panel->xAxis, panel->yAxis})
        EXPECT_THAT(texts, Contains(axis->label().toStdString())) << paths[1];
    const QByteArray pdf = contents(paths[2]);
    EXPECT_TRUE(pdf.startsWith("%PDF-")) << paths[2];
    EXPECT_TRUE(pdf.contains("/FontFile2")) << paths[2];
  }
}

TEST_F(FigureSheets, everyAxisHasALabelAndSquaresAreRaised) {
  for (const auto& sheet : *everySheet)
    for (const auto& panel : sheet.panels)
      for (const QCPAxis* axis : {panel->xAxis, panel->yAxis}) {
        EXPECT_FALSE(axis->label().isEmpty()) << sheet.name << " " << panel->name().toStdString();
        EXPECT_FALSE(axis->label().contains("s2") || axis->label().contains(")2")) << axis->label().toStdString();
      }
}

// Nothing lies between two names; a feature without any value says so.
TEST_F(FigureSheets, namesAreNotJoinedByLines) {
  auto table = studies::emptyTable({"c", "12345678", {studies::variationFromText("defect.lateral=uniform,parabolic")}});
  for (auto& row : table.rows) {
    row.state = studies::RowState::done;
    row.features = {{"peak [m/s2]", 1.0 + static_cast<double>(row.point.index)},
                    {"free vibration 1000-1200 Hz [s]", std::nan("")}};
  }
  const auto sheets = plots::studyFigures(table, plots::lightStyle());
  ASSERT_EQ(sheets.at(0).panels.size(), 2u);
  EXPECT_EQ(sheets[0].panels[0]->graph(0)->lineStyle(), QCPGraph::lsNone);
  ASSERT_EQ(sheets[0].panels[1]->itemCount(), 1);
  EXPECT_EQ(qobject_cast<QCPItemText*>(sheets[0].panels[1]->item(0))->text(), "longer than the record");
  table = studies::emptyTable({"c", "12345678", {studies::variationFromText("defect.depth=0.1,0.2")}});
  for (auto& row : table.rows) row.state = studies::RowState::done, row.features = {{"peak [m/s2]", 1.0}};
  EXPECT_EQ(plots::studyFigures(table, plots::lightStyle()).at(0).panels[0]->graph(0)->lineStyle(), QCPGraph::lsLine);
}

// Measured signals may be anything; what nobody named a unit for says so.
TEST_F(FigureSheets, mapsTellTheUnitOfTheirSignal) {
  auto result = tests::syntheticResult();
  const auto scaleOf = [](const plots::Figure& figure) {
    for (auto* element : figure.findChildren<QCPColorScale*>()) return element->axis()->label().toStdString();
    return std::string("no scale");
  };
  for (auto& channel : result.signals)
    if (channel.name == "aba_filtered") channel.unit = "V";
  EXPECT_EQ(scaleOf(*plots::scalogramFigure(result, {})), "Wavelet power [(V)² s]");
  EXPECT_EQ(scaleOf(*plots::amplitudeScalogramFigure(result, {})), "Wavelet power [(V)²]");
  EXPECT_EQ(scaleOf(*plots::stftFigure(result, {}, 64)), "Power density [(V)²/Hz]");
  EXPECT_EQ(scaleOf(*plots::scalogramFigure(tests::syntheticResult(), {})), "Wavelet power [(m/s²)² s]");
}

// Files of one name: the folders say which is which, no more of them than needed. Others are called as before.
TEST_F(FigureSheets, comparedResultsOfOneNameAreToldApartByTheirFolders) {
  signals::Passage passage;
  passage.series.unit = "m/s2", passage.series.step = 1 / 25000.0;
  for (int i = 0; i < 2000; ++i) {
    const double time = passage.series.timeAt(static_cast<std::size_t>(i)), since = std::max(time - 0.03, 0.0);
    passage.series.values.push_back(80 * std::exp(-since / 0.006) * std::sin(2 * M_PI * 300 * since));
    passage.position.push_back(30 * time);
  }
  passage.series.name = "light-defect: aba";
  const auto comparison = signals::compare(passage, passage, {});
  const auto names = [&](const char* first, const char* second) {
    const auto sheets = plots::comparisonFigures({{first, second, comparison, {}}}, false, plots::lightStyle());
    std::vector<std::string> found;  // first, second; the second is drawn behind the first
    for (const int graph : {1, 0}) found.push_back(sheets.at(0).panels.at(0)->graph(graph)->name().toStdString());
    EXPECT_EQ(sheets[0].name, "light-defect_aba_comparison");  // its file is called as ever
    return found;
  };
  using testing::ElementsAre;
  const std::string plain = "light-defect: aba";
  EXPECT_THAT(names("/runs/soft/light-defect.h5", "/runs/stiff/light-defect.h5"),
              ElementsAre("soft/" + plain, "stiff/" + plain));
  EXPECT_THAT(names("/soft/out/light-defect.h5", "/stiff/out/light-defect.h5"),
              ElementsAre("soft/out/" + plain, "stiff/out/" + plain));
  EXPECT_THAT(names("/runs/light-defect.h5", "/runs/new/light-defect.h5"),
              ElementsAre("runs/" + plain, "new/" + plain));
  EXPECT_THAT(names("/light-defect.h5", "/new/light-defect.h5"), ElementsAre(plain, "new/" + plain));
  EXPECT_THAT(names("/runs/a/light-defect.h5", "/runs/b/smooth-rail.h5"), ElementsAre(plain, plain));
  EXPECT_THAT(names("/runs/light-defect.h5", "/runs/light-defect.csv"), ElementsAre(plain, plain));
}

// One frequency axis below the other: a resonance and its phase stand in one vertical line.
TEST_F(FigureSheets, receptancePanelsAreAligned) {
  for (const auto& sheet : *everySheet)
    if (sheet.name == "track_receptance") {
      ASSERT_GT(sheet.panels.size(), 1u);
      for (const auto& panel : sheet.panels) {
        panel->settleLayout(panel->printedUnits());
        EXPECT_EQ(panel->axisRect()->left(), sheet.panels.front()->axisRect()->left()) << panel->name().toStdString();
        EXPECT_EQ(panel->axisRect()->right(), sheet.panels.front()->axisRect()->right()) << panel->name().toStdString();
      }
    }
}

// The paper prints its measurements as pictures only: the empty panel says what belongs there.
TEST_F(FigureSheets, emptyPanelsOfThePaperSayWhatBelongsThere) {
  int seen = 0;
  for (const auto& sheet : *everySheet) {
    if (sheet.name != "paper_figure_04" && sheet.name != "paper_figure_05" && sheet.name != "paper_figure_11") continue;
    const auto& panel = *sheet.panels.front();
    for (int i = 0; i < panel.itemCount(); ++i)
      if (const auto* text = qobject_cast<QCPItemText*>(panel.item(i)); text && text->text().contains("Belongs here"))
        seen += text->text().contains("ABA") ? 1 : 0;
  }
  EXPECT_EQ(seen, 3);
}

// Passages of twice the computed size fill the panels: they stand there, twice as large, and no panel is left empty.
TEST_F(FigureSheets, measuredPassagesFillThePanelsOfThePaper) {
  const auto run = tests::syntheticResult();
  results::AnalysedRecord passage = static_cast<const results::AnalysedRecord&>(run);
  passage.title = "pass";
  for (double& value : passage.channel("aba_filtered")->values) value *= 2;
  for (double& value : passage.psd) value *= 4;
  const auto largest = [](const plots::Figure& figure, int graph) {
    bool found = false;
    return figure.graph(graph)->getValueRange(found).upper;
  };
  for (const auto& sheet :
       plots::paperFigures({&run, &run, &run, {passage, passage}, {passage}}, plots::lightStyle())) {
    for (const auto& panel : sheet.panels)
      for (int i = 0; i < panel->itemCount(); ++i)
        if (const auto* text = qobject_cast<QCPItemText*>(panel->item(i))) {
          EXPECT_FALSE(text->text().contains("picture only")) << sheet.name << ": " << text->text().toStdString();
        }
    const auto& first = *sheet.panels.front();
    if (sheet.name == "paper_figure_04") {
      ASSERT_EQ(first.graphCount(), 2);
      EXPECT_EQ(first.graph(1)->name(), "measured: pass");
      EXPECT_DOUBLE_EQ(largest(first, 1), 2 * largest(*sheet.panels.back(), 0));
      EXPECT_EQ(first.yAxis->range(), sheet.panels.back()->yAxis->range());
    } else if (sheet.name == "paper_figure_06") {
      ASSERT_EQ(first.graphCount(), 3);
      EXPECT_DOUBLE_EQ(largest(first, 2), 4 * largest(first, 0));
    } else if (sheet.name == "paper_figure_05" || sheet.name == "paper_figure_11") {
      EXPECT_EQ(first.xAxis->range(), sheet.panels.back()->xAxis->range());
      EXPECT_TRUE(first.graphCount() > 0) << "no cone of influence, so no scalogram: " << sheet.name;
    } else if (sheet.name == "paper_figure_08" || sheet.name == "paper_figure_10") {
      ASSERT_EQ(first.graphCount(), 2);
      EXPECT_DOUBLE_EQ(largest(first, 1), 2 * largest(first, 0));
    }
  }
}

// Panels one by one: a label that a panel cuts would not show at the border of the sheet.
TEST_F(FigureSheets, nothingIsCut) {
  for (const auto& sheet : *everySheet)
    for (const auto& panel : sheet.panels) {
      const std::string name = sheet.name + " " + panel->name().toStdString();
      expectEmptyBorder(plots::toImage(*panel, 150), name);
      const QRectF axes = panel->axisRect()->rect().adjusted(-1, -1, 1, 1);
      for (int i = 0; i < panel->itemCount(); ++i)
        if (const auto* text = qobject_cast<QCPItemText*>(panel->item(i)); text && text->visible()) {
          const QPointF from = text->topLeft->pixelPosition(), to = text->bottomRight->pixelPosition();
          EXPECT_TRUE(axes.contains(from) && axes.contains(to))
              << name << ": \"" << text->text().toStdString() << "\" from " << from.x() << ", " << from.y() << " to "
              << to.x() << ", " << to.y() << " leaves the axes";
        }
    }
}

TEST_F(FigureSheets, lookAsTheyDid) {
  const std::string folder = tests::freshFolder("sheets-baseline");
  const QString kept = QStringLiteral(SQUAT_SOURCE_DIR "/tests/render/baselines/%1.png");
  for (const auto& sheet : *everySheet) {
    const QString name = QString::fromStdString(sheet.name), now = QString::fromStdString(folder) + "/" + name + ".png";
    const QImage small = tests::thumbnail(plots::toImage(sheet, 200), sheet.panels.size() > 1 ? 420 : 251);
    small.save(now);
    EXPECT_EQ(tests::lookDifferent(small, QImage(kept.arg(name))), "") << "now: " << now.toStdString();
  }
}

}  // namespace
}  // namespace squat
