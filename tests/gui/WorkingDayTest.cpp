// A whole working day around the real computation, by mouse and keys alone: open, edit, undo, redo, run, watch, cancel,
// run again, overlay a measured signal, export, save, reopen.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "case/CaseFile.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "results/SignalTable.h"
#include "simulation/RunCase.h"
#include "studio/common/MessageBar.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/runs/LivePlot.h"
#include "studio/runs/RunPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

using tests::BoxAnswer;
using tests::click;
using tests::drag;
using tests::FileDialogTyping;
using tests::press;
using tests::type;

constexpr int patienceOfADay = 1200000;  // [ms] for busy machines and sanitizers; an idle core needs some seconds

class WorkingDay : public testing::Test {
 protected:
  static StudioServices realServices() {
    StudioServices services;  // real questions in real boxes
    services.runner = simulation::runCase;
    services.threads = 1;  // other tests may hold the second core
    return services;
  }
  void open(MainWindow& window) {
    window.resize(1500, 920);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  }
  // Finds the parameter by typing its key into the search, then types its value.
  void enter(const std::string& key, const QString& value) {
    searchFor(QString::fromStdString(key));
    QWidget* editor = window_.form()->row(key)->editor();
    ASSERT_TRUE(editor->isVisible()) << key;
    click(*editor);
    if (qobject_cast<QLineEdit*>(editor)) press(window_, Qt::Key_A, Qt::ControlModifier);
    type(window_, value);
    press(window_, Qt::Key_Return);
  }
  void searchFor(const QString& text) {
    click(*window_.findChild<QLineEdit*>("parameterSearch"));
    press(window_, Qt::Key_A, Qt::ControlModifier);
    press(window_, Qt::Key_Delete);
    type(window_, text);
  }
  void editTheProfile() {
    ProfilePlot* plot = window_.profile()->plot();
    plot->replot(QCustomPlot::rpImmediateRefresh);
    const auto& points = window_.document().description().defect.points;
    std::size_t deepest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].height < points[deepest].height) deepest = i;
    const double before = points[deepest].height;
    const QPoint from = plot->locationOf(deepest).toPoint();
    drag(*plot, from, from + QPoint(0, 12));
    const double deeper = window_.document().description().defect.points[deepest].height;
    EXPECT_LT(deeper, before);
    press(window_, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window_.document().description().defect.points[deepest].height, before);
    press(window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(window_.document().description().defect.points[deepest].height, deeper);
  }
  // A short stretch on the coarsest mesh.
  void makeItShort() {
    ASSERT_NO_FATAL_FAILURE(enter("mesh.preset", "tiny"));
    ASSERT_NO_FATAL_FAILURE(enter("motion.run_up", "0.06"));
    ASSERT_NO_FATAL_FAILURE(enter("motion.beyond", "0.07"));
    searchFor("");
    const auto& made = window_.document().description();
    ASSERT_EQ(qobject_cast<QComboBox*>(window_.form()->row("mesh.preset")->editor())->currentText(), "tiny");
    ASSERT_DOUBLE_EQ(made.motion.runUp, 0.06);
    ASSERT_DOUBLE_EQ(made.motion.beyond, 0.07);
    ASSERT_TRUE(window_.form()->blockers().isEmpty()) << window_.form()->blockers().join('\n').toStdString();
  }
  void runCancelAndRunAgain() {
    auto* run = window_.findChild<QPushButton*>("run");
    auto* panel = window_.findChild<RunPanel*>();
    auto* figures = window_.findChild<QLabel*>("runLine");
    click(*run);
    ASSERT_TRUE(tests::passes([&] { return panel->live()->sampleCount() > 2; }, patienceOfADay));
    EXPECT_FALSE(run->isEnabled());
    // Step and what sets it, updates a second and the energy balance are told while it runs.
    for (const char* word : {"limited by", "element updates per second", "energy balance error"})
      EXPECT_TRUE(tests::passes([&] { return figures->text().contains(word); }, patienceOfADay))
          << figures->text().toStdString();
    click(*window_.findChild<QPushButton*>("cancel"));
    ASSERT_TRUE(tests::passes([&] { return !window_.controller().isRunning(); }, patienceOfADay));
    ASSERT_EQ(window_.store().rowCount(), 1);
    EXPECT_FALSE(window_.store().currentResult()->complete);
    press(window_, Qt::Key_F5);
    ASSERT_TRUE(tests::passes([&] { return window_.store().rowCount() == 2; }, patienceOfADay));
    ASSERT_TRUE(window_.store().currentResult()->complete) << window_.messages()->text().toStdString();
  }
  void overlayAMeasuredSignal() {
    const ResultPointer computed = window_.store().currentResult();
    results::writeSignalTable(folder_.filePath("measured.csv").toStdString(), *computed);
    FileDialogTyping typing(folder_.filePath("measured.csv"));
    press(window_, Qt::Key_M, Qt::ControlModifier);
    ASSERT_TRUE(typing.done());
    ASSERT_EQ(window_.store().overlays().size(), 1u) << window_.messages()->text().toStdString();
    // The same signal: its impact lies where the run's does. A sample is 1.2 mm.
    EXPECT_NEAR(window_.store().overlays()[0].record->position.front(), computed->position.front(), 1.3e-3);
    EXPECT_GE(window_.signalsPanel()->view("aba_position")->figure()->graphCount(), 3);
  }
  void exportAll() {
    FileDialogTyping typing(folder_.path());
    click(*window_.findChild<QPushButton*>("exportAllButton"));
    ASSERT_TRUE(typing.done());
    const QStringList files = window_.signalsPanel()->exportPaths(folder_.path());
    EXPECT_GT(files.size(), 4 * 6);
    for (const QString& path : files) EXPECT_GT(QFileInfo(path).size(), 20) << path.toStdString();
  }

  const QTemporaryDir folder_;
  MainWindow window_{realServices()};
};

