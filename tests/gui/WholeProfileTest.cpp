// The profile editor of a whole model: whose defect is shown, and what a change on the right states there.
#include <gmock/gmock.h>

#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/CaseFile.h"
#include "case/RightSide.h"
#include "gui/EditorOfProfile.h"
#include "studio/profile/EditedDefect.h"
#include "studio/profile/ProfilePlot.h"

namespace squat::studio {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class WholeProfile : public tests::EditorOfProfile {
 protected:
  void SetUp() override { ASSERT_NO_FATAL_FAILURE(openFivePoints(cases::ModelExtent::whole)); }
  QComboBox* side() { return editor_.findChild<QComboBox*>("profileSide"); }
  bool type(int row, const char* height) {
    auto* model = editor_.table()->model();
    return model->setData(model->index(row, 1), height);
  }
  QString shown(int row) {
    auto* model = editor_.table()->model();
    return model->data(model->index(row, 1)).toString();
  }
  // Keys that the case states of its right side.
  std::vector<std::string> stated() {
    std::vector<std::string> keys;
    for (const auto& [key, text] : document_.description().right) keys.push_back(key);
    return keys;
  }
  const cases::Defect& left() { return document_.description().defect; }
  const cases::Defect& right() { return document_.right().defect; }
  static std::vector<std::pair<double, double>> numbers(const std::vector<cases::ProfilePoint>& points) {
    std::vector<std::pair<double, double>> all;
    for (const auto& point : points) all.emplace_back(point.position, point.height);
    return all;
  }
};

TEST_F(WholeProfile, aHalfModelHasNoChoiceOfSides) {
  ASSERT_NE(side(), nullptr);
  EXPECT_TRUE(side()->isVisible());
  side()->setCurrentIndex(1);
  ASSERT_EQ(document_.setParameter("right.defect.height_scale", "2"), std::nullopt);
  EXPECT_EQ(shown(2), "-300");
  ASSERT_EQ(document_.setParameter("model.extent", "half"), std::nullopt);
  EXPECT_FALSE(side()->isVisible());
  EXPECT_EQ(side()->currentIndex(), 0);
  EXPECT_EQ(shown(2), "-150");
  document_.undoStack().undo();
  EXPECT_TRUE(side()->isVisible());
  EXPECT_EQ(shown(2), "-150");
}

// To look at a side states nothing; a point that is typed there is the right side's own, and the left one keeps its.
TEST_F(WholeProfile, whatIsChangedOnTheRightIsStatedThere) {
  side()->setCurrentIndex(1);
  EXPECT_EQ(shown(2), "-150");
  EXPECT_THAT(stated(), IsEmpty());
  EXPECT_TRUE(type(2, "-90"));
  EXPECT_THAT(stated(), ElementsAre("defect.points"));
  EXPECT_NEAR(right().points.at(2).height, -9e-5, 1e-12);
  EXPECT_EQ(numbers(right().points)[1], numbers(left().points)[1]);  // to the bit: a point that is chosen stays so
  EXPECT_NEAR(left().points.at(2).height, -1.5e-4, 1e-12);
  EXPECT_TRUE(document_.undoStack().undoText().endsWith("right side"));
  side()->setCurrentIndex(0);
  EXPECT_EQ(shown(2), "-150");
  EXPECT_TRUE(type(2, "-120"));
  EXPECT_NEAR(left().points.at(2).height, -1.2e-4, 1e-12);
  EXPECT_NEAR(right().points.at(2).height, -9e-5, 1e-12);
  document_.undoStack().undo();
  document_.undoStack().undo();
  EXPECT_THAT(stated(), IsEmpty());
}

// The rest stays as on the left, and follows it.
TEST_F(WholeProfile, anotherShapeOnTheRightLeavesTheLeftOneAsItIs) {
  side()->setCurrentIndex(1);
  auto* shape = editor_.findChild<QComboBox*>("shape defect.shape");
  shape->setCurrentText("cosine");
  Q_EMIT shape->activated(shape->currentIndex());
  EXPECT_THAT(stated(), ElementsAre("defect.shape"));
  EXPECT_EQ(left().shape, cases::DefectShape::profile);
  auto* slider = editor_.findChild<QSlider*>("slider defect.depth");
  ASSERT_TRUE(slider && slider->isVisible());
  const double before = right().depth;
  slider->setFocus();
  for (int i = 0; i < 20; ++i) QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_GT(right().depth, before);
  EXPECT_DOUBLE_EQ(left().depth, before);
  EXPECT_THAT(stated(), ElementsAre("defect.shape", "defect.depth"));
  ASSERT_EQ(document_.setParameter("defect.length", "31"), std::nullopt);
  EXPECT_DOUBLE_EQ(right().length, 0.031);
  side()->setCurrentIndex(0);
  EXPECT_FALSE(slider->isVisible());  // points have no measure of their depth
}

// A shape that both sides have becomes points on the right alone; the case holds them when it is saved and opened.
TEST_F(WholeProfile, pointsOfTheRightSideAreKeptInTheCase) {
  ASSERT_EQ(document_.setParameter("defect.shape", "cosine"), std::nullopt);
  side()->setCurrentIndex(1);
  editor_.findChild<QToolButton*>("toPoints")->click();
  EXPECT_EQ(left().shape, cases::DefectShape::cosine);
  ASSERT_EQ(right().shape, cases::DefectShape::profile);
  const auto again = cases::rightOf(cases::parseCase(cases::writeCase(document_.description()), "saved"));
  EXPECT_EQ(again.defect.shape, cases::DefectShape::profile);
  EXPECT_EQ(numbers(again.defect.points), numbers(right().points));
  ASSERT_GT(right().points.size(), 5U);
  editor_.plot()->choose(3);
  EXPECT_TRUE(type(3, "-12"));
  EXPECT_EQ(editor_.plot()->chosen(), std::optional<std::size_t>(3));
}

// A metre of depth is beyond what a case may have. It would be lost without a word.
TEST_F(WholeProfile, whatTheCaseRefusesIsSaid) {
  auto* edited = editor_.findChild<EditedDefect*>();
  ASSERT_NE(edited, nullptr);
  const QSignalSpy said(&editor_, &ProfileEditor::failed), shownAnew(edited, &EditedDefect::changed);
  side()->setCurrentIndex(1);
  const auto before = shownAnew.count();
  cases::CaseDescription after = edited->description();
  after.defect.depth = 1;
  edited->edit("Change defect.depth", after);
  ASSERT_EQ(said.count(), 1);
  EXPECT_TRUE(said[0][0].toString().contains("right.defect.depth is 1000")) << said[0][0].toString().toStdString();
  EXPECT_EQ(shownAnew.count(), before + 1) << "sliders go back to what the case says";
  EXPECT_THAT(stated(), IsEmpty());
  edited->setParameter("defect.depth", "deep");
  ASSERT_EQ(said.count(), 2);
  EXPECT_TRUE(said[1][0].toString().contains("right.defect.depth is deep")) << said[1][0].toString().toStdString();
  side()->setCurrentIndex(0);
  edited->setParameter("defect.depth", "deep");
  ASSERT_EQ(said.count(), 3);
  EXPECT_TRUE(said[2][0].toString().contains(" defect.depth is deep")) << said[2][0].toString().toStdString();
  EXPECT_EQ(document_.undoStack().count(), 0);
}

// Another case is first seen on the left, as a half model would be.
TEST_F(WholeProfile, anotherCaseIsSeenOnTheLeft) {
  side()->setCurrentIndex(1);
  EXPECT_TRUE(type(2, "-90"));
  document_.startFrom(cases::CaseDescription(document_.description()), QString(), "other", false);
  EXPECT_EQ(side()->currentIndex(), 0);
  EXPECT_EQ(shown(2), "-150");
}

}  // namespace
}  // namespace squat::studio
