// Names in legends hide and show their curves; nothing hidden is lost from files.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QTest>

#include "plots/FigureFiles.h"
#include "plots/LineFigure.h"
#include "render/SyntheticResult.h"
#include "studio/common/Theme.h"
#include "studio/common/Words.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/FigureTable.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"

namespace squat::studio {
namespace {

class Legend : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(640, 520);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    store_.add({tests::sharedSyntheticResult(), "run", {}, false});
    panel_.showTab("aba_position");
    figure()->replot(QCustomPlot::rpImmediateRefresh);
    ASSERT_EQ(entry(0), "axle_box");
    ASSERT_EQ(entry(1), "wheel_centre");
  }
  plots::Figure* figure() const { return panel_.view("aba_position")->figure(); }
  QString entry(int index) const {
    const auto* curve = figure()->curveOfEntry(index);
    return curve ? machineName(curve->name()) : QString();
  }
  bool isSeen(int index) const { return figure()->curveOfEntry(index)->visible(); }
  QRect place(int index) const { return figure()->legend->item(index)->rect(); }
  void clickEntry(int index) const {
    figure()->replot(QCustomPlot::rpImmediateRefresh);  // laid out for the window
    QTest::mouseClick(figure(), Qt::LeftButton, {}, place(index).center());
    figure()->replot(QCustomPlot::rpImmediateRefresh);
  }
  int seenMarks() const {
    int marks = 0;
    for (int i = 0; i < figure()->itemCount(); ++i)
      marks += qobject_cast<QCPItemTracer*>(figure()->item(i)) && figure()->item(i)->visible();
    return marks;
  }

  RunStore store_;
  SignalsPanel panel_{store_, figureStyle(false)};
};

TEST_F(Legend, aClickHidesACurveAndShowsItAgain) {
  const QRect before[] = {place(0), place(1)};
  clickEntry(1);
  EXPECT_TRUE(isSeen(0));
  EXPECT_FALSE(isSeen(1));
  for (const int index : {0, 1}) EXPECT_EQ(place(index), before[index]) << index;  // nothing moves under the mouse
  clickEntry(1);
  EXPECT_TRUE(isSeen(1));
  QTest::mouseClick(figure(), Qt::LeftButton, {}, figure()->axisRect()->rect().center());  // elsewhere
  EXPECT_TRUE(isSeen(0) && isSeen(1));
}

TEST_F(Legend, digitsDoTheSame) {
  QTest::keyClick(figure(), Qt::Key_2);
  EXPECT_TRUE(isSeen(0));
  EXPECT_FALSE(isSeen(1));
  QTest::keyClick(figure(), Qt::Key_2);
  EXPECT_TRUE(isSeen(1));
  QTest::keyClick(figure(), Qt::Key_9);  // there is no such entry
  EXPECT_TRUE(isSeen(0) && isSeen(1));
}

// Rings and numbers at the extremes of a curve that is not seen would stand on nothing: both are of the axle box.
TEST_F(Legend, marksGoWithTheirCurve) {
  EXPECT_EQ(seenMarks(), 2);
  clickEntry(1);
  EXPECT_EQ(seenMarks(), 2);
  clickEntry(0);
  EXPECT_EQ(seenMarks(), 0);
  clickEntry(0);
  EXPECT_EQ(seenMarks(), 2);
}

// The figure is drawn again with another filter; the extremes in the names change.
TEST_F(Legend, whatIsHiddenStaysHidden) {
  const QString name = figure()->curveOfEntry(0)->name();
  clickEntry(0);
  panel_.findChild<QDoubleSpinBox*>("cutoff")->setValue(100);  // below the lines of the made-up run
  ASSERT_NE(figure()->curveOfEntry(0)->name(), name);
  ASSERT_EQ(entry(0), "axle_box");
  EXPECT_FALSE(isSeen(0));
  EXPECT_TRUE(isSeen(1));
  EXPECT_EQ(seenMarks(), 0);
}

// In pictures its name stands dimmed: 0.35 of 20 and 0.65 of 255 are 173, 0xad. Tables hold every curve.
TEST_F(Legend, filesSayWhatIsHidden) {
  const QString colour = figure()->style().curve(1).name();
  const auto drawn = [&] { return QString::fromUtf8(plots::toSvg(*figure())); };
  EXPECT_TRUE(drawn().contains(colour));
  EXPECT_FALSE(drawn().contains("#adadad"));
  clickEntry(1);
  EXPECT_FALSE(drawn().contains(colour));
  EXPECT_TRUE(drawn().contains("#adadad"));
  EXPECT_TRUE(drawn().contains("wheel centre"));
  EXPECT_TRUE(figureTable(*figure()).contains("\nwheel_centre,"));
}

// The lower and the upper bound of a range, one of them named.
TEST(LegendOfAFigure, curvesWithoutANameGoWithThoseOfTheirPen) {
  plots::Figure figure("bounds", plots::lightStyle());
  const QCPGraph* lower = plots::addCurve(figure, {{0, 1}, {0, 1}, "90 %", 2});
  const QCPGraph* upper = plots::addCurve(figure, {{0, 1}, {1, 2}, {}, 2});
  const QCPGraph* other = plots::addCurve(figure, {{0, 1}, {2, 3}, {}, 1});
  ASSERT_TRUE(figure.toggleCurve(0));
  EXPECT_FALSE(lower->visible());
  EXPECT_FALSE(upper->visible());
  EXPECT_TRUE(other->visible());
  EXPECT_FALSE(figure.toggleCurve(1));  // it has no entry
  ASSERT_TRUE(figure.toggleCurve(0));
  EXPECT_TRUE(lower->visible() && upper->visible());
}

}  // namespace
}  // namespace squat::studio
