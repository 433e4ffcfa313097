// The profile editor, driven by mouse and keys.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <optional>

#include "case/ParameterTable.h"
#include "gui/EditorOfProfile.h"
#include "gui/Hands.h"
#include "scenario/DefectSurface.h"
#include "studio/profile/ProfileModel.h"
#include "studio/profile/ProfilePlot.h"

namespace squat::studio {
namespace {

class Editor : public tests::EditorOfProfile {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(openFivePoints(cases::ModelExtent::half));
    editor_.plot()->fit();
    editor_.plot()->replot(QCustomPlot::rpImmediateRefresh);
  }
  const std::vector<cases::ProfilePoint>& points() { return document_.description().defect.points; }
  QPoint location(std::size_t index) { return editor_.plot()->locationOf(index).toPoint(); }
  // The point that is chosen in the plot and the row that is selected in the table; -1: none; -2: they differ.
  int chosen() {
    const auto point = editor_.plot()->chosen();
    const auto rows = editor_.table()->selectionModel()->selectedRows();
    if (!point && !editor_.table()->selectionModel()->hasSelection()) return -1;
    return point && rows.size() == 1 && rows[0].row() == static_cast<int>(*point) ? rows[0].row() : -2;
  }
  // From one place of the axes to another, as shares of their width and height from the upper left corner.
  void drag(Qt::MouseButton button, QPointF from, QPointF to, Qt::KeyboardModifiers modifiers = {}) {
    ProfilePlot& plot = *editor_.plot();
    const QRect room = plot.axisRect()->rect();
    const auto place = [&](QPointF share) {
      return QPoint(room.left() + qRound(share.x() * room.width()), room.top() + qRound(share.y() * room.height()));
    };
    QTest::mousePress(&plot, button, modifiers, place(from));
    QMouseEvent move(QEvent::MouseMove, place(to), plot.mapToGlobal(place(to)), Qt::NoButton, button, {});
    QApplication::sendEvent(&plot, &move);
    QTest::mouseRelease(&plot, button, modifiers, place(to));
  }
  // A table of another profile with as many points.
  void import() {
    QTemporaryDir folder;
    QFile file(folder.filePath("dip.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("x [mm];z [um]\n-40;0\n-20;-30\n0;-90\n20;-30\n40;0\n");
    file.close();
    editor_.importFile(file.fileName());
    auto* dialog = editor_.findChild<QDialog*>("importDialog");
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QPushButton*>("takeProfile")->click();
    ASSERT_NEAR(points()[2].height, -9e-5, 1e-12);
  }
};

TEST_F(Editor, draggingMovesAPointInOneStep) {
  const QPoint from = location(1);
  QTest::mousePress(editor_.plot(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(editor_.plot(), from + QPoint(0, 6 * i));
  QTest::mouseRelease(editor_.plot(), Qt::LeftButton, {}, from + QPoint(0, 30));
  EXPECT_LT(points()[1].height, -6e-5);
  EXPECT_EQ(document_.undoStack().count(), 1);
  document_.undoStack().undo();
  EXPECT_DOUBLE_EQ(points()[1].height, -5e-5);
}

TEST_F(Editor, aPointCannotPassItsNeighbour) {
  const QPoint from = location(1);
  QTest::mousePress(editor_.plot(), Qt::LeftButton, {}, from);
  QTest::mouseMove(editor_.plot(), from + QPoint(4000, 0));
  QTest::mouseRelease(editor_.plot(), Qt::LeftButton, {}, from);
  for (std::size_t i = 1; i < points().size(); ++i) EXPECT_GT(points()[i].position, points()[i - 1].position);
}

// Where these drags begin there is no point.
TEST_F(Editor, theLeftButtonEnlargesABoxWithShiftAndTheMiddleOneMovesTheView) {
  const ProfilePlot& plot = *editor_.plot();
  const QCPRange x = plot.xAxis->range(), y = plot.yAxis->range();
  drag(Qt::MiddleButton, {0.5, 0.3}, {0.7, 0.4});
  EXPECT_NEAR(plot.xAxis->range().lower, x.lower - 0.2 * x.size(), tests::pixel * x.size());
  EXPECT_NEAR(plot.xAxis->range().size(), x.size(), 1e-9 * x.size());
  EXPECT_NEAR(plot.yAxis->range().lower, y.lower + 0.1 * y.size(), tests::pixel * y.size());
  editor_.plot()->fit();
  drag(Qt::LeftButton, {0.1, 0.3}, {0.4, 0.8}, Qt::ShiftModifier);
  EXPECT_NEAR(plot.xAxis->range().lower, x.lower + 0.1 * x.size(), tests::pixel * x.size());
  EXPECT_NEAR(plot.xAxis->range().upper, x.lower + 0.4 * x.size(), tests::pixel * x.size());
  EXPECT_NEAR(plot.yAxis->range().upper, y.upper - 0.3 * y.size(), tests::pixel * y.size());
  EXPECT_NEAR(plot.yAxis->range().lower, y.upper - 0.8 * y.size(), tests::pixel * y.size());
  EXPECT_EQ(document_.undoStack().count(), 0);
}

// The button that moves the view neither ends the drag of a point nor moves anything beside it.
TEST_F(Editor, aPointThatIsDraggedHasTheMouseForItself) {
  ProfilePlot& plot = *editor_.plot();
  const QCPRange x = plot.xAxis->range(), y = plot.yAxis->range();
  const QPoint from = location(1), to = from + QPoint(0, 30), further = from + QPoint(0, 60);
  const auto move = [&](const QPoint& place) {
    QMouseEvent event(QEvent::MouseMove, place, plot.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&plot, &event);
  };
  QTest::mousePress(&plot, Qt::LeftButton, {}, from);
  move(to);
  QTest::mousePress(&plot, Qt::MiddleButton, {}, to);
  QTest::mouseRelease(&plot, Qt::MiddleButton, {}, to);
  const double before = points()[1].height;
  EXPECT_LT(before, -6e-5);
  move(further);
  EXPECT_LT(points()[1].height, before);
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, further);
  EXPECT_EQ(plot.xAxis->range(), x);
  EXPECT_EQ(plot.yAxis->range(), y);
  EXPECT_EQ(document_.undoStack().count(), 1);
}

TEST_F(Editor, theChosenPointStaysWhileSinglePointsChange) {
  editor_.plot()->choose(2);
  ASSERT_EQ(chosen(), 2);
  auto* model = editor_.table()->model();
  EXPECT_TRUE(model->setData(model->index(2, 1), "-120"));
  EXPECT_EQ(chosen(), 2);
  document_.undoStack().undo();
  EXPECT_EQ(chosen(), 2);
  document_.undoStack().redo();
  EXPECT_EQ(chosen(), 2);
  // A point before it comes and goes: it is the same point under another number.
  auto more = document_.description();
  more.defect.points.insert(more.defect.points.begin() + 1, {-0.03, -1e-5});
  document_.edit("insert", more);
  QTest::qWait(20);  // the table lays out its rows first
  EXPECT_EQ(chosen(), 3);
  document_.undoStack().undo();
  QTest::qWait(20);
  EXPECT_EQ(chosen(), 2);
  document_.setParameter("defect.height_scale", "2");  // the same points, shown twice as deep
  EXPECT_EQ(chosen(), 2);
}

// Delete after delete removes one point after the other, as before; a point whose making is undone is not chosen.
TEST_F(Editor, aPointThatGoesIsNotChosen) {
  editor_.plot()->choose(1);
  QTest::keyClick(editor_.plot(), Qt::Key_Delete);
  QTest::qWait(20);
  EXPECT_EQ(chosen(), 1);
  QTest::keyClick(editor_.plot(), Qt::Key_Delete);
  ASSERT_EQ(points().size(), 3u);
  EXPECT_DOUBLE_EQ(points()[1].position, 0.02);
  auto more = document_.description();
  more.defect.points.insert(more.defect.points.begin() + 1, {-0.03, -1e-5});
  document_.edit("insert", more);
  editor_.plot()->choose(1);
  document_.undoStack().undo();
  QTest::qWait(20);
  EXPECT_EQ(chosen(), -1);
}

// Point 3 of another profile is another point, although it has the same number.
TEST_F(Editor, noPointIsChosenInAProfileThatReplacesAnother) {
  editor_.plot()->choose(2);
  ASSERT_EQ(chosen(), 2);
  ASSERT_NO_FATAL_FAILURE(import());
  EXPECT_EQ(chosen(), -1);
  editor_.plot()->choose(1);
  document_.undoStack().undo();
  EXPECT_EQ(chosen(), -1);

  editor_.plot()->choose(2);
  editor_.findChild<QToolButton*>("chooseSquat")->click();
  auto* dialog = editor_.findChild<QDialog*>("squatDialog");
  ASSERT_NE(dialog, nullptr);
  dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  ASSERT_NE(document_.description().defect.shape, cases::DefectShape::profile);
  editor_.findChild<QToolButton*>("toPoints")->click();
  QTest::qWait(20);
  EXPECT_EQ(chosen(), -1);

  editor_.plot()->choose(2);
  document_.startFrom(document_.description(), QString(), "the same once more", false);
  EXPECT_EQ(chosen(), -1);
}

// What the user reads is the depth, 150 um, in both units: not 150.001. The point that results count from is one.
TEST_F(Editor, pointsOfAShapeShowItsDepth) {
  auto* unit = editor_.findChild<QComboBox*>("heightUnit");
  for (const char* shape : {"cosine", "cut", "w-shape", "dip-with-wave"}) {
    SCOPED_TRACE(shape);
    document_.startFrom(cases::defaultCase(), QString(), "test", false);
    document_.setParameter("defect.shape", shape);
    document_.setParameter("defect.depth", "0.15");
    editor_.findChild<QToolButton*>("toPoints")->click();
    const auto deepest = std::min_element(points().begin(), points().end(),
                                          [](const auto& a, const auto& b) { return a.height < b.height; });
    EXPECT_EQ(deepest->position, 0);
    const auto* model = editor_.table()->model();
    const auto read = [&](int row) { return model->data(model->index(row, 1)).toString(); };
    const int row = static_cast<int>(deepest - points().begin());
    unit->setCurrentIndex(1);
    EXPECT_EQ(read(row), "-0.15");
    unit->setCurrentIndex(0);
    EXPECT_EQ(read(row), "-150");
    for (int each = 0; each < model->rowCount(); ++each) EXPECT_GE(read(each).toDouble(), -150) << each;
    for (const double scale : {1.0, 0.3, 0.7, 3.0, 7.0}) {  // rounding of the product may not make it one of several
      const auto asDeep = [&](const auto& each) { return each.height * scale <= deepest->height * scale; };
      EXPECT_EQ(std::count_if(points().begin(), points().end(), asDeep), 1) << scale;
    }
    EXPECT_EQ(profileView(document_.description()).shift, 0);
  }
}

TEST_F(Editor, aMeasureTakesADecimalComma) {
  document_.setParameter("defect.shape", "cosine");
  auto* number = editor_.findChild<QDoubleSpinBox*>("number defect.depth");
  ASSERT_TRUE(number && number->isVisible());
  number->selectAll();
  QTest::keyClicks(number, "0,25");
  EXPECT_EQ(number->cleanText(), "0.25");
  number->interpretText();
  EXPECT_NEAR(document_.description().defect.depth, 0.25e-3, 1e-12);
}

TEST_F(Editor, doubleClickInsertsAndDeleteRemoves) {
  const QPoint between = (location(1) + location(2)) / 2 + QPoint(0, -60);
  QTest::mouseDClick(editor_.plot(), Qt::LeftButton, {}, between);
  ASSERT_EQ(points().size(), 6u);
  EXPECT_NEAR(points()[2].position, -0.01, 1e-3);  // half-way, within a pixel or two
  editor_.plot()->choose(2);
  QTest::keyClick(editor_.plot(), Qt::Key_Delete);
  EXPECT_EQ(points().size(), 5u);
}

// Halfway between both, in position and in height; the point behind the last one would be beyond the profile.
TEST_F(Editor, insertAddsAPointHalfwayToTheNext) {
  ProfilePlot& plot = *editor_.plot();
  plot.choose(1);
  QTest::keyClick(&plot, Qt::Key_Insert);
  QTest::qWait(20);  // the table lays out its rows first
  ASSERT_EQ(points().size(), 6u);
  EXPECT_NEAR(points()[2].position, -0.01, 1e-12);
  EXPECT_NEAR(points()[2].height, -1e-4, 1e-12);
  EXPECT_EQ(chosen(), 2);
  QTest::keyClick(&plot, Qt::Key_Insert);
  EXPECT_NEAR(points()[3].position, -0.005, 1e-12);
  plot.choose(6);
  QTest::keyClick(&plot, Qt::Key_Insert);
  ASSERT_EQ(points().size(), 8u);
  EXPECT_NEAR(points()[6].position, 0.03, 1e-12);
  EXPECT_NEAR(points()[6].height, -2.5e-5, 1e-12);
  document_.undoStack().undo();
  EXPECT_EQ(points().size(), 7u);
}

TEST_F(Editor, insertAndDeleteInTheTable) {
  QTableView& table = *editor_.table();
  table.setFocus();
  table.setCurrentIndex(table.model()->index(1, 1));
  QTest::keyClick(&table, Qt::Key_Insert);
  QTest::qWait(20);
  ASSERT_EQ(points().size(), 6u);
  EXPECT_NEAR(points()[2].position, -0.01, 1e-12);
  EXPECT_EQ(table.currentIndex().row(), 2);
  QTest::keyClick(&table, Qt::Key_Delete);
  EXPECT_EQ(points().size(), 5u);
  EXPECT_NEAR(points()[2].position, 0, 1e-12);
}

// Arrows move a point that is chosen, else the view, by a tenth of its range.
TEST_F(Editor, escapeGivesTheArrowsBackToTheView) {
  ProfilePlot& plot = *editor_.plot();
  const QCPRange x = plot.xAxis->range();
  plot.choose(2);
  QTest::keyClick(&plot, Qt::Key_Up);
  EXPECT_NEAR(points()[2].height, -1.49e-4, 1e-12);  // a micrometre without snapping
  EXPECT_EQ(plot.xAxis->range(), x);
  QTest::keyClick(&plot, Qt::Key_Escape);
  EXPECT_EQ(chosen(), -1);
  QTest::keyClick(&plot, Qt::Key_Left);
  EXPECT_NEAR(plot.xAxis->range().lower, x.lower - 0.1 * x.size(), 1e-9);
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_NEAR(plot.xAxis->range().lower, x.lower, 1e-9);
}

TEST_F(Editor, snappingAndArrowKeys) {
  editor_.plot()->setSnap(1e-3, 5e-6);
  editor_.plot()->choose(2);
  QTest::keyClick(editor_.plot(), Qt::Key_Up);
  EXPECT_NEAR(points()[2].height, -1.45e-4, 1e-12);
  QTest::keyClick(editor_.plot(), Qt::Key_Right);
  EXPECT_NEAR(points()[2].position, 1e-3, 1e-12);
}

TEST_F(Editor, theTableShowsAndTakesNumbers) {
  auto* model = editor_.table()->model();
  ASSERT_EQ(model->rowCount(), 5);
  EXPECT_EQ(model->data(model->index(2, 1)).toString(), "-150");
  EXPECT_TRUE(model->setData(model->index(2, 1), "-120,5"));  // decimal comma
  EXPECT_NEAR(points()[2].height, -1.205e-4, 1e-12);
  EXPECT_FALSE(model->setData(model->index(2, 0), "900"));  // beyond its neighbour
  EXPECT_FALSE(model->setData(model->index(2, 1), "deep"));
}

TEST_F(Editor, slidersDriveAnalyticShapes) {
  document_.setParameter("defect.shape", "cosine");
  auto* slider = editor_.findChild<QSlider*>("slider defect.depth");
  ASSERT_TRUE(slider && slider->isVisible());
  const double before = document_.description().defect.depth;
  slider->setFocus();
  for (int i = 0; i < 20; ++i) QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_GT(document_.description().defect.depth, before);
  EXPECT_FALSE(editor_.findChild<QSlider*>("slider defect.ramp")->isVisible());
}

// Twice the heights: points, table and curve show what is run, and what is typed or dragged there becomes so.
TEST_F(Editor, pointsTableAndCurveAgreeWithAHeightScale) {
  document_.setParameter("defect.height_scale", "2");
  auto* model = editor_.table()->model();
  EXPECT_EQ(model->data(model->index(2, 1)).toString(), "-300");
  const ProfileView view = profileView(document_.description());
  const auto under = [&](double position) {
    return std::min_element(view.surface.begin(), view.surface.end(),
                            [&](const auto& a, const auto& b) {
                              return std::abs(a.position - position) < std::abs(b.position - position);
                            })
        ->height;
  };
  // The next sample of the curve is 0.055 mm away at most, its slope at most three times that of the steepest chord,
  // 3 x 200 um in 20 mm: 1.7 um.
  for (const auto& handle : view.handles) EXPECT_NEAR(handle.height, under(handle.position), 1.7e-6) << handle.position;
  EXPECT_TRUE(model->setData(model->index(2, 1), "-200"));
  EXPECT_NEAR(points()[2].height, -1e-4, 1e-12);
  QTest::qWait(30);  // the notes below the plot take some of its height
  editor_.plot()->replot(QCustomPlot::rpImmediateRefresh);
  const QPoint to = location(1) + QPoint(0, 30);
  QTest::mousePress(editor_.plot(), Qt::LeftButton, {}, location(1));
  QTest::mouseMove(editor_.plot(), to);
  QTest::mouseRelease(editor_.plot(), Qt::LeftButton, {}, to);
  EXPECT_NEAR(location(1).y(), to.y(), 1);  // it stays under the mouse
  auto* notes = editor_.findChild<QLabel*>("profileNotes");
  EXPECT_TRUE(notes->text().contains("height_scale = 2")) << notes->text().toStdString();
}

// 10 um at the first point and 30 um at the last: levelling tilts what was drawn, and says so.
TEST_F(Editor, levellingIsSaid) {
  auto* notes = editor_.findChild<QLabel*>("profileNotes");
  EXPECT_FALSE(notes->text().contains("Levelling")) << notes->text().toStdString();
  auto tilted = document_.description();
  tilted.defect.points.front().height = 1e-5, tilted.defect.points.back().height = 3e-5;
  document_.edit("tilt", tilted);
  for (const char* word : {"Levelling removes", "10.0 µm", "30.0 µm"})
    EXPECT_TRUE(notes->text().contains(word)) << notes->text().toStdString();
  tilted.defect.level = false;
  document_.edit("as drawn", tilted);
  EXPECT_FALSE(notes->text().contains("Levelling")) << notes->text().toStdString();
}

// Results count from the deepest point, the profile from where it was measured: one label would name two zeros.
TEST_F(Editor, positionsSayWhatTheyCountFrom) {
  EXPECT_EQ(editor_.plot()->xAxis->label(), "x from deepest point [mm]");
  auto moved = document_.description();
  for (auto& point : moved.defect.points) point.position += 0.012;
  document_.edit("move", moved);
  EXPECT_EQ(editor_.plot()->xAxis->label(), "x in the profile [mm]");
  auto* notes = editor_.findChild<QLabel*>("profileNotes");
  EXPECT_TRUE(notes->text().contains("12.0 mm")) << notes->text().toStdString();
}

// A wheel of radius R over a gap of length L sinks L^2 / (8 R) at most: the drawn path must say so.
TEST(ProfileModel, aWheelCannotFeelTheFloorOfANarrowCut) {
  cases::CaseDescription description = cases::defaultCase();
  description.defect.shape = cases::DefectShape::cut;
  description.defect.length = 0.02;
  description.defect.ramp = 1e-4;
  description.defect.depth = 1e-3;
  const ProfileView view = profileView(description);
  double lowest = 0;
  for (const auto& point : view.wheelPath) lowest = std::min(lowest, point.height);
  // 20 mm, 0.46 m: 0.109 mm. The ramps shorten the edge by 0.1 mm of 20 at the most, and the grid by half a step.
  EXPECT_NEAR(-lowest, 0.02 * 0.02 / (8 * 0.46), 0.05 * 1.09e-4);
}

TEST(ProfileModel, shapesTurnedIntoPointsKeepTheirForm) {
  const cases::CaseDescription shape = cases::defaultCase();
  const cases::CaseDescription sampled = asPoints(shape);
  const ProfileView before = profileView(shape), after = profileView(sampled);
  double lowestBefore = 0, lowestAfter = 0;
  for (const auto& point : before.surface) lowestBefore = std::min(lowestBefore, point.height);
  for (const auto& point : after.surface) lowestAfter = std::min(lowestAfter, point.height);
  EXPECT_NEAR(lowestAfter, lowestBefore, 1e-6);  // 1 mm apart on a cosine of 50 mm: below 1 % of 150 um
}

// Curves through points 1 mm apart: the depth to 1 % (the lowest point need not be one of them); beside the kinks of
// the cut half a millimetre of ramp, 0.5 of 10 mm, is 5 % of the depth.
TEST(ProfileModel, pointsKeepDepthAndPlaceOfEveryShape) {
  cases::CaseDescription description = cases::defaultCase();
  auto& defect = description.defect;
  for (const auto shape : {cases::DefectShape::cut, cases::DefectShape::cosine, cases::DefectShape::wshape})
    for (const auto lateral : {cases::LateralShape::uniform, cases::LateralShape::parabolic}) {
      defect.shape = shape, defect.lateral = lateral;
      defect.length = 0.04, defect.ramp = 0.01, defect.depth = 2e-4;
      defect.halfWidth = 0.02, defect.lateralCentre = 0.01;
      const cases::DefectSurface before(defect), after(asPoints(description).defect);
      EXPECT_NEAR(after.depth(), before.depth(), 0.01 * defect.depth) << static_cast<int>(shape);
      for (double x = -0.03; x < 0.03; x += 0.0013)
        for (const double y : {-0.005, 0.0, 0.01})
          EXPECT_NEAR(after.height(x, y), before.height(x, y), 0.05 * defect.depth)
              << static_cast<int>(shape) << " at " << x;
    }
}

// Of three points: one moved, one before or behind the point, the point itself gone, and two changed at once.
TEST(ProfileModel, aPointIsFoundAgainWhereSinglePointsHaveChanged) {
  const std::vector<cases::ProfilePoint> before{{-0.02, 0}, {0, -1e-4}, {0.02, 0}};
  using Points = std::vector<cases::ProfilePoint>;
  EXPECT_EQ(pointAfter(before, before, 1), 1u);
  EXPECT_EQ(pointAfter(before, Points{{-0.02, 0}, {0.001, -2e-4}, {0.02, 0}}, 1), 1u);
  EXPECT_EQ(pointAfter(before, Points{{-0.02, 0}, {-0.01, 0}, {0, -1e-4}, {0.02, 0}}, 1), 2u);
  EXPECT_EQ(pointAfter(before, Points{{-0.02, 0}, {0, -1e-4}, {0.01, 0}, {0.02, 0}}, 1), 1u);
  EXPECT_EQ(pointAfter(before, Points{{-0.02, 0}, {0.02, 0}}, 2), 1u);
  EXPECT_EQ(pointAfter(before, Points{{-0.02, 0}, {0.02, 0}}, 1), std::nullopt);
  EXPECT_EQ(pointAfter(before, Points{{-0.02, 0}, {0, -2e-4}, {0.03, 0}}, 0), std::nullopt);
  EXPECT_EQ(pointAfter(before, Points{}, 0), std::nullopt);
  EXPECT_EQ(pointAfter(before, before, 3), std::nullopt);
}

TEST(ProfileModel, theHeightScaleIsSeen) {
  cases::CaseDescription description = cases::defaultCase();
  description.defect.shape = cases::DefectShape::profile;
  description.defect.points = {{-0.02, 0}, {0, -1e-4}, {0.02, 0}};
  description.defect.heightScale = 3;
  double lowest = 0;
  for (const auto& point : profileView(description).surface) lowest = std::min(lowest, point.height);
  EXPECT_NEAR(lowest, -3e-4, 1e-6);
}

}  // namespace
}  // namespace squat::studio