TEST_F(WorkingDay, fromOpeningToReopening) {
  ASSERT_NO_FATAL_FAILURE(open(window_));
  tests::clickMenu(window_, {"File", "Shipped cases", "light-defect-long-overhang"});
  ASSERT_EQ(window_.document().name(), "light-defect-long-overhang");
  ASSERT_NO_FATAL_FAILURE(editTheProfile());
  ASSERT_NO_FATAL_FAILURE(makeItShort());
  ASSERT_NO_FATAL_FAILURE(runCancelAndRunAgain());
  ASSERT_NO_FATAL_FAILURE(overlayAMeasuredSignal());
  ASSERT_NO_FATAL_FAILURE(exportAll());

  const cases::CaseDescription edited = window_.document().description();
  const ResultPointer computed = window_.store().currentResult();
  {
    FileDialogTyping typing(folder_.filePath("day.toml"));
    press(window_, Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(typing.done());
    EXPECT_FALSE(window_.document().isModified()) << window_.messages()->text().toStdString();
  }
  {
    FileDialogTyping typing(folder_.filePath("day.h5"));
    press(window_, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(typing.done());
  }
  {
    BoxAnswer answer("Discard");  // the cancelled run is not saved
    press(window_, Qt::Key_Q, Qt::ControlModifier);
    ASSERT_TRUE(answer.done());
    EXPECT_TRUE(answer.question().contains("not saved")) << answer.question().toStdString();
    EXPECT_FALSE(window_.isVisible());
  }

  MainWindow tomorrow(realServices());
  ASSERT_NO_FATAL_FAILURE(open(tomorrow));
  {
    FileDialogTyping typing(folder_.filePath("day.toml"));
    press(tomorrow, Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(typing.done());
  }
  EXPECT_EQ(tomorrow.document().name(), "day");
  EXPECT_TRUE(sameCase(tomorrow.document().description(), edited));
  EXPECT_EQ(cases::caseHash(tomorrow.document().description()), cases::caseHash(edited));
  {
    FileDialogTyping typing(folder_.filePath("day.h5"));
    press(tomorrow, Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(typing.done());
  }
  ASSERT_TRUE(tomorrow.store().currentResult()) << tomorrow.messages()->text().toStdString();
  EXPECT_EQ(*tomorrow.store().currentResult()->signal("aba_filtered"), *computed->signal("aba_filtered"));
}

TEST_F(WorkingDay, aProfileIsImportedThroughItsPreview) {
  ASSERT_NO_FATAL_FAILURE(open(window_));
  QFile file(folder_.filePath("dip.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("position [mm];height [um]\n-20;0\n-10;-50,5\n0;-120\n10;-50,5\n20;0\n");
  file.close();
  {
    FileDialogTyping typing(file.fileName());
    click(*window_.findChild<QToolButton*>("importProfile"));
    ASSERT_TRUE(typing.done());
  }
  auto* dialog = window_.findChild<QDialog*>("importDialog");
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog));
  click(*dialog->findChild<QPushButton*>("takeProfile"));
  const auto& points = window_.document().description().defect.points;
  ASSERT_EQ(points.size(), 5u);
  EXPECT_NEAR(points[1].height, -50.5e-6, 1e-12);  // semicolons and decimal commas are found
  EXPECT_NEAR(points[2].position, 0, 1e-12);
  press(window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(window_.document().description().defect.points.size(), 5u);
}

}  // namespace
}  // namespace squat::studio
