// The cases that come with the program: all there, valid, and with the paper's numbers.
#include "case/ShippedCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "case/CaseFile.h"
#include "case/DefectSurface.h"
#include "case/Validation.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> names{"class-c-squat", "class-c-squat-modified", "light-defect",
                                     "light-defect-partial-slip", "smooth-rail"};

TEST(ShippedCases, AreAllThere) { EXPECT_THAT(shippedCases(), testing::IsSupersetOf(names)); }

TEST(ShippedCases, CanBeRunWithEveryPreset) {
  for (const auto& name : shippedCases())
    for (const char* preset : {"tiny", "draft", "standard", "paper"}) {
      const CaseDescription description = loadCase(name, {preset, {}});
      for (const auto& problem : validate(description).problems) ADD_FAILURE() << name << ": " << toText(problem);
      EXPECT_FALSE(description.title.empty()) << name;
    }
}

TEST(ShippedCases, SayWhatIsThePapersAndWhatIsAssumed) {
  for (const auto& name : names) {
    std::ifstream file(findCase(name));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_THAT(text, testing::HasSubstr("assumed")) << name;
    EXPECT_THAT(text, testing::HasSubstr("paper")) << name;
  }
}

// Paper, section 3.1: a defect of about 50 mm, a next wave of about 40 mm, sampled every 5 mm.
TEST(ShippedCases, LightDefectHasThePapersLengths) {
  const DefectSurface surface(loadCase("light-defect").defect);
  EXPECT_DOUBLE_EQ(surface.first(), -0.025);
  EXPECT_DOUBLE_EQ(surface.last(), 0.025 + 0.040);
  EXPECT_DOUBLE_EQ(surface.profileSpacing(), 0.005);
  EXPECT_DOUBLE_EQ(surface.depth(), 0.00015);
}

TEST(ShippedCases, SquatsAreThePapersAndTheModifiedIsDeeperAndLonger) {
  const Defect squat = loadCase("class-c-squat").defect, modified = loadCase("class-c-squat-modified").defect;
  EXPECT_EQ(squat.length, 0.057);
  EXPECT_EQ(squat.waveLength, 0.027);
  EXPECT_GT(modified.length, squat.length);
  EXPECT_GT(modified.depth, squat.depth);
}

TEST(ShippedCases, SmoothRailHasNoDefect) {
  const DefectSurface surface(loadCase("smooth-rail").defect);
  EXPECT_EQ(surface.first(), surface.last());
  EXPECT_EQ(surface.height(0), 0);
}

// The two differ in traction alone; the paper's torque brings a warning, a fifth of the load does not.
TEST(ShippedCases, PartialSlipStaysBelowFriction) {
  CaseDescription full = loadCase("light-defect"), partial = loadCase("light-defect-partial-slip");
  EXPECT_EQ(partial.motion.tractionCoefficient, 0.2);
  EXPECT_EQ(validate(full).warnings.size(), 1u);
  EXPECT_EQ(validate(partial).warnings.size(), 0u);
  partial.motion.tractionCoefficient = full.motion.tractionCoefficient;
  EXPECT_EQ(caseHash(partial), caseHash(full));
}

TEST(ShippedCases, AreFoundInTheFolderOfTheEnvironment) {
  const fs::path folder = fs::path(testing::TempDir()) / "squat-resources";
  fs::create_directories(folder / "cases");
  std::ofstream(folder / "cases" / "mine.toml") << "title = 'mine'\n";
  ASSERT_EQ(::setenv("SQUAT_RESOURCES", folder.c_str(), 1), 0);
  const auto found = shippedCases();
  const std::string title = loadCase("mine").title;
  std::string message;
  try {
    findCase("light-defect");
  } catch (const FileError& error) {
    message = error.what();
  }
  ::unsetenv("SQUAT_RESOURCES");
  fs::remove_all(folder);
  EXPECT_THAT(found, testing::ElementsAre("mine"));
  EXPECT_EQ(title, "mine");
  EXPECT_THAT(message, testing::HasSubstr("one of: mine"));
}

TEST(ShippedCases, NamesCannotLeaveTheFolder) {
  EXPECT_THROW(findCase("../cases/light-defect"), FileError);
  EXPECT_THROW(findCase(""), FileError);
  EXPECT_THROW(findCase("/etc"), FileError);
}

}  // namespace
}  // namespace squat::cases
