// The report as its reader has it: the PDF taken apart by poppler.
#include "case/CaseDescription.h"
#include "plots/ReportPages.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <algorithm>

#include "case/CaseFile.h"
#include "core/Errors.h"
#include "plots/Application.h"
#include "render/SyntheticResult.h"

namespace squat::plots {
namespace {

using ::testing::HasSubstr;

// Two runs and a measured signal, which is the reference.
class ReportPages : public ::testing::Test {
 protected:
  void SetUp() override {
    ensureApplication();
    auto deep = std::make_shared<results::RunResult>(tests::syntheticResult());
    auto description = cases::loadCase("light-defect");
    results::setCase(*deep, description);
    deep->psdWindow = "hann, 183 samples", deep->psdFrom = -0.1, deep->psdTo = 0.12;  // as a run has it
    auto shallow = std::make_shared<results::RunResult>(*deep);
    description.defect.depth = 0.5 * description.defect.depth;
    results::setCase(*shallow, description);
    for (auto* name : {"aba", "aba_filtered"})
      for (double& value : shallow->channel(name)->values) value *= 0.5;
    QFile file(folder_.filePath("measured.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("time [s],position [m],aba [m/s2]\n");
    const auto& values = *deep->signal("aba");
    for (std::size_t i = 0; i < values.size(); ++i)
      file.write(QByteArray::number(deep->time[i], 'g', 12) + ',' + QByteArray::number(deep->position[i], 'g', 12) +
                 ',' + QByteArray::number(1.2 * values[i]) + '\n');
    file.close();
    const auto measured =
        project::measuredRecords(file.fileName().toStdString(), 30, {{}, project::impactOf(deep.get())});
    ASSERT_EQ(measured.size(), 1U);
    report_.title = "Second bogie, km 12.3";
    report_.notes = "Wheel flat?\n\nA squat of 20 mm.";
    report_.signals = {
        {"deep", "deep.h5", deep, deep},
        {"shallow", "shallow.h5", shallow, shallow, {}, true},
        {"measured", file.fileName().toStdString(), measured[0].record, nullptr, measured[0].reading, true}};
    report_.shown = 0, report_.reference = 2;
  }

  // What a tool of poppler prints about the report.
  QString printed(const QString& tool, const QStringList& options, const ReportOptions& pages = {}) {
    const QString path = folder_.filePath("report.pdf");
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(reportPdf(report_, pages, problems_));
    file.close();
    QProcess process;
    process.start(tool, options + QStringList{path} + (tool == "pdftotext" ? QStringList{"-"} : QStringList()));
    EXPECT_TRUE(process.waitForFinished(60000)) << tool.toStdString() << ": Debian package poppler-utils";
    return QString::fromUtf8(process.readAllStandardOutput());
  }
  // Lines may break anywhere in a cell.
  static QString packed(QString text) {
    text.remove(QChar(0x200b));
    return text.simplified().remove(' ');
  }

  QTemporaryDir folder_;
  project::Report report_;
  std::vector<std::string> problems_;
};

// A signal that is laid over the run is named in the legend of the spectrum; both signals are in two tables anyway.
TEST_F(ReportPages, drawWhatIsOverlaid) {
  const ReportOptions spectrum{PageFormat::a4, {"psd"}, "viridis"};
  const auto count = [&] { return printed("pdftotext", {"-raw"}, spectrum).count("shallow"); };
  const auto drawn = count();
  report_.signals[1].overlaid = false;
  EXPECT_EQ(drawn, count() + 1);
}

// Cell by cell in the order of the page: a row is found whole, so that no number stands beside a wrong name.
TEST_F(ReportPages, holdEveryRowOfEveryTable) {
  const QString text = packed(printed("pdftotext", {"-raw"}));
  std::vector<std::string> problems;
  const auto tables = project::reportTables(report_, problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  ASSERT_EQ(tables.size(), 4U);  // signals, comparison, features, case
  std::size_t rows = 0;
  for (const auto& table : tables) {
    EXPECT_TRUE(text.contains(packed(QString::fromStdString(table.heading)))) << table.heading;
    for (const auto& row : table.rows) {
      QString whole;
      for (const auto& cell : row) whole += QString::fromStdString(cell);
      EXPECT_TRUE(text.contains(packed(whole))) << whole.toStdString();
      ++rows;
    }
  }
  EXPECT_GT(rows, 80U);
  for (const char* part : {"Second bogie, km 12.3", "Wheel flat?", "A squat of 20 mm.", "page 1 of"})
    EXPECT_TRUE(text.contains(packed(part))) << part;
  EXPECT_TRUE(problems_.empty() || problems_[0].find("model") != std::string::npos) << problems_[0];
}

// The shallow run was made as half of the other: its ratio to the measured one, which is 1.2 of it, is 0.4167.
TEST_F(ReportPages, compareWithTheReference) {
  std::vector<std::string> problems;
  const auto comparison = project::reportTables(report_, problems)[1];
  EXPECT_THAT(comparison.heading, HasSubstr("with measured"));
  const auto ratio = std::find_if(comparison.rows.begin(), comparison.rows.end(),
                                  [](const auto& row) { return row[0].find("ratio") != std::string::npos; });
  ASSERT_NE(ratio, comparison.rows.end());
  // The passages are laid over each other to a fraction of a sample, and read there: a thousandth of the peak.
  EXPECT_NEAR(std::stod((*ratio)[1]), 1 / 1.2, 1e-3);
  EXPECT_NEAR(std::stod((*ratio)[2]), 0.5 / 1.2, 1e-3);
  EXPECT_NEAR(std::stod((*ratio)[3]), 1, 1e-3);
  const auto depth = std::find_if(comparison.rows.begin(), comparison.rows.end(),
                                  [](const auto& row) { return row[0].find("depth") == 0; });
  ASSERT_NE(depth, comparison.rows.end());
  EXPECT_EQ((*depth)[3], "-");  // nobody knows
}

TEST_F(ReportPages, fitStandardSheetsAndBringTheirFonts) {
  EXPECT_THAT(printed("pdfinfo", {}).toStdString(), HasSubstr("(A4)"));
  EXPECT_THAT(printed("pdfinfo", {}, {PageFormat::letter, {"psd"}, "viridis"}).toStdString(), HasSubstr("(letter)"));
  const QStringList fonts = printed("pdffonts", {}).split('\n', Qt::SkipEmptyParts).mid(2);
  ASSERT_FALSE(fonts.isEmpty());
  for (const QString& font : fonts)  // columns: name, type, encoding, embedded, subset, with unicode
    EXPECT_TRUE(font.contains(QRegularExpression("yes +(yes|no) +yes"))) << font.toStdString();
}

TEST_F(ReportPages, haveOnlyTheFiguresThatWereAskedFor) {
  const ReportOptions one{PageFormat::a4, {"psd"}, "viridis"};
  const QString all = printed("pdftotext", {}), some = printed("pdftotext", {}, one);
  EXPECT_TRUE(all.contains("Force on the rail [kN]"));
  EXPECT_FALSE(some.contains("Force on the rail [kN]"));
  EXPECT_THROW(printed("pdftotext", {}, {PageFormat::a4, {"nonsense"}, "viridis"}), CaseError);
  // A run that was stopped early, or a study's, has no contact patch to draw.
  auto bare = std::make_shared<results::RunResult>(*report_.signals[0].result);
  bare->patches.clear();
  report_.signals[0].result = bare, report_.signals[0].record = bare;
  EXPECT_THROW(printed("pdftotext", {}, {PageFormat::a4, {"contact_patch"}, "viridis"}), CaseError);
  report_.shown = -1;  // measured signals alone: tables, no figures
  const QString text = packed(printed("pdftotext", {"-raw"}));
  EXPECT_TRUE(text.contains("Comparison"));
  EXPECT_FALSE(text.contains("Figuresof"));
}

}  // namespace
}  // namespace squat::plots
