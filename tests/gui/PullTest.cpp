// Pulling the curve of a defect with the mouse: handles of shapes, points that take along their neighbours.
#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QSettings>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <numbers>

#include "case/ParameterTable.h"
#include "plots/Style.h"
#include "scenario/DefectSurface.h"
#include "studio/document/CaseDocument.h"
#include "studio/profile/ProfileEditor.h"
#include "studio/profile/ProfileModel.h"
#include "studio/profile/ProfilePlot.h"
#include "studio/profile/ShapeHandles.h"

namespace squat::studio {
namespace {

// h(x) = -d / 2 (1 + cos(2 pi x / L)): the case that a newcomer meets, 50 mm long and 0.15 mm deep.
cases::CaseDescription cosineCase() {
  cases::CaseDescription description = cases::defaultCase();
  description.defect.shape = cases::DefectShape::cosine;
  description.defect.length = 0.05;
  description.defect.depth = 1.5e-4;
  return description;
}

TEST(ShapeHandles, ofACosineAreItsDeepestPointAndItsEnds) {
  const auto handles = shapeHandles(cosineCase());
  ASSERT_EQ(handles.size(), 3U);
  EXPECT_EQ(handles[0].key, "defect.depth");
  EXPECT_NEAR(handles[0].at.position, 0, 1e-4);
  EXPECT_NEAR(handles[0].at.height, -1.5e-4, 1e-9);
  EXPECT_NEAR(handles[0].rate, -1e-3, 1e-6);  // a millimetre deeper is a millimetre lower
  for (const int end : {1, 2}) {
    EXPECT_EQ(handles[end].key, "defect.length");
    EXPECT_FALSE(handles[end].isVertical);
    EXPECT_NEAR(handles[end].at.position, end == 1 ? -0.025 : 0.025, 1e-9);
    EXPECT_NEAR(handles[end].rate, end == 1 ? -5e-4 : 5e-4, 1e-6);  // half of the length at each end
  }
}

TEST(ShapeHandles, theCurveFollowsTheMouseWhereverItIsPulled) {
  const auto description = cosineCase();
  for (const double position : {0.0, 0.005, -0.0125, 0.018}) {
    const auto handle = handleOnCurve(description, position);
    ASSERT_TRUE(handle);
    const double aim = 1.4 * handle->at.height;
    const auto after = pulled(description, *handle, {position, aim});
    const double share = 0.5 * (1 + std::cos(2 * std::numbers::pi * position / 0.05));
    EXPECT_NEAR(after.defect.depth * share, -aim, 1e-3 * 1.5e-4) << position;  // four digits of the depth
  }
  EXPECT_FALSE(handleOnCurve(description, 0.03));  // smooth rail
}

TEST(ShapeHandles, aKeyStaysWithinWhatItAllows) {
  const auto description = cosineCase();
  const auto handles = shapeHandles(description);
  EXPECT_EQ(pulled(description, handles[0], {0, 1e-3}).defect.depth, 0);  // a squat is no hill
  EXPECT_GT(pulled(description, handles[2], {-1, 0}).defect.length, 0);
  EXPECT_NEAR(pulled(description, handles[2], {0.04, 0}).defect.length, 0.08, 1e-9);
}

TEST(ShapeHandles, everyShapeHasThem) {
  auto description = cosineCase();
  description.defect.shape = cases::DefectShape::cut;  // its floor is flat
  EXPECT_NEAR(shapeHandles(description)[0].at.position, 0, 2e-4);
  for (const auto shape : {cases::DefectShape::cut, cases::DefectShape::wshape, cases::DefectShape::dipWithWave}) {
    description.defect.shape = shape;
    EXPECT_EQ(shapeHandles(description).size(), 3U) << static_cast<int>(shape);
  }
  description.defect.shape = cases::DefectShape::none;
  EXPECT_TRUE(shapeHandles(description).empty());
  EXPECT_TRUE(shapeHandles(asPoints(cosineCase())).empty());
}

TEST(PulledPoints, takeAlongWhatIsNear) {
  std::vector<cases::ProfilePoint> points;
  for (int i = 0; i <= 20; ++i) points.push_back({1e-3 * i, 0});
  const auto after = pulledPoints(points, 10, {10e-3, -1e-4}, 8e-3);
  EXPECT_DOUBLE_EQ(after[10].height, -1e-4);
  EXPECT_NEAR(after[14].height, -0.5e-4, 1e-12);  // half of the radius away: half of the way
  EXPECT_NEAR(after[6].height, after[14].height, 1e-15);
  EXPECT_EQ(after[2].height, 0);
  EXPECT_EQ(after[18].height, 0);
  const auto one = pulledPoints(points, 10, {10e-3, -1e-4}, 0);
  EXPECT_EQ(one[9].height, 0);
  EXPECT_EQ(one[11].height, 0);
  const auto atEnd = pulledPoints(points, 1, {1e-3, -1e-4}, 8e-3);
  EXPECT_EQ(atEnd[0].height, 0);  // where it joins the smooth rail
}

class Pull : public testing::Test {
 protected:
  void SetUp() override {
    document_.startFrom(cosineCase(), QString(), "test", false);
    editor_.resize(900, 600);
    editor_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&editor_));
    plot().setPullRadius(0.01);
    plot().fit();
    plot().replot(QCustomPlot::rpImmediateRefresh);
  }
  void TearDown() override { QSettings().remove("profile/pullRadius"); }
  ProfilePlot& plot() { return *editor_.plot(); }
  const cases::Defect& defect() { return document_.description().defect; }
  QPointF location(double position, double height) { return plot().locationOf({position, height}); }
  void move(const QPointF& to, Qt::MouseButtons buttons = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, to, plot().mapToGlobal(to), Qt::NoButton, buttons, {});
    QApplication::sendEvent(&plot(), &event);
  }
  void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&plot(), Qt::LeftButton, modifiers, from.toPoint());
    constexpr int steps = 5;
    for (int i = 1; i <= steps; ++i) move(from + (to - from) * i / steps);
    QTest::mouseRelease(&plot(), Qt::LeftButton, modifiers, to.toPoint());
  }
  double heightOfPixel() { return std::abs(location(0, 1e-6).y() - location(0, 0).y()) * 1e6; }  // [pixels/m]
  CaseDocument document_;
  ProfileEditor editor_{document_, plots::lightStyle()};
};

