// The form of a whole model: what the right side may have of its own, beside what the left side has.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "case/ParameterTable.h"
#include "case/RightSide.h"
#include "results/RunResult.h"
#include "studio/document/CaseDocument.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/document/ShownCase.h"

namespace squat::studio {
namespace {

class WholeForm : public testing::Test {
 protected:
  void SetUp() override {
    form_.resize(400, 600);
    form_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&form_));
    ASSERT_EQ(document_.setParameter("model.extent", "whole"), std::nullopt);
  }
  void TearDown() override { QSettings().setValue("parameterLevel", 2); }
  QTabBar* sides() { return form_.findChild<QTabBar*>("sides"); }
  QLineEdit* line(const std::string& key) { return qobject_cast<QLineEdit*>(form_.row(key)->editor()); }
  QComboBox* choice(const std::string& key) { return qobject_cast<QComboBox*>(form_.row(key)->editor()); }
  void enter(const std::string& key, const QString& text) {
    line(key)->setFocus();
    line(key)->selectAll();
    if (text.isEmpty())
      QTest::keyClick(line(key), Qt::Key_Delete);
    else
      QTest::keyClicks(line(key), text);
    QTest::keyClick(line(key), Qt::Key_Return);
  }
  void choose(const std::string& key, int entry) {
    choice(key)->setCurrentIndex(entry);
    Q_EMIT choice(key)->activated(entry);
  }
  bool isSeen(const std::string& key) { return form_.row(key)->isVisible(); }
  // Of what a run of the case would have on the right.
  cases::CaseDescription onRight() const { return cases::rightOf(document_.description()); }

  CaseDocument document_;
  ParameterForm form_{document_};
};

TEST_F(WholeForm, aHalfModelHasNeitherTabsNorRowsOfTheRightSide) {
  CaseDocument half;
  ParameterForm form(half);
  form.show();
  EXPECT_FALSE(form.findChild<QTabBar*>("sides")->isVisible());
  EXPECT_EQ(form.rows().size(), cases::parameterTable().size());
  EXPECT_EQ(form.row("right.defect.depth"), nullptr);
  // And has it no longer where a case is made half again.
  EXPECT_TRUE(sides()->isVisible());
  sides()->setCurrentIndex(1);
  document_.undoStack().undo();
  EXPECT_FALSE(sides()->isVisible());
  for (const auto& parameter : cases::parameterTable()) {
    EXPECT_TRUE(isSeen(parameter.key)) << parameter.key;
    if (cases::mayDiffer(parameter.key)) {
      EXPECT_FALSE(isSeen("right." + parameter.key)) << parameter.key;
    }
  }
}

TEST_F(WholeForm, hasARowForEveryKeyOfTheRightSide) {
  for (const auto& parameter : cases::parameterTable()) {
    const ParameterRow* row = form_.row("right." + parameter.key);
    ASSERT_EQ(row != nullptr, cases::mayDiffer(parameter.key)) << parameter.key;
    if (!row) continue;
    EXPECT_EQ(row->editor()->accessibleName().toStdString(), "right." + parameter.key);
    EXPECT_TRUE(row->toolTip().contains(QString::fromStdString(parameter.doc).toHtmlEscaped())) << parameter.key;
    EXPECT_TRUE(row->toolTip().contains("as left")) << parameter.key;
    EXPECT_TRUE(row->label().endsWith(", right"));
    EXPECT_FALSE(row->isChanged());
  }
}

TEST_F(WholeForm, theRightSideIsAsTheLeftOneUntilItIsGiven) {
  sides()->setCurrentIndex(1);
  QLineEdit* depth = line("right.defect.depth");
  EXPECT_EQ(depth->text(), "");
  EXPECT_EQ(depth->placeholderText(), "0.15, as left");
  document_.setParameter("defect.depth", "0.2");
  EXPECT_EQ(depth->placeholderText(), "0.2, as left");
  EXPECT_TRUE(depth->accessibleDescription().contains("0.2, as left"));
  EXPECT_TRUE(document_.description().right.empty());

  enter("right.defect.depth", "0,3");  // a decimal comma as on the left
  EXPECT_DOUBLE_EQ(onRight().defect.depth, 0.3e-3);
  EXPECT_DOUBLE_EQ(document_.description().defect.depth, 0.2e-3);
  EXPECT_EQ(depth->text(), "0.3");
  EXPECT_TRUE(form_.row("right.defect.depth")->isChanged());
  EXPECT_FALSE(form_.row("defect.length")->isChanged());
  document_.setParameter("defect.depth", "0.25");
  EXPECT_DOUBLE_EQ(onRight().defect.depth, 0.3e-3);  // its own
  EXPECT_EQ(depth->text(), "0.3");
}

