// The project: what a day's work is made of comes back, after an orderly end, after a kill, and elsewhere.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "project/ProjectFile.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"
#include "studio/common/MessageBar.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/project/NotesPanel.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/runs/RunPanel.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

class ProjectOfRuns : public testing::Test {
 protected:
  std::unique_ptr<MainWindow> open(Answer answer = Answer::cancel) {
    StudioServices services = tests::services(20, answer);
    services.asker = [this, answer](QWidget*, const QString& question, const QString&) {
      questions_ << question;
      return answer;
    };
    services.recoveryFolder = folder_.filePath("recovery");
    services.runsFolder = folder_.filePath("stopped");
    auto window = std::make_unique<MainWindow>(services);
    window->show();
    return window;
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  void write(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  // One strike, without a speed; 0.4 s.
  void writeMeasured(const QString& name) const {
    QByteArray text = "time [s],aba [m/s2]\n";
    for (int i = 0; i < 4000; ++i) {
      const double since = i * 1e-4 - 0.2;
      const double value = since < 0 ? 0.1 * std::sin(0.3 * i) : 70 * std::exp(-80 * since) * std::sin(1900 * since);
      text += QByteArray::number(i * 1e-4) + ',' + QByteArray::number(value) + '\n';
    }
    write(name, text);
  }
  void run(MainWindow& window, const char* depth) const {
    window.document().setParameter("defect.depth", depth);
    window.startRun();
    ASSERT_TRUE(window.controller().waitFor(60000));
  }
  // Two runs, one renamed, coloured and overlaid, a measured reference, notes, a case that is not saved, chosen tabs.
  void work(MainWindow& window) const {
    writeMeasured("measured.csv");
    window.document().setParameter("defect.shape", "cosine");
    ASSERT_TRUE(window.saveCaseTo(path("dip.toml")));
    ASSERT_NO_FATAL_FAILURE(run(window, "0.15"));
    ASSERT_NO_FATAL_FAILURE(run(window, "0.3"));
    ASSERT_TRUE(window.openMeasured(path("measured.csv")));
    ASSERT_EQ(window.store().rowCount(), 3);
    window.store().rename(0, "the shallow one");
    window.store().setData(window.store().index(0), Qt::Checked, Qt::CheckStateRole);
    window.store().setColour(0, QColor("#123456"));
    window.store().setReference(0);
    window.notes()->insertPlainText("Second bogie: wheel flat?\n");
    window.document().setParameter("motion.speed", "41");
    window.showTab("psd");
    window.showTab("notes");
  }
  void expectTheWork(MainWindow& window, const QString& caseFile = "dip.toml") const {
    ASSERT_TRUE(window.reader()->waitFor(30000));
    RunStore& store = window.store();
    ASSERT_EQ(store.rowCount(), 3);
    EXPECT_EQ(store.at(0).label, "the shallow one");
    EXPECT_TRUE(store.at(0).overlaid);
    EXPECT_EQ(store.at(0).colour, QColor("#123456"));
    EXPECT_EQ(store.at(1).label, "depth 0.3");
    EXPECT_FALSE(store.at(1).named);
    EXPECT_EQ(store.current(), 1);
    EXPECT_EQ(store.reference(), 0);
    EXPECT_EQ(store.at(0).result->time, tests::syntheticResult().time);
    EXPECT_TRUE(store.at(2).isMeasured());
    EXPECT_TRUE(store.at(2).overlaid);
    EXPECT_EQ(store.at(2).label, "measured");
    EXPECT_EQ(window.notes()->toPlainText(), "Second bogie: wheel flat?\n");
    EXPECT_EQ(window.document().description().motion.speed, 41);
    EXPECT_TRUE(window.document().isModified());
    EXPECT_EQ(window.document().path(), path(caseFile));
    EXPECT_EQ(window.signalsPanel()->currentTab(), "psd");
    EXPECT_TRUE(window.notes()->isVisible());
  }
  QTemporaryDir folder_;
  QStringList questions_;
};

TEST_F(ProjectOfRuns, comesBackByteForByte) {
  {
    const auto window = open();
    ASSERT_NO_FATAL_FAILURE(work(*window));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project"))) << window->messages()->text().toStdString();
    EXPECT_TRUE(window->windowTitle().contains("day")) << window->windowTitle().toStdString();
    EXPECT_TRUE(window->close());
  }
  EXPECT_TRUE(questions_.isEmpty()) << questions_.join('\n').toStdString();  // all of it is in the project
  const QByteArray saved = read("day.squat-project");
  const auto window = open();
  ASSERT_TRUE(window->openAny(path("day.squat-project"))) << window->messages()->text().toStdString();
  // Saved while the runs are still being read: nothing of them is lost.
  EXPECT_TRUE(window->store().at(0).opening);
  window->keeper()->saveNow();
  EXPECT_EQ(read("day.squat-project"), saved);
  ASSERT_NO_FATAL_FAILURE(expectTheWork(*window));
  EXPECT_TRUE(window->messages()->isEmpty()) << window->messages()->text().toStdString();
  window->keeper()->saveNow();
  EXPECT_EQ(read("day.squat-project"), saved);
}

// What was done after the project got its file is in it some seconds later, and a run at once.
TEST_F(ProjectOfRuns, isSavedAsTheWorkGoesOn) {
  const auto window = open();
  ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
  ASSERT_NO_FATAL_FAILURE(work(*window));
  EXPECT_EQ(window->store().unsaved().size(), 0U);  // runs go straight into files of the project
  EXPECT_TRUE(window->store().at(1).path.startsWith(path("day-runs/"))) << window->store().at(1).path.toStdString();
  // Killed now: another process would find what this one has written. Two seconds after the last change, all of it.
  const auto whole = [&] { return read("day.squat-project").contains("wheel flat"); };
  EXPECT_TRUE(tests::passes(whole, 20000));
  ASSERT_TRUE(QFile::copy(path("day.squat-project"), path("copy.squat-project")));
  const auto other = open();
  ASSERT_TRUE(other->openProject(path("copy.squat-project"))) << other->messages()->text().toStdString();
  ASSERT_NO_FATAL_FAILURE(expectTheWork(*other));
  EXPECT_TRUE(QDir(path("recovery")).entryList({"*.case"}, QDir::Files).isEmpty());  // one place, not two
}

TEST_F(ProjectOfRuns, whatIsMissingIsListedAndStaysListed) {
  {
    const auto window = open();
    ASSERT_NO_FATAL_FAILURE(work(*window));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    ASSERT_TRUE(window->close());
  }
  const QDir runs(path("day-runs"));
  const QStringList files = runs.entryList(QDir::Files, QDir::Name);
  ASSERT_EQ(files, (QStringList{"dip-2.h5", "dip.h5"}));
  ASSERT_TRUE(QFile::remove(runs.filePath("dip.h5")));
  ASSERT_TRUE(QFile::rename(path("measured.csv"), path("elsewhere.csv")));
  // The other run is computed anew, with other values.
  auto changed = results::readResult(runs.filePath("dip-2.h5").toStdString());
  changed.channel("aba")->values[5] += 1;
  results::writeResult(runs.filePath("dip-2.h5").toStdString(), changed);
  {
    const auto window = open();
    ASSERT_TRUE(window->openProject(path("day.squat-project")));
    ASSERT_TRUE(window->reader()->waitFor(30000));
    EXPECT_TRUE(window->messages()->text().contains("3 files")) << window->messages()->text().toStdString();
    RunStore& store = window->store();
    ASSERT_EQ(store.rowCount(), 3);
    EXPECT_TRUE(store.at(0).isMissing());
    EXPECT_EQ(store.data(store.index(0), Qt::DisplayRole).toString(), "the shallow one (missing)");
    EXPECT_TRUE(store.data(store.index(0), Qt::ToolTipRole).toString().contains("dip.h5"));
    EXPECT_FALSE(store.at(1).isMissing());
    EXPECT_TRUE(store.at(2).isMissing());
    EXPECT_TRUE(store.overlays().empty());
    EXPECT_EQ(store.reference(), 1);  // what is missing is compared with nothing
    window->showTab("comparison");
    EXPECT_TRUE(tests::passes([&] { return !window->comparison()->isBusy(); }, 30000));
    EXPECT_TRUE(window->close());
  }
  ASSERT_TRUE(QFile::rename(path("elsewhere.csv"), path("measured.csv")));
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project")));
  ASSERT_TRUE(window->reader()->waitFor(30000));
  EXPECT_TRUE(window->store().at(0).isMissing());  // still, and not dropped
  EXPECT_FALSE(window->store().at(2).isMissing());
  EXPECT_TRUE(window->store().at(2).overlaid);  // as it was before it was missing
  EXPECT_EQ(window->store().at(0).label, "the shallow one");
  // It has only gone to another place.
  results::writeResult(path("found.h5").toStdString(), tests::syntheticResult());
  QMenu menu;
  auto* panel = window->findChild<RunsPanel*>();
  panel->fillMenu(menu, 0);
  tests::FileDialogTyping typing(path("found.h5"));
  menu.findChild<QAction*>("runFind")->trigger();
  EXPECT_TRUE(typing.done());
  ASSERT_FALSE(window->store().at(0).isMissing()) << window->messages()->text().toStdString();
  EXPECT_EQ(window->store().at(0).path, path("found.h5"));
  EXPECT_EQ(window->store().at(0).label, "the shallow one");
  EXPECT_EQ(window->store().at(0).colour, QColor("#123456"));
}

TEST_F(ProjectOfRuns, movesWithItsFolder) {
  ASSERT_TRUE(QDir(folder_.path()).mkpath("here"));
  {
    const auto window = open();
    ASSERT_NO_FATAL_FAILURE(run(*window, "0.15"));
    ASSERT_TRUE(window->saveProjectTo(path("here/day.squat-project")));
    ASSERT_TRUE(window->close());
  }
  ASSERT_TRUE(QDir(folder_.path()).rename("here", "there"));
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("there/day.squat-project")));
  ASSERT_TRUE(window->reader()->waitFor(30000));
  EXPECT_TRUE(window->messages()->isEmpty()) << window->messages()->text().toStdString();
  EXPECT_TRUE(window->store().currentResult());
}

