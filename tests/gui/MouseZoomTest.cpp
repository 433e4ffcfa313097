// Boxes that the mouse draws in a figure with two axes beside each other.
#include "studio/common/MouseZoom.h"

#include <gtest/gtest.h>

#include <QTest>

#include "plots/Figure.h"

namespace squat::studio {
namespace {

class TwoAxes : public testing::Test {
 protected:
  void SetUp() override {
    figure_.addAxesBeside();
    figure_.xAxis->setRange(0, 8), figure_.yAxis->setRange(0, 4);
    figure_.resize(900, 420);
    figure_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&figure_));
    figure_.replot(QCustomPlot::rpImmediateRefresh);
  }
  // From a quarter to three quarters of the axes, both ways.
  void drawBoxIn(int axes) {
    const QRect inside = figure_.axisRects().at(axes)->rect();
    const QPoint quarter(inside.width() / 4, inside.height() / 4);
    QTest::mousePress(&figure_, Qt::LeftButton, {}, inside.topLeft() + quarter);
    QTest::mouseMove(&figure_, inside.center());
    QTest::mouseMove(&figure_, inside.topLeft() + 3 * quarter);
    QTest::mouseRelease(&figure_, Qt::LeftButton, {}, inside.topLeft() + 3 * quarter);
  }

  plots::Figure figure_{"pair", plots::Style{}};
  MouseZoom* zoom_ = new MouseZoom(figure_);
};

TEST_F(TwoAxes, takeABoxInEitherOfThem) {
  for (const int axes : {1, 0}) {
    figure_.xAxis->setRange(0, 8), figure_.yAxis->setRange(0, 4);
    drawBoxIn(axes);
    // Within two pixels of some 350 and 300.
    for (const auto* each : figure_.axisRects()) {
      EXPECT_NEAR(each->axis(QCPAxis::atBottom)->range().lower, 2, 0.06) << axes;
      EXPECT_NEAR(each->axis(QCPAxis::atBottom)->range().upper, 6, 0.06) << axes;
      EXPECT_NEAR(each->axis(QCPAxis::atLeft)->range().lower, 1, 0.04) << axes;
      EXPECT_NEAR(each->axis(QCPAxis::atLeft)->range().upper, 3, 0.04) << axes;
    }
  }
}

TEST_F(TwoAxes, moveWithTheMiddleButtonInEitherOfThem) {
  const QPoint from = figure_.axisRects().at(1)->rect().center();
  const double before = figure_.axisRects().at(1)->axis(QCPAxis::atBottom)->pixelToCoord(from.x());
  QTest::mousePress(&figure_, Qt::MiddleButton, {}, from);
  QTest::mouseMove(&figure_, from + QPoint(40, 0));
  QTest::mouseRelease(&figure_, Qt::MiddleButton, {}, from + QPoint(40, 0));
  // What stood below the mouse has come along.
  EXPECT_NEAR(figure_.axisRects().at(1)->axis(QCPAxis::atBottom)->pixelToCoord(from.x() + 40), before, 1e-9);
}

}  // namespace
}  // namespace squat::studio