TEST_F(WholeForm, aChangeOfTheRightSideIsUndoneAndRedone) {
  sides()->setCurrentIndex(1);
  enter("right.pad.stiffness", "800");
  EXPECT_DOUBLE_EQ(onRight().pad.stiffness, 800e6);
  EXPECT_EQ(document_.undoStack().undoText(), "Change right.pad.stiffness");
  document_.undoStack().undo();
  EXPECT_TRUE(document_.description().right.empty());
  EXPECT_EQ(line("right.pad.stiffness")->text(), "");
  document_.undoStack().redo();
  EXPECT_DOUBLE_EQ(onRight().pad.stiffness, 800e6);
  EXPECT_EQ(line("right.pad.stiffness")->text(), "800");
}

// By the arrow beside it, and by emptying its field.
TEST_F(WholeForm, isSetBackToWhatTheLeftSideHas) {
  sides()->setCurrentIndex(1);
  for (const bool byArrow : {true, false}) {
    enter("right.pad.stiffness", "800");
    ASSERT_FALSE(document_.description().right.empty());
    auto* arrow = form_.row("right.pad.stiffness")->findChild<QToolButton*>();
    ASSERT_TRUE(arrow->isVisible());
    if (byArrow)
      QTest::mouseClick(arrow, Qt::LeftButton);
    else
      enter("right.pad.stiffness", "");
    EXPECT_TRUE(document_.description().right.empty());
    EXPECT_DOUBLE_EQ(onRight().pad.stiffness, document_.description().pad.stiffness);
    EXPECT_EQ(line("right.pad.stiffness")->placeholderText(), "1300, as left");
    EXPECT_FALSE(arrow->isVisible());
  }
  EXPECT_EQ(document_.undoStack().undoText(), "Set right.pad.stiffness as on the left");
  document_.undoStack().undo();
  EXPECT_DOUBLE_EQ(onRight().pad.stiffness, 800e6);
}

// The first entry is that of the left side; a switch has three states.
TEST_F(WholeForm, choicesBeginWithThatOfTheLeftSide) {
  QComboBox* shape = choice("right.defect.shape");
  ASSERT_NE(shape, nullptr);
  EXPECT_EQ(shape->currentText(), "cosine, as left");
  choose("right.defect.shape", shape->findText("cut"));
  EXPECT_EQ(onRight().defect.shape, cases::DefectShape::cut);
  EXPECT_EQ(document_.description().defect.shape, cases::DefectShape::cosine);
  EXPECT_EQ(shape->currentText(), "cut");
  choose("right.defect.shape", 0);
  EXPECT_TRUE(document_.description().right.empty());
  document_.setParameter("defect.shape", "w-shape");
  EXPECT_EQ(shape->currentText(), "w-shape, as left");

  QComboBox* moves = choice("right.defect.move_nodes");
  ASSERT_NE(moves, nullptr);
  EXPECT_EQ(moves->currentText(), "false, as left");
  choose("right.defect.move_nodes", moves->findText("true"));
  EXPECT_TRUE(onRight().defect.moveNodes);
  EXPECT_FALSE(document_.description().defect.moveNodes);
}

TEST_F(WholeForm, aWrongValueIsFlaggedUnderItsName) {
  sides()->setCurrentIndex(1);
  enter("right.pad.stiffness", "-5");
  EXPECT_TRUE(document_.description().right.empty());
  ASSERT_EQ(form_.blockers().size(), 1);
  EXPECT_TRUE(form_.blockers()[0].startsWith("right.pad.stiffness: ")) << form_.blockers()[0].toStdString();
  EXPECT_EQ(form_.refusals(), form_.blockers());
  sides()->setCurrentIndex(0);
  line("motion.speed")->setFocus();
  EXPECT_TRUE(isSeen("right.pad.stiffness"));  // whatever tab is seen
  // Who makes the case half could neither see nor mend it.
  document_.setParameter("model.extent", "half");
  EXPECT_TRUE(form_.blockers().isEmpty());
}

// 500 kg beside 14 t: the axle's load tips the wheelset over its left wheel.
TEST_F(WholeForm, whatTheSidesAreTogetherIsFlaggedAtTheRightKey) {
  document_.setParameter("suspension.sprung_mass", "14000");
  document_.setParameter("right.suspension.sprung_mass", "500");
  const auto& problems = document_.validation().problems;
  ASSERT_EQ(problems.size(), 1u);
  ASSERT_EQ(problems[0].key, "right.suspension.sprung_mass");
  EXPECT_FALSE(form_.row("right.suspension.sprung_mass")->reason().isEmpty());
  EXPECT_TRUE(form_.row("suspension.sprung_mass")->reason().isEmpty());
  ASSERT_EQ(form_.blockers().size(), 1);
  EXPECT_TRUE(form_.blockers()[0].startsWith("right.suspension.sprung_mass: "));
}

