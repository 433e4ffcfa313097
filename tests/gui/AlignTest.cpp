// A measured signal is laid along the track by hand: typed, dragged, and the same again in a project.
#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "studio/common/MessageBar.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/RunsPanel.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

class AlignByHand : public testing::Test {
 protected:
  // One strike of 70 m/s2 at 0.2 s, without a speed: 5000 samples a second, 30 m/s of the case.
  void SetUp() override {
    QFile file(folder_.filePath("measured.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("time [s],aba [m/s2]\n");
    for (int i = 0; i < 2000; ++i) {
      const double since = i / 5000.0 - 0.2;
      const double value = since < 0 ? 0 : 70 * std::exp(-80 * since) * std::cos(1900 * since);
      file.write(QByteArray::number(i / 5000.0) + ',' + QByteArray::number(value, 'g', 12) + '\n');
    }
    file.close();
    const auto result = std::make_shared<const results::RunResult>(tests::syntheticResult());
    window_.store().add({result, "run", QString(), false});
    window_.show();
    ASSERT_TRUE(window_.openMeasured(file.fileName())) << window_.messages()->text().toStdString();
    automatic_ = measured().reading.impact;
    QMenu menu;
    window_.findChild<RunsPanel*>()->fillMenu(menu, 1);
    menu.findChild<QAction*>("runAlign")->trigger();
    dialog_ = window_.findChild<AlignDialog*>();
    ASSERT_NE(dialog_, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog_));
  }
  const StoredRun& measured() { return window_.store().at(1); }
  QDoubleSpinBox* box(const char* name) const { return dialog_->findChild<QDoubleSpinBox*>(name); }
  // [m] of the largest value that is drawn.
  double placeOfPeak() {
    const auto& values = *measured().record->signal("aba_filtered");
    const auto at =
        std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    return measured().record->position[static_cast<std::size_t>(at - values.begin())];
  }
  // The signal in another window, after its project was saved and closed here.
  const StoredRun& backIn(MainWindow& other) {
    const QString path = folder_.filePath("day.squat-project");
    EXPECT_TRUE(window_.saveProjectTo(path)) << window_.messages()->text().toStdString();
    dialog_->close();
    EXPECT_TRUE(window_.closeProject());
    EXPECT_TRUE(other.openProject(path)) << other.messages()->text().toStdString();
    EXPECT_TRUE(other.reader()->waitFor(30000));
    EXPECT_TRUE(other.messages()->isEmpty()) << other.messages()->text().toStdString();
    return other.store().at(other.store().rowCount() - 1);
  }
  double spacing() { return measured().record->position[1] - measured().record->position[0]; }

  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
  double automatic_ = 0;
  AlignDialog* dialog_ = nullptr;
};

TEST_F(AlignByHand, typedNumbersLayItAnew) {
  EXPECT_NEAR(spacing(), 30.0 / 5000, 1e-12);
  const double peak =
      *std::max_element(measured().record->signal("aba")->begin(), measured().record->signal("aba")->end());
  box("alignPosition")->setValue(123.4);
  EXPECT_NEAR(placeOfPeak(), 0.1234, 1e-12);
  box("alignSpeed")->setValue(33);
  EXPECT_NEAR(spacing(), 33.0 / 5000, 1e-12);
  EXPECT_NEAR(placeOfPeak(), 0.1234, 1e-12);  // about the strike
  box("alignGain")->setValue(1.5);
  const auto& values = *measured().record->signal("aba");
  EXPECT_NEAR(*std::max_element(values.begin(), values.end()), 1.5 * peak, 1e-9 * peak);
  // Said where it is drawn.
  const auto* figure = window_.signalsPanel()->view("aba_position")->figure();
  bool said = false;
  for (int i = 0; i < figure->graphCount(); ++i) said = said || figure->graph(i)->name().contains("measured × 1.5");
  EXPECT_TRUE(said);
  dialog_->findChild<QPushButton*>("alignAutomatic")->click();
  EXPECT_NEAR(placeOfPeak(), automatic_, 1e-12);
  EXPECT_EQ(measured().reading.gain, 1);
  EXPECT_NEAR(spacing(), 30.0 / 5000, 1e-12);
}

// The shown run gives way to one whose impact lies 30 mm farther on: a signal that was laid automatically follows it,
// one that was laid by hand stays.
TEST_F(AlignByHand, anotherRunTakesTheSignalAlongUnlessItWasLaidByHand) {
  const auto showMoved = [&](double metres) {
    auto result = tests::syntheticResult();
    for (double& position : result.position) position += metres;
    window_.store().add({std::make_shared<const results::RunResult>(result), "moved", QString(), false});
  };
  showMoved(0.02);
  EXPECT_NEAR(placeOfPeak(), automatic_, 1e-12) << "not while it is aligned by hand";
  box("alignGain")->setValue(1.5);
  EXPECT_TRUE(measured().reading.isAutomatic) << "a gain moves nothing";
  dialog_->close();
  EXPECT_NEAR(placeOfPeak(), automatic_ + 0.02, 1e-4) << "once the hand is off";
  EXPECT_TRUE(tests::passes([&] { return !window_.findChild<AlignDialog*>(); }));
  showMoved(0.03);
  EXPECT_NEAR(placeOfPeak(), automatic_ + 0.03, 1e-4);
  EXPECT_NEAR(measured().reading.impact, automatic_ + 0.03, 1e-4);
  // A run that was stopped takes nothing along.
  auto stopped = tests::syntheticResult();
  for (double& position : stopped.position) position -= 0.04;
  stopped.complete = false;
  window_.store().add({std::make_shared<const results::RunResult>(stopped), "stopped", QString(), false});
  EXPECT_NEAR(placeOfPeak(), automatic_ + 0.03, 1e-4);
  QMenu menu;
  window_.findChild<RunsPanel*>()->fillMenu(menu, 1);
  menu.findChild<QAction*>("runAlign")->trigger();
  dialog_ = window_.findChild<AlignDialog*>();
  box("alignPosition")->setValue(123.4);
  EXPECT_FALSE(measured().reading.isAutomatic);
  dialog_->close();
  showMoved(-0.05);
  EXPECT_NEAR(placeOfPeak(), 0.1234, 1e-12);
}

TEST_F(AlignByHand, followingARunComesBackInAProject) {
  const auto laid = measured().record;
  MainWindow tomorrow(tests::services());
  const StoredRun& again = backIn(tomorrow);
  EXPECT_TRUE(again.reading.isAutomatic);
  EXPECT_EQ(again.record->position, laid->position);  // to the last bit
}

// Return enters what is typed; it presses no button.
TEST_F(AlignByHand, aNumberIsTypedWithReturn) {
  tests::click(*box("alignGain"));
  tests::press(*dialog_, Qt::Key_A, Qt::ControlModifier);
  tests::type(*dialog_, "1.25");
  tests::press(*dialog_, Qt::Key_Return);
  EXPECT_EQ(measured().reading.gain, 1.25);
  EXPECT_TRUE(dialog_->isVisible());
  box("alignPosition")->setValue(-77);
  EXPECT_EQ(measured().reading.gain, 1.25);
}

// What cannot be read any more stays as it was, and is said.
TEST_F(AlignByHand, aFileThatIsGoneChangesNothing) {
  const auto laid = measured().record->position;
  ASSERT_TRUE(QFile::remove(folder_.filePath("measured.csv")));
  box("alignGain")->setValue(2);
  EXPECT_EQ(measured().record->position, laid);
  EXPECT_EQ(measured().reading.gain, 1);
  EXPECT_EQ(box("alignGain")->value(), 1);
  bool said = false;
  for (const auto* label : dialog_->findChildren<QLabel*>())
    said = said || (label->isVisible() && label->text().contains("measured.csv"));
  EXPECT_TRUE(said);
  dialog_->shift(0.02, false);
  dialog_->shift(0.02, true);
  EXPECT_EQ(measured().record->position, laid);
}

TEST_F(AlignByHand, isDraggedAlongTheTrack) {
  FigureView* view = window_.signalsPanel()->view("aba_position");
  ASSERT_TRUE(view->isVisible());
  const QCPRange before = view->figure()->xAxis->range();
  const QRect room = view->figure()->axisRect()->rect();
  const QPoint from(room.center()), to = from + QPoint(40, 0);
  const double expected = 40e-3 * before.size() / room.width();  // [m] of 40 pixels
  tests::drag(*view, from, to);
  EXPECT_NEAR(placeOfPeak(), automatic_ + expected, 2e-3 * before.size() / room.width());
  EXPECT_NEAR(box("alignPosition")->value() * 1e-3, placeOfPeak(), 1e-4);
  EXPECT_NEAR(measured().reading.impact, placeOfPeak(), 1e-12);
  // Without the dialog a drag moves the view again, and the signal stays.
  const double laid = placeOfPeak();
  dialog_->close();
  const QCPRange shown = view->figure()->xAxis->range();
  tests::drag(*view->figure(), from, to);
  EXPECT_NE(view->figure()->xAxis->range(), shown);
  EXPECT_EQ(placeOfPeak(), laid);
}

TEST_F(AlignByHand, comesBackInAProject) {
  box("alignPosition")->setValue(-50);
  box("alignSpeed")->setValue(31.25);
  box("alignGain")->setValue(0.8);
  const auto laid = measured().record;
  MainWindow tomorrow(tests::services());
  const StoredRun& again = backIn(tomorrow);
  ASSERT_TRUE(again.isMeasured());
  EXPECT_EQ(again.record->position, laid->position);  // to the last bit
  EXPECT_EQ(*again.record->signal("aba"), *laid->signal("aba"));
  EXPECT_EQ(again.reading.gain, 0.8);
}

// Whatever was typed and dragged in it.
TEST_F(AlignByHand, aDialogIsOneStepToUndo) {
  const auto before = measured().record;
  QUndoStack& stack = window_.document().undoStack();
  box("alignPosition")->setValue(50);
  box("alignPosition")->setValue(123.4);
  box("alignGain")->setValue(1.5);
  EXPECT_EQ(stack.count(), 0);
  dialog_->close();
  ASSERT_EQ(stack.count(), 1);
  EXPECT_EQ(stack.undoText(), "alignment of “" + measured().label + "”");
  EXPECT_FALSE(window_.document().isModified()) << "it is no change of the case";
  window_.findChild<QAction*>("undo")->trigger();
  EXPECT_EQ(measured().record, before);
  EXPECT_TRUE(measured().reading.isAutomatic);
  EXPECT_EQ(measured().reading.gain, 1);
  window_.findChild<QAction*>("redo")->trigger();
  EXPECT_NEAR(placeOfPeak(), 0.1234, 1e-12);
  EXPECT_EQ(measured().reading.gain, 1.5);
  EXPECT_FALSE(measured().reading.isAutomatic);
}

TEST_F(AlignByHand, aDialogThatChangesNothingIsNoStep) {
  box("alignPosition")->setValue(123.4);
  dialog_->findChild<QPushButton*>("alignBack")->click();
  dialog_->close();
  EXPECT_EQ(window_.document().undoStack().count(), 0);
}

// The signal has followed another run since, and stays with it; a step takes back what it has changed.
TEST_F(AlignByHand, aStepTakesBackWhatItHasChanged) {
  box("alignGain")->setValue(1.5);
  dialog_->close();
  EXPECT_TRUE(tests::passes([&] { return !window_.findChild<AlignDialog*>(); }));
  auto moved = tests::syntheticResult();
  for (double& position : moved.position) position += 0.03;
  window_.store().add({std::make_shared<const results::RunResult>(moved), "moved", QString(), false});
  ASSERT_NEAR(placeOfPeak(), automatic_ + 0.03, 1e-4);
  window_.document().undoStack().undo();
  EXPECT_EQ(measured().reading.gain, 1);
  EXPECT_NEAR(placeOfPeak(), automatic_ + 0.03, 1e-4);
  window_.document().undoStack().redo();
  EXPECT_EQ(measured().reading.gain, 1.5);
  EXPECT_NEAR(placeOfPeak(), automatic_ + 0.03, 1e-4);
}

// The run before it is removed: it stands in another row. Removed itself, nothing is left to be laid.
TEST_F(AlignByHand, aStepIsOfItsSignalWhereverItStands) {
  box("alignPosition")->setValue(123.4);
  dialog_->close();
  QUndoStack& stack = window_.document().undoStack();
  window_.store().remove(0);
  stack.undo();
  EXPECT_NEAR(window_.store().at(0).reading.impact, automatic_, 1e-12);
  window_.store().putAside(0);
  stack.redo();
  stack.undo();
  EXPECT_EQ(window_.store().rowCount(), 0);
  stack.redo();
  ASSERT_EQ(window_.store().restore(), 0);
  stack.undo();  // it lies as before already
  EXPECT_NEAR(window_.store().at(0).reading.impact, automatic_, 1e-12);
  stack.redo();
  EXPECT_NEAR(window_.store().at(0).reading.impact, 0.1234, 1e-12);
}

// What the next dialog would change lies otherwise then.
TEST_F(AlignByHand, aStepThatIsUndoneEndsTheNextDialog) {
  box("alignPosition")->setValue(123.4);
  dialog_->close();
  EXPECT_TRUE(tests::passes([&] { return !window_.findChild<AlignDialog*>(); }));
  QMenu menu;
  window_.findChild<RunsPanel*>()->fillMenu(menu, 1);
  menu.findChild<QAction*>("runAlign")->trigger();
  ASSERT_NE(window_.findChild<AlignDialog*>(), nullptr);
  window_.document().undoStack().undo();
  EXPECT_TRUE(tests::passes([&] { return !window_.findChild<AlignDialog*>(); }));
  EXPECT_NEAR(placeOfPeak(), automatic_, 1e-12);
}

TEST_F(AlignByHand, aSignalThatIsRemovedEndsIt) {
  window_.store().remove(1);
  EXPECT_TRUE(tests::passes([&] { return !window_.findChild<AlignDialog*>(); }));
}

}  // namespace
}  // namespace squat::studio
