// Every change of the case can be undone.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <fstream>
#include <random>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "studio/document/CaseDocument.h"
#include "studio/profile/ProfileModel.h"

namespace squat::studio {
namespace {

// One random change of a random kind; may be refused.
void changeSomething(CaseDocument& document, std::mt19937& random) {
  const auto& table = cases::parameterTable();
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const auto kind = std::uniform_int_distribution<int>(0, 9)(random);
  if (kind < 6) {
    const auto& parameter = table[std::uniform_int_distribution<std::size_t>(0, table.size() - 1)(random)];
    std::string text = "a title";
    if (parameter.kind == cases::Kind::number) {
      double value = parameter.minimum + share() * (parameter.maximum - parameter.minimum);
      if (parameter.integer) value = std::floor(value);
      text = QString::number(value, 'g', 12).toStdString();
    } else if (parameter.kind == cases::Kind::choice) {
      text =
          parameter.choices[static_cast<std::size_t>(share() * 0.999 * static_cast<double>(parameter.choices.size()))];
    } else if (parameter.kind == cases::Kind::boolean) {
      text = share() < 0.5 ? "true" : "false";
    } else if (parameter.kind == cases::Kind::points) {
      text = "[[0, 0], [10, -0.1], [20, 0]]";
    } else if (parameter.kind == cases::Kind::lines) {
      text = "[[-5, [[0, 0], [10, -0.1], [20, 0]]], [5, [[0, 0], [12, -0.2], [20, 0]]]]";
    } else if (parameter.kind == cases::Kind::forceCurve) {
      text = "[[0, 0], [0.2, 40]]";
    } else if (parameter.kind == cases::Kind::seats) {
      text = "[{ sleeper = 0, gap = 0.5 }]";
    }
    document.setParameter(parameter.key, text);
  } else if (kind < 7) {
    document.resetParameter(table[static_cast<std::size_t>(share() * 0.999 * static_cast<double>(table.size()))].key);
  } else {
    cases::CaseDescription after = asPoints(document.description());
    auto& points = after.defect.points;
    const auto index = static_cast<std::size_t>(share() * 0.999 * static_cast<double>(points.size()));
    if (kind == 7)
      points = movedPoint(points, index, {points[index].position + 0.01 * (share() - 0.5), -1e-4 * share()});
    if (kind == 8) points = withPoint(points, {0.1 * (share() - 0.5), -1e-4 * share()});
    if (kind == 9) points = withoutPoint(points, index);
    document.edit("points", after, kind == 7 ? 1 + static_cast<int>(3 * share()) : 0);
  }
}

// One that was recovered is, though nothing of it can be undone.
TEST(CaseDocument, aNewCaseIsNotModifiedWhateverWasBefore) {
  CaseDocument document;
  document.startFrom(document.description(), QString(), "recovered", true);
  EXPECT_TRUE(document.isModified());
  document.startNew();
  EXPECT_FALSE(document.isModified());
}

TEST(CaseDocument, aThousandRandomEditsUndoneAndRedone) {
  std::mt19937 random(20140715);
  CaseDocument document;
  const std::string start = cases::writeCase(document.description());
  for (int i = 0; i < 1000; ++i) changeSomething(document, random);
  const std::string end = cases::writeCase(document.description());
  ASSERT_NE(start, end);
  ASSERT_GT(document.undoStack().count(), 500);
  while (document.undoStack().canUndo()) document.undoStack().undo();
  EXPECT_EQ(cases::writeCase(document.description()), start);
  EXPECT_FALSE(document.isModified());
  while (document.undoStack().canRedo()) document.undoStack().redo();
  EXPECT_EQ(cases::writeCase(document.description()), end);
}

// The window that listens would read the name of a document that is gone.
TEST(CaseDocument, tellsNobodyWhenItGoes) {
  int told = 0;
  {
    CaseDocument document;
    document.setParameter("motion.speed", "25");
    ASSERT_TRUE(document.isModified());
    QObject::connect(&document, &CaseDocument::titleChanged, [&] { ++told; });
    document.setParameter("motion.speed", "26");
    document.undoStack().setClean();
    document.setParameter("motion.speed", "27");
    EXPECT_EQ(told, 2);  // clean and modified again
  }
  EXPECT_EQ(told, 2);
}

// The window may undo more than the case: that is nothing to save, and hides no change that is.
TEST(CaseDocument, isModifiedByStepsOfTheCaseAlone) {
  const QTemporaryDir folder;
  CaseDocument document;
  QUndoStack& stack = document.undoStack();
  int told = 0;
  QObject::connect(&document, &CaseDocument::titleChanged, [&] { ++told; });
  stack.push(new QUndoCommand("of something else"));
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(told, 0);
  document.setParameter("motion.speed", "25");
  EXPECT_TRUE(document.isModified());
  EXPECT_EQ(told, 1);
  stack.undo();
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(told, 2);
  stack.undo();
  EXPECT_FALSE(document.isModified());
  stack.redo();
  stack.redo();
  EXPECT_TRUE(document.isModified());
  document.save(folder.filePath("saved.toml"));
  EXPECT_FALSE(document.isModified());
  stack.push(new QUndoCommand("of something else"));
  stack.undo();
  EXPECT_FALSE(document.isModified());
  stack.undo();
  EXPECT_TRUE(document.isModified()) << "the file has the other speed";
  stack.redo();
  EXPECT_FALSE(document.isModified());
}

TEST(CaseDocument, oneGestureIsOneStep) {
  CaseDocument document;
  const int gesture = document.newGesture();
  for (double depth : {1e-4, 2e-4, 3e-4}) {
    cases::CaseDescription after = document.description();
    after.defect.depth = depth;
    document.edit("depth", after, gesture);
  }
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_TRUE(sameCase(document.description(), cases::defaultCase()));
}

TEST(CaseDocument, whatChangesNothingIsNoStep) {
  CaseDocument document;
  document.setParameter("motion.speed", "25");
  document.undoStack().undo();
  document.edit("nothing", document.description());
  EXPECT_TRUE(document.undoStack().canRedo());
  EXPECT_FALSE(document.isModified());
}

TEST(CaseDocument, aWrongTextChangesNothingAndSaysWhatIsAllowed) {
  CaseDocument document;
  const auto problem = document.setParameter("motion.speed", "fast");
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->value, "fast");
  EXPECT_FALSE(problem->allowed.empty());
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(CaseDocument, aPresetBringsItsSizes) {
  CaseDocument document;
  const double before = document.description().mesh.contactSize;
  document.setParameter("mesh.preset", "tiny");
  EXPECT_GT(document.description().mesh.contactSize, before);
  document.undoStack().undo();
  EXPECT_EQ(document.description().mesh.contactSize, before);
}

// All that it names in one step, back and forth.
TEST(CaseDocument, aWheelsetPresetIsOneStep) {
  CaseDocument document;
  const auto before = document.description();
  EXPECT_FALSE(document.setParameter("wheelset.preset", "trailer"));
  EXPECT_EQ(document.description().wheelset.brakeDiscs, 1);
  EXPECT_EQ(document.description().suspension.sprungMass, 5525);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_TRUE(sameCase(document.description(), before));
  document.undoStack().redo();
  EXPECT_EQ(document.description().wheelset.totalMass, 0);
  EXPECT_TRUE(document.setParameter("wheelset.preset", "trailor"));
}

TEST(CaseDocument, aPresetLeavesWhatTheUserHasSet) {
  CaseDocument document;
  const double runUp = document.description().motion.runUp;
  document.setParameter("motion.beyond", "0.6");
  document.setParameter("mesh.preset", "tiny");
  EXPECT_DOUBLE_EQ(document.description().motion.beyond, 0.6);
  EXPECT_LT(document.description().motion.runUp, runUp);  // was that of the preset and is again
  document.resetParameter("mesh.preset");
  EXPECT_DOUBLE_EQ(document.description().motion.beyond, 0.6);
  EXPECT_DOUBLE_EQ(document.description().motion.runUp, runUp);
}

// By the names that files and commands know.
TEST(CaseDocument, theRightSideIsSetAndSetBack) {
  CaseDocument document;
  document.setParameter("model.extent", "whole");
  EXPECT_EQ(document.setParameter("right.defect.depth", "0.3"), std::nullopt);
  EXPECT_DOUBLE_EQ(cases::rightOf(document.description()).defect.depth, 0.3e-3);
  EXPECT_DOUBLE_EQ(document.right().defect.depth, 0.3e-3);
  EXPECT_EQ(document.undoStack().count(), 2);
  document.setParameter("right.defect.depth", "0.3");
  document.resetParameter("right.defect.length");  // is as on the left
  EXPECT_EQ(document.undoStack().count(), 2);
  const auto wrong = document.setParameter("right.defect.depth", "deep");
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->key, "right.defect.depth");
  EXPECT_TRUE(document.setParameter("right.motion.speed", "20"));  // both sides have the same
  document.resetParameter("right.defect.depth");
  EXPECT_TRUE(document.description().right.empty());
  document.undoStack().undo();
  EXPECT_DOUBLE_EQ(document.right().defect.depth, 0.3e-3);
}

// Its points are stated for that side alone, and go with its name. The file is made by hand.
TEST(CaseDocument, theRightSideMayNameAProfile) {
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("right.csv").toStdString()) << "position [mm],height [mm]\n-30,0\n0,-0.2\n30,0\n";
  CaseDocument document;
  document.setParameter("model.extent", "whole");
  document.save(folder.filePath("both.toml"));
  EXPECT_TRUE(document.setParameter("right.defect.file", "missing.csv"));
  EXPECT_EQ(document.setParameter("right.defect.file", "right.csv"), std::nullopt);
  EXPECT_EQ(document.setParameter("right.defect.shape", "profile"), std::nullopt);
  const auto right = cases::rightOf(document.description());
  ASSERT_EQ(right.defect.points.size(), 3u);
  EXPECT_DOUBLE_EQ(right.defect.points[1].height, -0.2e-3);
  EXPECT_TRUE(document.description().defect.points.empty());
  EXPECT_TRUE(document.validation().problems.empty());
  document.save(folder.filePath("both.toml"));
  CaseDocument again;
  again.open(folder.filePath("both.toml"));
  EXPECT_TRUE(sameCase(again.description(), document.description()));
  document.resetParameter("right.defect.file");
  EXPECT_TRUE(cases::rightOf(document.description()).defect.points.empty());
  document.undoStack().undo();
  EXPECT_EQ(cases::rightOf(document.description()).defect.points.size(), 3u);
}

TEST(CaseDocument, savedAndOpenedIsEqual) {
  const QTemporaryDir folder;
  CaseDocument document;
  document.open("light-defect");
  EXPECT_TRUE(document.path().isEmpty());  // a shipped case is opened as a copy
  document.setParameter("motion.speed", "27.5");
  const auto before = document.description();
  document.save(folder.filePath("mine.toml"));
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.name(), "mine");
  CaseDocument again;
  again.open(folder.filePath("mine.toml"));
  EXPECT_EQ(cases::caseHash(again.description()), cases::caseHash(before));
  EXPECT_TRUE(sameCase(again.description(), before));
}

}  // namespace
}  // namespace squat::studio