TEST_F(ProjectOfRuns, aBrokenFileSaysWhatAndWhereAndChangesNothing) {
  const auto window = open();
  ASSERT_TRUE(window->openCase("light-defect"));
  write("day.squat-project", "{\n \"schema\": \"squat-project\",\n \"schema_version\": 1,\n \"open_case\": {\n");
  EXPECT_FALSE(window->openProject(path("day.squat-project")));
  EXPECT_TRUE(window->messages()->text().contains("line 5")) << window->messages()->text().toStdString();
  EXPECT_EQ(window->document().name(), "light-defect");
  EXPECT_FALSE(window->keeper()->isOpen());
}

TEST_F(ProjectOfRuns, hasOneOwnerAtATime) {
  const auto first = open(), second = open();
  ASSERT_TRUE(first->saveProjectTo(path("day.squat-project")));
  EXPECT_FALSE(second->openProject(path("day.squat-project")));
  EXPECT_TRUE(second->messages()->text().contains("open in another window"))
      << second->messages()->text().toStdString();
  EXPECT_FALSE(second->saveProjectTo(path("day.squat-project")));
  ASSERT_TRUE(first->closeProject());
  EXPECT_EQ(first->store().rowCount(), 0);
  EXPECT_TRUE(second->openProject(path("day.squat-project"))) << second->messages()->text().toStdString();
}