TEST_F(Pull, theBottomMakesTheDefectDeeperInOneStep) {
  const QCPRange x = plot().xAxis->range(), y = plot().yAxis->range();
  drag(location(0, -1.5e-4), location(0, -1.65e-4));
  EXPECT_NEAR(defect().depth, 1.65e-4, 1.5 / heightOfPixel());  // a pixel and a half
  EXPECT_EQ(document_.undoStack().count(), 1);
  EXPECT_EQ(plot().xAxis->range(), x);  // nothing is zoomed, and the scale stays
  EXPECT_EQ(plot().yAxis->range(), y);
  document_.undoStack().undo();
  EXPECT_DOUBLE_EQ(defect().depth, 1.5e-4);
}

TEST_F(Pull, anEndMakesItLonger) {
  drag(location(0.025, 0), location(0.03, 0));
  EXPECT_NEAR(defect().length, 0.06, 5e-4);  // a pixel at each end
  EXPECT_DOUBLE_EQ(defect().depth, 1.5e-4);
}

TEST_F(Pull, beyondTheCurveTheViewMovesAndShiftDrawsABox) {
  const QCPRange x = plot().xAxis->range();
  const QPointF free = location(0.04, -1e-4);
  drag(free, free + QPointF(50, 0));
  EXPECT_LT(plot().xAxis->range().lower, x.lower);
  EXPECT_NEAR(plot().xAxis->range().size(), x.size(), 1e-9 * x.size());
  plot().fit();
  drag(free, free + QPointF(60, -60), Qt::ShiftModifier);
  EXPECT_LT(plot().xAxis->range().size(), 0.5 * x.size());
  EXPECT_EQ(document_.undoStack().count(), 0);
}

