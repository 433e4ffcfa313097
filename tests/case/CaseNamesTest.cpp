// Names of cases from what tells them apart. Expected names are written by hand from the rules in the header.
#include "case/CaseNames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"

namespace squat::cases {
namespace {

using testing::ElementsAre;
using Settings = std::vector<std::pair<const char*, const char*>>;

class CaseNames : public testing::Test {
 protected:
  // The default case with these values, under this stem.
  void add(const Settings& settings, const char* stem = "untitled", MeshPreset mesh = MeshPreset::draft) {
    CaseDescription description = defaultCase();
    applyPreset(description, mesh);
    for (const auto& [key, text] : settings) setValue(description, key, text);
    addCase(description, stem);
  }
  void addCase(const CaseDescription& description, const char* stem) {
    values_.push_back(comparedCase(description));
    cases_.push_back({stem, &values_.back()});
  }
  std::vector<std::string> names() const { return caseNames(cases_); }
  std::vector<std::string> keys() const {
    std::vector<const ComparedCase*> all;
    for (const auto& one : cases_) all.push_back(one.values);
    std::vector<std::string> found;
    for (const std::size_t row : differingRows(all)) found.push_back(comparedKey(row));
    return found;
  }

  std::deque<ComparedCase> values_;  // their addresses stay
  std::vector<CaseToName> cases_;
};

TEST_F(CaseNames, oneCaseIsCalledByItsFile) {
  add({}, "light-defect");
  EXPECT_THAT(names(), ElementsAre("light-defect"));
}

TEST_F(CaseNames, wordsArePrintedAsInATable) {
  EXPECT_EQ(shortLabel(*findParameter("rail.young_modulus")), "rail Young's modulus");
  EXPECT_EQ(shortLabel(*findParameter("sleeper.poisson_ratio")), "sleeper Poisson's ratio");
  EXPECT_EQ(shortLabel(*findParameter("motion.run_up")), "run-up");
  EXPECT_EQ(shortLabel(*findParameter("track.sleeper_spacing")), "track sleeper spacing");
  EXPECT_EQ(shortLabel(*findParameter("title")), "title");
}

TEST_F(CaseNames, namesSayWhatDiffers) {
  add({{"defect.depth", "0.15"}});
  add({{"defect.depth", "0.2"}, {"pad.stiffness", "800"}}, "untitled", MeshPreset::tiny);
  EXPECT_THAT(keys(), ElementsAre("defect.depth", "pad.stiffness", "mesh.preset"));
  EXPECT_THAT(names(), ElementsAre("depth 0.15, pad stiffness 1300, draft", "depth 0.2, pad stiffness 800, tiny"));
}

// A preset changes fourteen keys at once; its name says them all, and one that the user set is named beside it.
TEST_F(CaseNames, whatAMeshPresetSetsIsNotNamed) {
  add({}, "a", MeshPreset::tiny);
  add({{"mesh.contact_size", "4"}}, "a", MeshPreset::tiny);
  EXPECT_THAT(keys(), ElementsAre("mesh.contact_size"));
  EXPECT_THAT(names(), ElementsAre("a", "contact size 4"));
}

TEST_F(CaseNames, whatHasNoEffectTellsNothingApart) {
  add({{"defect.ramp", "3"}, {"title", "mine"}, {"note", "first"}}, "a");  // a ramp is that of a cut
  add({{"defect.ramp", "5"}, {"title", "yours"}}, "a");
  EXPECT_TRUE(keys().empty());
  EXPECT_THAT(names(), ElementsAre("a", "a (2)"));
}

// Shipped cases differ in much; variants are told from their own kind.
TEST_F(CaseNames, severalStemsComeFirstAndVariantsAreComparedWithTheirOwn) {
  add({}, "light");
  add({{"defect.shape", "cut"}, {"defect.length", "30"}, {"defect.ramp", "4"}, {"motion.speed", "20"}}, "severe");
  add({{"motion.speed", "40"}}, "light");
  EXPECT_THAT(names(), ElementsAre("light, speed 30", "severe", "light, speed 40"));
}

TEST_F(CaseNames, atMostFourValuesAndStillNoTwoTheSame) {
  add({});
  const Settings many{{"defect.depth", "0.3"},
                      {"defect.length", "60"},
                      {"motion.speed", "20"},
                      {"track.sleeper_spacing", "0.65"},
                      {"pad.stiffness", "900"}};
  add(many);
  auto more = many;
  more.back().second = "950";  // the fifth in the table's order
  add(more);
  const auto made = names();
  EXPECT_EQ(std::count(made[1].begin(), made[1].end(), ','), 3) << made[1];
  EXPECT_EQ(made[2], made[1] + " (2)");
}

TEST_F(CaseNames, aDrawnProfileIsNamedByItsExtentOrItsFile) {
  const Settings drawn{{"defect.shape", "profile"}, {"defect.points", "[[-20, 0], [0, -0.25], [25, 0]]"}};
  add(drawn);
  auto other = drawn;
  other.back().second = "[[-20, 0], [0, -0.25], [10, -0.1], [25, 0]]";
  add(other);
  other.push_back({"defect.file", "measured/rail 7.csv"});
  add(other);
  EXPECT_THAT(keys(), ElementsAre("defect.points"));
  EXPECT_THAT(names(), ElementsAre("0.25 deep, 45 long", "0.25 deep, 45 long (2)", "rail 7"));
}

// What the right side has of its own stands behind what both have, by the name of its side.
TEST_F(CaseNames, theRightSideIsNamed) {
  const auto addWhole = [&](const Settings& right) {
    CaseDescription description = defaultCase();
    setValue(description, "model.extent", "whole");
    for (const auto& [key, text] : right) ASSERT_EQ(trySetRight(description, key, text), std::nullopt);
    addCase(description, "a");
  };
  addWhole({});
  addWhole({{"defect.depth", "0.3"}, {"pad.stiffness", "800"}});
  addWhole({{"defect.depth", "0.15"}, {"defect.shape", "none"}});  // without a defect it has no depth
  EXPECT_THAT(keys(), ElementsAre("right.defect.shape", "right.defect.depth", "right.pad.stiffness"));
  EXPECT_THAT(names(), ElementsAre("a", "right depth 0.3, right pad stiffness 800", "right shape none"));
  EXPECT_EQ(comparedLabel(parameterTable().size()), "right " + shortLabel(parameterTable()[0]));
}

// Stated as the left side has it, and in a half model, it tells nothing apart.
TEST_F(CaseNames, aRightSideThatIsAsTheLeftOneIsNotNamed) {
  for (const char* extent : {"whole", "half"}) {
    values_.clear(), cases_.clear();
    CaseDescription description = defaultCase();
    setValue(description, "model.extent", extent);
    addCase(description, "a");
    ASSERT_EQ(trySetRight(description, "defect.depth", std::string(extent) == "half" ? "0.3" : "0.15"), std::nullopt);
    addCase(description, "a");
    EXPECT_TRUE(keys().empty()) << extent;
  }
}

// The names of presets are not named, their values are: the case may have overridden them.
TEST_F(CaseNames, inputPresetsAreSeenThroughTheirValues) {
  CaseDescription soft = defaultCase();
  applyInputPreset(soft, "track.preset", "soft-pads");
  add({}, "a");
  addCase(soft, "a");
  const auto found = keys();
  EXPECT_THAT(found, testing::Contains("pad.stiffness"));
  EXPECT_THAT(found, testing::Not(testing::Contains("track.preset")));
}

}  // namespace
}  // namespace squat::cases