// A changed case, two runs and notes: one question, and one place for all of it.
TEST_F(ProjectOfRuns, oneQuestionOnClosing) {
  const auto window = open(Answer::save);
  ASSERT_NO_FATAL_FAILURE(work(*window));
  {
    tests::FileDialogTyping typing(path("kept.squat-project"));
    EXPECT_TRUE(window->close()) << window->messages()->text().toStdString();
    EXPECT_TRUE(typing.done());
  }
  ASSERT_EQ(questions_.size(), 1) << questions_.join('\n').toStdString();
  for (const char* part : {"unsaved changes", "2 results are not saved", "notes are not saved"})
    EXPECT_TRUE(questions_[0].contains(part)) << questions_[0].toStdString();
  const auto again = open();
  ASSERT_TRUE(again->openProject(path("kept.squat-project")));
  ASSERT_NO_FATAL_FAILURE(expectTheWork(*again));
}

// Notes and what is overlaid are in it; the pages themselves, plots::ReportPages tests.
TEST_F(ProjectOfRuns, isReported) {
  const auto window = open();
  EXPECT_FALSE(window->findChild<QAction*>("report")->isEnabled());
  ASSERT_NO_FATAL_FAILURE(work(*window));
  EXPECT_TRUE(window->findChild<QAction*>("report")->isEnabled());
  {
    tests::FileDialogTyping typing(path("day.pdf"));
    window->findChild<QAction*>("report")->trigger();
    EXPECT_TRUE(typing.done());
  }
  EXPECT_TRUE(read("day.pdf").startsWith("%PDF-"));
  EXPECT_TRUE(window->messages()->text().contains("day.pdf")) << window->messages()->text().toStdString();
  QProcess text;
  text.start("pdftotext", {"-raw", path("day.pdf"), "-"});
  ASSERT_TRUE(text.waitForFinished(60000));
  const QString pages = QString::fromUtf8(text.readAllStandardOutput());
  for (const char* part : {"Second bogie: wheel flat?", "the shallow one", "depth 0.3", "measured"})
    EXPECT_TRUE(pages.contains(part)) << part;
  EXPECT_FALSE(window->saveReportTo(path("no such folder/day.pdf")));
  EXPECT_TRUE(window->messages()->text().contains("cannot be written"));
}

