// Which results are the paper's cases: by what they are, not by what they are called.
#include "case/CaseDescription.h"
#include "statements/PaperCase.h"

#include <gmock/gmock.h>

#include "case/CaseFile.h"

namespace squat::statements {
namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

results::RunResult resultOf(const std::string& name, const Sets& sets = {}, const std::string& mesh = "draft") {
  results::RunResult result;
  result.stem = "anything";
  results::setCase(result, cases::loadCase(name, {mesh, sets}));
  return result;
}

TEST(PaperCase, EachShippedCaseOfThePaperIsItselfOnEveryMesh) {
  for (const char* name : {"light-defect", "class-c-squat", "class-c-squat-modified", "smooth-rail"})
    for (const char* mesh : {"tiny", "draft", "standard", "paper"}) {
      const auto found = paperCaseOf(resultOf(name, {}, mesh));
      ASSERT_TRUE(found) << name << " " << mesh;
      EXPECT_EQ(found->name, name) << mesh;
      EXPECT_TRUE(found->isThePapers()) << name << " " << mesh;
    }
}

// The runs of `squat validate` have it, and so has the case that keeps it.
TEST(PaperCase, ThePapersTorqueMakesNoDifference) {
  for (const char* name : {"light-defect", "class-c-squat", "class-c-squat-modified", "smooth-rail"}) {
    const auto found = paperCaseOf(resultOf(name, {{"motion.torque", "12450.49"}}));
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->name, name);
    EXPECT_TRUE(found->isThePapers()) << name;
  }
  const auto full = paperCaseOf(resultOf("light-defect-full-torque"));
  ASSERT_TRUE(full);
  EXPECT_EQ(full->name, "light-defect");
  EXPECT_TRUE(full->isThePapers());
  const auto other = paperCaseOf(resultOf("light-defect", {{"motion.torque", "11000"}}));
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->isThePapers());
}

TEST(PaperCase, WhatThePaperDoesNotStateIsFree) {
  const auto found = paperCaseOf(
      resultOf("light-defect",
               {{"motion.beyond", "0.6"}, {"mesh.far_size", "37.5"}, {"title", "at Assen"}, {"track.length", "12"}}));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isThePapers());
}

TEST(PaperCase, ChangedKeysAreNamedWithBothValues) {
  const auto found = paperCaseOf(resultOf("class-c-squat", {{"motion.speed", "25"}, {"pad.stiffness", "700"}}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "class-c-squat");
  ASSERT_EQ(found->changed.size(), 2U);
  for (const auto& one : found->changed)
    if (one.key == "motion.speed") {
      EXPECT_EQ(one.ours, "25 m/s");
      EXPECT_EQ(one.paper, "30 m/s");
    } else {
      EXPECT_EQ(one.key, "pad.stiffness");
      EXPECT_EQ(one.paper, "1300 MN/m");
    }
}

TEST(PaperCase, AnotherDefectIsNoneOfThePapers) {
  EXPECT_FALSE(paperCaseOf(resultOf("class-c-squat", {{"defect.depth", "0.2"}})));
  EXPECT_FALSE(paperCaseOf(results::RunResult{})) << "a result that carries no case";
}

}  // namespace
}  // namespace squat::statements