TEST_F(Pull, aDoubleClickMakesPointsOfTheShapeAndNothingElse) {
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, location(0.01, -3e-5).toPoint());  // off the curve
  ASSERT_EQ(defect().shape, cases::DefectShape::profile);
  for (const auto& point : defect().points) {
    const double height = -0.75e-4 * (1 + std::cos(2 * std::numbers::pi * point.position / 0.05));
    EXPECT_NEAR(point.height, height, 1e-9) << point.position;
  }
  const std::size_t before = defect().points.size();
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, location(0.0105, -3e-5).toPoint());
  ASSERT_EQ(defect().points.size(), before + 1);
  for (std::size_t i = 1; i < defect().points.size(); ++i) {  // on the curve: no step is steeper than the steepest
    const auto &one = defect().points[i - 1], &next = defect().points[i];
    const double steepest = 0.75e-4 * 2 * std::numbers::pi / 0.05;
    EXPECT_LE(std::abs(next.height - one.height), 1.01 * steepest * (next.position - one.position)) << i;
  }
}

TEST_F(Pull, pointsNearTheOneThatIsDraggedFollow) {
  document_.edit("points", asPoints(document_.description()));
  const auto before = defect().points;
  const QPointF from = plot().locationOf(before.size() / 2);
  QTest::mousePress(&plot(), Qt::LeftButton, {}, from.toPoint());
  move(from + QPointF(0, 20));
  move(from + QPointF(0, 40));
  const auto atTen = defect().points;
  const auto changed = [&](const std::vector<cases::ProfilePoint>& now) {
    int count = 0;
    for (std::size_t i = 0; i < now.size(); ++i) count += std::abs(now[i].height - before[i].height) > 1e-12;
    return count;
  };
  EXPECT_EQ(changed(atTen), 19);  // 9 mm to each side and itself, a millimetre apart
  QWheelEvent up(from + QPointF(0, 40), plot().mapToGlobal(from + QPointF(0, 40)), {}, QPoint(0, 120), Qt::LeftButton,
                 {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&plot(), &up);
  EXPECT_DOUBLE_EQ(plot().pullRadius(), 0.02);
  EXPECT_EQ(changed(defect().points), 39);
  // Back to where the drag began, whatever came between.
  move(from);
  EXPECT_LE(changed(defect().points), 39);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(defect().points[i].height, before[i].height, 1.0 / heightOfPixel()) << i;
  QTest::mouseRelease(&plot(), Qt::LeftButton, {}, from.toPoint());
  EXPECT_EQ(document_.undoStack().count(), 2);
}

// A file of settings may hold anything.
TEST_F(Pull, aRadiusThatIsNoneIsNotTaken) {
  for (const auto& [kept, taken] : {std::pair{"7", 0.04}, {"-1", 0.0}, {"x", 0.0}}) {
    QSettings().setValue("profile/pullRadius", kept);
    editor_.setStyle(plots::lightStyle());
    EXPECT_DOUBLE_EQ(plot().pullRadius(), taken) << kept;
  }
}

TEST_F(Pull, theCurveBetweenPointsTakesTheNearestOne) {
  document_.edit("points", asPoints(document_.description()));
  const auto before = defect().points;
  const double position = before[20].position + 0.3e-3;
  drag(location(position, heightOn(before, position)), location(position, heightOn(before, position) - 2e-5));
  EXPECT_NEAR(defect().points[20].height, before[20].height - 2e-5, 1.5 / heightOfPixel());
}

}  // namespace
}  // namespace squat::studio