// Of the run in front; another one is first seen through the filter of its own case.
TEST_F(ProjectOfRuns, keepsHowItsFiguresAreDrawn) {
  auto result = tests::syntheticResult();
  result.patches.resize(3, result.patches.at(0));
  result.patches[0].name = "frame 001", result.patches[2].name = "frame 003";
  results::writeResult(path("one.h5").toStdString(), result);
  results::writeResult(path("two.h5").toStdString(), result);
  {
    const auto window = open();
    ASSERT_TRUE(window->openResult(path("two.h5")));
    ASSERT_TRUE(window->openResult(path("one.h5")));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    const QWidget* panel = window->signalsPanel();
    panel->findChild<QDoubleSpinBox*>("cutoff")->setValue(777);
    panel->findChild<QDoubleSpinBox*>("psdFrom")->setValue(-50);
    panel->findChild<QDoubleSpinBox*>("psdTo")->setValue(110);
    panel->findChild<QComboBox*>("spectrumScale")->setCurrentText("dB");
    panel->findChild<QSpinBox*>("stftSegment")->setValue(96);
    panel->findChild<QSpinBox*>("stftHop")->setValue(7);
    panel->findChild<QSlider*>("patchMoment")->setValue(2);
    for (QComboBox* box : panel->findChildren<QComboBox*>()) {
      if (box->accessibleName() == "Colour map") box->setCurrentText("cividis");
      if (box->accessibleName().startsWith("Window function")) box->setCurrentText("hamming");
    }
    // Saved by itself.
    const auto saved = [this] { return read("day.squat-project").contains("\"hamming\""); };
    EXPECT_TRUE(tests::passes(saved, 20000));
    ASSERT_TRUE(window->close());
  }
  const QByteArray saved = read("day.squat-project");
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project"))) << window->messages()->text().toStdString();
  window->keeper()->saveNow();  // before a run is read
  EXPECT_EQ(read("day.squat-project"), saved);
  const auto whole = [&] { return window->store().current() == 1 && window->store().at(1).fields == Fields::both; };
  ASSERT_TRUE(tests::passes(whole, 30000));
  const analysis::FigureSettings& settings = window->signalsPanel()->settings();
  EXPECT_EQ(settings.cutoff, 777);
  EXPECT_DOUBLE_EQ(settings.section->from, -0.05);
  EXPECT_DOUBLE_EQ(settings.section->to, 0.11);
  EXPECT_EQ(settings.window, "hamming");
  EXPECT_EQ(settings.spectrum, analysis::SpectrumScale::decibel);
  EXPECT_EQ(settings.moment, 2);
  EXPECT_EQ(settings.segment, 96U);
  EXPECT_EQ(settings.hop, 7U);
  EXPECT_EQ(window->signalsPanel()->colourMap(), "cividis");
  window->keeper()->saveNow();
  EXPECT_EQ(read("day.squat-project"), saved);
  // Another run is first seen with its own section, at its own impact.
  window->store().setCurrent(0);
  EXPECT_DOUBLE_EQ(settings.section->from, -0.1);
  EXPECT_DOUBLE_EQ(settings.section->to, 0.28);
  ASSERT_TRUE(tests::passes([&] { return window->store().at(0).fields == Fields::both; }, 30000));
  EXPECT_EQ(settings.moment, 1);
}

