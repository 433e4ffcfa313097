// The report as its reader has it: the PDF taken apart by poppler.
#include "plots/ReportPages.h"

#include <gmock/gmock.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/Errors.h"
#include "plots/Application.h"
#include "project/ReportContent.h"
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
  // Page by page, in the order in which it was drawn.
  QStringList pages(const ReportOptions& options = {}) {
    QStringList all = printed("pdftotext", {"-raw"}, options).split('\f', Qt::SkipEmptyParts);
    for (QString& page : all) page = page.trimmed();
    return all;
  }
  // A word on a page, in points from the upper left corner.
  struct Word {
    double top = 0, bottom = 0;
    QString text;
  };
  // Without the footers, which stand in the lower margin of 18 mm.
  std::vector<std::vector<Word>> wordsOfPages(const ReportOptions& options, double& height) {
    const QString text = printed("pdftotext", {"-bbox"}, options);
    static const QRegularExpression page("<page [^>]*height=\"([0-9.]+)\""),
        word("<word [^>]*yMin=\"([0-9.]+)\" [^>]*yMax=\"([0-9.]+)\">([^<]*)<");
    std::vector<std::vector<Word>> all;
    for (const QString& line : text.split('\n')) {
      if (const auto found = page.match(line); found.hasMatch())
        all.emplace_back(), height = found.captured(1).toDouble();
      const auto found = word.match(line);
      if (!found.hasMatch() || all.empty()) continue;
      const Word one{found.captured(1).toDouble(), found.captured(2).toDouble(), found.captured(3)};
      if (one.bottom < height - 18 / 25.4 * 72) all.back().push_back(one);
    }
    return all;
  }
  // The signal over a squat, as a search writes it: 50 ms around the event's time of 10 s, which ring at 300 Hz.
  void writePassage(const QString& name) {
    QDir(folder_.path()).mkpath("passages");
    QFile file(folder_.filePath("passages/" + name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("time [s],speed [m/s],aba [m/s2]\n");
    for (int i = 0; i < 1250; ++i) {
      const double time = 9.983 + i / 25000.0, since = std::max(0.0, time - 10);
      const double value = 0.1 * std::sin(400 * time) + 80 * std::exp(-since / 0.01) * std::sin(1885 * since);
      file.write(QByteArray::number(time, 'g', 12) + ",30," + QByteArray::number(value) + '\n');
    }
  }
  // Two squats and a weld between them.
  void addEvents() {
    project::ListedEvent squat;
    squat.position = 100, squat.time = 10, squat.record = "ride.csv", squat.channel = "left";
    squat.kind = "squat", squat.severity = "moderate", squat.severities = {0.1, 0.7, 0.2};
    squat.sureness = 0.9, squat.peak = 80, squat.speed = 30;
    squat.length = 0.045, squat.lengthLow = 0.03, squat.lengthHigh = 0.06;
    squat.depth = 0.2e-3, squat.depthLow = 0.1e-3, squat.depthHigh = 0.3e-3;
    auto weld = squat, second = squat;
    weld.position = 150, weld.kind = "weld", weld.severity.clear();
    second.position = 200, second.severity = "light";
    report_.events = {{"ride.csv"}, {squat, weld, second}};
    report_.eventFolder = folder_.path().toStdString();
    writePassage("squat-0001.csv");  // by the rows of the list
    writePassage("squat-0003.csv");
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
  const auto content = project::reportContent(report_, problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  auto tables = content.body;
  tables.insert(tables.end(), content.appendix.begin(), content.appendix.end());
  ASSERT_EQ(tables.size(), 6U);  // summary, inputs; runs, measured signals, features, case
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
  ASSERT_EQ(content.sentences.size(), 3U);
  for (const auto& sentence : content.sentences)
    EXPECT_TRUE(text.contains(packed(QString::fromStdString(sentence)))) << sentence;
  for (const char* part : {"Second bogie, km 12.3", "Wheel flat?", "A squat of 20 mm.", "page 1 of"})
    EXPECT_TRUE(text.contains(packed(part))) << part;
  EXPECT_TRUE(problems_.empty() || problems_[0].find("model") != std::string::npos) << problems_[0];
}

// The shallow run was made as half of the other: its ratio to the measured one, which is 1.2 of it, is 0.4167.
TEST_F(ReportPages, compareWithTheReference) {
  std::vector<std::string> problems;
  const auto summary = project::reportContent(report_, problems).body[0];
  const auto row = [&](const std::string& title) {
    const auto found =
        std::find_if(summary.rows.begin(), summary.rows.end(), [&](const auto& each) { return each[0] == title; });
    return found == summary.rows.end() ? std::vector<std::string>(4, "0") : *found;
  };
  const auto ratio = row("Largest acceleration by that of measured"), depth = row("Depth [mm]");
  // The passages are laid over each other to a fraction of a sample, and read there: a thousandth of the peak.
  EXPECT_NEAR(std::stod(ratio[1]), 1 / 1.2, 1e-3);
  EXPECT_NEAR(std::stod(ratio[2]), 0.5 / 1.2, 1e-3);
  EXPECT_NEAR(std::stod(ratio[3]), 1, 1e-3);
  EXPECT_EQ(depth[3], "-");  // nobody knows
}

// Title, date, short notes; then the picture, and a sentence for each signal.
TEST_F(ReportPages, openWithAPictureAndASentence) {
  report_.date = "2 March 2026";
  const QString first = pages().at(0);
  qsizetype before = -1;
  for (const char* part :
       {"Second bogie, km 12.3", "2 March 2026", "Wheel flat?", "Wheel position relative to the defect",
        "deep (Light defect", "shallow (Light defect", "measured, measured, 30 m/s"}) {
    const auto at = first.indexOf(part);
    EXPECT_GT(at, before) << part;
    before = at;
  }
  EXPECT_TRUE(first.startsWith("Second bogie, km 12.3"));
}

// A page of notes would push the picture away.
TEST_F(ReportPages, haveLongNotesBehindTheSentences) {
  report_.notes = std::string(500, 'n') + "\n\nThe end.";
  const QString text = printed("pdftotext", {"-raw"});
  EXPECT_GT(text.indexOf("The end."), text.indexOf("deep (Light defect"));
  EXPECT_LT(text.indexOf("The end."), text.indexOf("Appendix"));
}

TEST_F(ReportPages, haveNoKeyBeforeTheAppendix) {
  addEvents();
  const QString text = printed("pdftotext", {"-raw"});
  const auto end = text.indexOf("Appendix");
  ASSERT_GT(end, 0);
  const auto key = QRegularExpression("[a-z0-9]+_[a-z0-9]+").match(text.left(end));
  EXPECT_FALSE(key.hasMatch()) << key.captured().toStdString();
  EXPECT_TRUE(text.mid(end).contains("young_modulus"));
}

// What does not fit on the rest of a page is at most as high as the first picture, 80 mm of 261; the pages that readers
// complained of were two thirds empty. The model is a picture without words, and left out.
TEST_F(ReportPages, areFilled) {
  double height = 0;
  const auto words = wordsOfPages(
      {PageFormat::a4, {"aba_position", "psd", "contact_force", "contact_patch", "defect_profile"}, "viridis"}, height);
  ASSERT_GE(words.size(), 3U);
  for (std::size_t page = 0; page < words.size(); ++page) {
    ASSERT_FALSE(words[page].empty()) << "page " << page + 1;
    double last = 0;
    for (const auto& word : words[page]) last = std::max(last, word.bottom);
    if (page + 1 < words.size()) {
      EXPECT_GT(last, 0.5 * height) << "page " << page + 1;
    }
  }
}

// Qt leaves out the margin above what follows a table: a heading has to have it all the same.
TEST_F(ReportPages, haveRoomAboveHeadingsBehindTables) {
  double height = 0;
  int seen = 0;
  for (const auto& words : wordsOfPages({PageFormat::a4, {"psd"}, "viridis"}, height))
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
      const bool isHeading = words[i].text == "Features" && words[i + 1].text == "of" && words[i + 2].text == "deep";
      const bool isOther = words[i].text == "Measured" && words[i + 1].text == "signals";
      if (!isHeading && !isOther) continue;
      double above = 0;
      for (const auto& word : words)
        if (word.bottom <= words[i].top + 1) above = std::max(above, word.bottom);
      if (above == 0) continue;                                           // at the head of its page
      EXPECT_GT(words[i].top - above, 9) << words[i].text.toStdString();  // [pt] of the 5 mm, 14 pt, that it is given
      ++seen;
    }
  EXPECT_GT(seen, 0);
}

TEST_F(ReportPages, giveEverySquatAPage) {
  addEvents();
  const auto all = pages();
  QStringList squats;
  for (const QString& page : all)
    if (page.startsWith("Squat at")) squats << page;
  ASSERT_EQ(squats.size(), 2);
  EXPECT_TRUE(squats[0].startsWith("Squat at 100.00 m"));
  EXPECT_TRUE(squats[1].startsWith("Squat at 200.00 m"));
  for (const QString& page : squats) {
    EXPECT_EQ(page.count("Squat at"), 1);
    EXPECT_TRUE(page.contains("Position relative to the event"));  // the signal
    EXPECT_TRUE(page.contains("45 mm (30 to 60 mm)"));
    EXPECT_TRUE(page.contains("light 10 %, moderate 70 %, severe 20 %"));
    EXPECT_FALSE(page.contains("Appendix"));
  }
  EXPECT_TRUE(all[0].contains("Long records: 2 squats (1 light, 1 moderate) and 1 other event."));
  const auto isOfSquats = ::testing::AnyOf(HasSubstr("no signals over"), HasSubstr("Squat at"));
  EXPECT_THAT(problems_, ::testing::Not(::testing::Contains(isOfSquats)));
  QFile::remove(folder_.filePath("passages/squat-0003.csv"));
  EXPECT_EQ(pages().filter("The signal over this squat is in no file").size(), 1);
  EXPECT_THAT(problems_, ::testing::Contains(HasSubstr("no signals over 1 of 2 squats")));
}

// Without a run, the report opens with what there is.
TEST_F(ReportPages, openWithTheEventsOrWithASignal) {
  report_.shown = -1;
  EXPECT_TRUE(pages().at(0).contains("Wheel position relative to the defect"));
  report_.signals.clear();
  report_.reference = -1;
  addEvents();
  const QString first = pages().at(0);
  EXPECT_GT(first.indexOf("Place along the track [m]"), 0);
  EXPECT_LT(first.indexOf("Place along the track [m]"), first.indexOf("Long records: 2 squats"));
  EXPECT_EQ(first.count("Place along the track"), 1);  // not again above the list of squats
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
  report_.shown = -1;  // no run alone: tables, no figures of one
  const QString text = packed(printed("pdftotext", {"-raw"}));
  EXPECT_TRUE(text.contains("Summary"));
  EXPECT_FALSE(text.contains("Figuresof"));
}

}  // namespace
}  // namespace squat::plots