TEST_F(WholeForm, theTabsTellTheSidesApart) {
  form_.findChild<QComboBox*>("parameterLevel")->setCurrentText("Basic");
  EXPECT_TRUE(isSeen("motion.speed"));
  EXPECT_TRUE(isSeen("defect.depth"));
  EXPECT_FALSE(isSeen("right.defect.depth"));
  EXPECT_FALSE(isSeen("right.ballast.stiffness"));
  sides()->setCurrentIndex(1);
  EXPECT_FALSE(isSeen("motion.speed"));
  EXPECT_FALSE(isSeen("defect.depth"));
  EXPECT_TRUE(isSeen("right.defect.depth"));
  EXPECT_FALSE(isSeen("right.ballast.stiffness"));  // no basic key
  form_.findChild<QComboBox*>("parameterLevel")->setCurrentText("Advanced");
  EXPECT_TRUE(isSeen("right.ballast.stiffness"));
  // What the case states is seen beside its counterpart as well.
  document_.setParameter("right.ballast.stiffness", "30");
  sides()->setCurrentIndex(0);
  EXPECT_TRUE(isSeen("right.ballast.stiffness"));
  document_.startNew();
  EXPECT_FALSE(sides()->isVisible());
}

TEST_F(WholeForm, theSearchFindsBothSides) {
  auto* search = form_.findChild<QLineEdit*>("parameterSearch");
  for (const int side : {0, 1}) {
    sides()->setCurrentIndex(side);
    search->setText("friction");
    EXPECT_TRUE(isSeen("contact.friction"));
    EXPECT_TRUE(isSeen("right.contact.friction"));
    EXPECT_FALSE(isSeen("right.pad.stiffness"));
    search->setText("right.pad");
    EXPECT_TRUE(isSeen("right.pad.stiffness"));
    EXPECT_FALSE(isSeen("pad.stiffness"));
  }
}

TEST_F(WholeForm, onlyWhatTheRightSideHasOfItsOwnIsChanged) {
  document_.setParameter("motion.speed", "25");
  document_.setParameter("right.defect.depth", "0.15");  // what the left side has, but stated
  form_.findChild<QAbstractButton*>("changedOnly")->setChecked(true);
  EXPECT_TRUE(isSeen("motion.speed"));
  EXPECT_TRUE(isSeen("right.defect.depth"));
  EXPECT_FALSE(isSeen("right.defect.length"));
  sides()->setCurrentIndex(1);
  EXPECT_FALSE(isSeen("motion.speed"));
  EXPECT_TRUE(isSeen("right.defect.depth"));
}

// What decides is what the right side has.
TEST_F(WholeForm, aKeyWithoutEffectOnTheRightSaysWhy) {
  const ParameterRow* ramp = form_.row("right.defect.ramp");
  EXPECT_TRUE(ramp->toolTip().contains("no effect because defect.shape is cosine")) << ramp->toolTip().toStdString();
  document_.setParameter("right.defect.shape", "cut");
  EXPECT_FALSE(ramp->toolTip().contains("no effect")) << ramp->toolTip().toStdString();
  EXPECT_TRUE(form_.row("defect.ramp")->toolTip().contains("no effect"));
}

// Each below its counterpart, for the eyes and for the Tab key.
TEST_F(WholeForm, theRightRowFollowsTheLeftOne) {
  form_.findChild<QLineEdit*>("parameterSearch")->setText("friction");
  QTest::qWait(20);
  EXPECT_GT(form_.row("right.contact.friction")->y(), form_.row("contact.friction")->y());
  const QWidget* next = line("contact.friction");
  do next = next->nextInFocusChain();
  while (next != line("contact.friction") && !qobject_cast<const QLineEdit*>(next));
  EXPECT_EQ(next, line("right.contact.friction"));
}

// Both wheels weigh 950 kg each; 8000 kg on the left and 7000 on the right: 16.9 t, 165.8 kN at 9.81 m/s2.
TEST_F(WholeForm, theAxleLoadIsThatOfBothSides) {
  document_.setParameter("suspension.sprung_mass", "8000");
  document_.setParameter("wheelset.total_mass", "950");
  document_.setParameter("motion.gravity", "9.81");
  const auto other = [&](const char* key) { return form_.row(key)->findChild<QLabel*>("otherUnits")->text(); };
  EXPECT_EQ(other("suspension.sprung_mass"), "axle load 17.9 t (176 kN)");
  EXPECT_EQ(other("right.suspension.sprung_mass"), "");
  document_.setParameter("right.suspension.sprung_mass", "7000");
  EXPECT_EQ(other("suspension.sprung_mass"), "axle load 16.9 t (166 kN)");
  EXPECT_EQ(other("right.suspension.sprung_mass"), "axle load 16.9 t (166 kN)");
}

// Beside the curves stands in what their case differs from the open one.
TEST_F(WholeForm, aResultOfAnotherRightSideSaysSo) {
  results::RunResult result;
  results::setCase(result, document_.description());
  EXPECT_EQ(differenceOfCases(&result, document_.description()), "");
  document_.setParameter("right.pad.stiffness", "800");
  EXPECT_EQ(differenceOfCases(&result, document_.description()), "right.pad.stiffness differs");
  document_.setParameter("right.defect.depth", "0.3");
  EXPECT_EQ(differenceOfCases(&result, document_.description()), "right.defect.depth, right.pad.stiffness differ");
}

}  // namespace
}  // namespace squat::studio