// A file may ask for more than the controls can have.
TEST_F(ProjectOfRuns, drawsNoFigureInAWayThatThereIsNot) {
  const auto window = open();
  SignalsPanel* panel = window->signalsPanel();
  project::FigureViews views;
  views.settings = {1e12, "triangle", {{-1e12, 1e12}}, {}, 1 << 30, 1U << 30U, 1U << 30U, "plaid"};
  const project::AxisRange range{1, 2, "furlong"};
  views.ranges = {{"portrait", range, range}, {"psd", range, range}};
  panel->setViews(views, path("one.h5"));
  EXPECT_EQ(panel->settings().cutoff, panel->findChild<QDoubleSpinBox*>("cutoff")->maximum());
  EXPECT_EQ(panel->settings().section->from, 1e-3 * panel->findChild<QDoubleSpinBox*>("psdFrom")->minimum());
  EXPECT_EQ(panel->settings().window, "hann");
  EXPECT_EQ(panel->settings().spectrum, analysis::SpectrumScale::linear);
  EXPECT_EQ(panel->colourMap(), "viridis");
  EXPECT_LE(panel->settings().segment, 8192U);
  window->store().add({std::make_shared<results::RunResult>(tests::syntheticResult()), "run", path("one.h5"), false});
  panel->showTab("psd");
  EXPECT_FALSE(panel->view("psd")->isZoomed());
}

// On a memory stick, which another machine reads: there is no other file left.
TEST_F(ProjectOfRuns, movesWithItsDataToAnotherMachine) {
  ASSERT_TRUE(QDir(folder_.path()).mkpath("stick"));
  QByteArray saved;
  {
    const auto window = open();
    const auto* action = window->findChild<QAction*>("copyProject");
    ASSERT_NO_FATAL_FAILURE(work(*window));
    EXPECT_FALSE(action->isEnabled());  // what is copied is a project
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    ASSERT_TRUE(action->isEnabled());
    {
      tests::FileDialogTyping typing(path("stick/copy.squat-project"));
      window->findChild<QAction*>("copyProject")->trigger();
      EXPECT_TRUE(typing.done());
    }
    ASSERT_TRUE(window->keeper()->waitForCopy(30000));
    EXPECT_TRUE(window->messages()->text().contains("copied to")) << window->messages()->text().toStdString();
    EXPECT_EQ(window->keeper()->path(), path("day.squat-project"));  // the work goes on where it was
    ASSERT_TRUE(window->closeProject());
    EXPECT_FALSE(action->isEnabled());
  }
  EXPECT_EQ(QDir(path("stick")).entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot),
            (QStringList{"copy.data", "copy.squat-project"}));
  for (const char* name : {"dip.toml", "measured.csv", "day.squat-project"}) ASSERT_TRUE(QFile::remove(path(name)));
  ASSERT_TRUE(QDir(path("day-runs")).removeRecursively());
  ASSERT_TRUE(QDir(folder_.path()).rename("stick", "there"));
  saved = read("there/copy.squat-project");
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("there/copy.squat-project"))) << window->messages()->text().toStdString();
  ASSERT_NO_FATAL_FAILURE(expectTheWork(*window, "there/copy.data/cases/dip.toml"));
  EXPECT_TRUE(window->messages()->isEmpty()) << window->messages()->text().toStdString();  // nothing has changed
  window->keeper()->saveNow();
  EXPECT_EQ(read("there/copy.squat-project"), saved);
}

TEST_F(ProjectOfRuns, aCopySaysWhatIsMissingAndReplacesNothing) {
  const auto window = open();
  ASSERT_NO_FATAL_FAILURE(work(*window));
  EXPECT_FALSE(window->copyProjectTo(path("copy.squat-project")));
  EXPECT_TRUE(window->messages()->text().contains("Save the project first"));
  ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
  EXPECT_FALSE(window->copyProjectTo(path("day.squat-project")));
  EXPECT_TRUE(window->messages()->text().contains("project that is open"));
  ASSERT_TRUE(QFile::remove(path("measured.csv")));
  ASSERT_TRUE(window->copyProjectTo(path("copy.squat-project")));
  ASSERT_TRUE(window->keeper()->waitForCopy(30000));
  EXPECT_TRUE(window->messages()->text().contains("1 file is missing from the copy"))
      << window->messages()->text().toStdString();
  const QString details = window->messages()->details();
  EXPECT_TRUE(details.contains(path("measured.csv"))) << details.toStdString();
  // Its data stand there now.
  ASSERT_TRUE(window->copyProjectTo(path("copy.squat-project")));
  ASSERT_TRUE(window->keeper()->waitForCopy(30000));
  EXPECT_TRUE(window->messages()->text().contains("copy.data")) << window->messages()->text().toStdString();
  EXPECT_TRUE(window->messages()->text().contains("not copied")) << window->messages()->text().toStdString();
}

// 300 MB take some tenths of a second to copy; the file is a hole, and what is copied before the end is not kept.
TEST_F(ProjectOfRuns, aCopyIsStoppedByTheUserAlone) {
  write("big.h5", "no result, and copied as it is");
  ASSERT_TRUE(QFile::resize(path("big.h5"), 300000000));
  project::Project project;
  project.open = {"dip", "", false, cases::writeCase(cases::defaultCase())};
  project.entries.resize(1);
  project.entries[0].path = path("big.h5").toStdString();
  project::writeProject(path("day.squat-project").toStdString(), project);
  const auto window = open();
  ASSERT_TRUE(window->openProject(path("day.squat-project")));
  ASSERT_TRUE(window->reader()->waitFor(30000));
  ASSERT_TRUE(window->copyProjectTo(path("copy.squat-project")));
  EXPECT_FALSE(window->close());
  ASSERT_EQ(questions_.size(), 1);
  EXPECT_TRUE(questions_[0].contains("copy")) << questions_[0].toStdString();
  ASSERT_TRUE(window->keeper()->isCopying());
  EXPECT_FALSE(window->copyProjectTo(path("other.squat-project")));  // one at a time
  window->keeper()->cancelCopy();
  ASSERT_TRUE(window->keeper()->waitForCopy(30000));
  EXPECT_TRUE(window->messages()->text().contains("cancelled")) << window->messages()->text().toStdString();
  EXPECT_EQ(QDir(folder_.path()).entryList({"copy*", "other*"}, QDir::Files | QDir::Dirs | QDir::Hidden).size(), 0);
}

TEST_F(ProjectOfRuns, theLastOneIsOpenedAtTheStart) {
  {
    const auto window = open();
    ASSERT_NO_FATAL_FAILURE(work(*window));
    ASSERT_TRUE(window->saveProjectTo(path("day.squat-project")));
    ASSERT_TRUE(window->close());
  }
  {
    const auto window = open();
    window->openLastProject();
    ASSERT_NO_FATAL_FAILURE(expectTheWork(*window));
    ASSERT_TRUE(window->closeProject());  // nobody wants it at the next start
  }
  const auto window = open();
  window->openLastProject();
  EXPECT_FALSE(window->keeper()->isOpen());
}

// What was said of a run of the project goes with it.
TEST(Project, closedLeavesNothingOfItsRunsBehind) {
  const QTemporaryDir folder;
  MainWindow window(tests::services());
  const auto* line = window.findChild<QLabel*>("runLine");
  const auto* log = window.findChild<RunPanel*>()->findChild<QPlainTextEdit*>();
  ASSERT_TRUE(window.openCase("light-defect"));
  ASSERT_TRUE(window.saveProjectTo(folder.filePath("day.squat-project")));
  window.startRun();
  ASSERT_TRUE(window.controller().waitFor(60000));
  ASSERT_TRUE(line->text().contains("Done")) << line->text().toStdString();
  ASSERT_FALSE(log->toPlainText().isEmpty());
  ASSERT_TRUE(window.closeProject());
  EXPECT_EQ(line->text(), "");
  EXPECT_EQ(log->toPlainText(), "");
  EXPECT_EQ(window.store().rowCount(), 0);
  EXPECT_FALSE(window.isWindowModified());
}

}  // namespace
}  // namespace squat::studio
