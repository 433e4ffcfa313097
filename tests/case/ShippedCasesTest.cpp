// The cases that come with the program: all there, valid, and with the paper's numbers.
#include "case/ShippedCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "case/Validation.h"
#include "core/Errors.h"
#include "scenario/DefectSurface.h"

namespace squat::cases {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> names{"class-c-squat",
                                     "class-c-squat-modified",
                                     "light-defect",
                                     "light-defect-full-torque",
                                     "light-defect-partial-slip",
                                     "light-defect-long-overhang",
                                     "smooth-rail"};
// Those of the paper, with the inputs that were estimated from it.
const std::vector<std::string> estimated{
    "class-c-squat", "class-c-squat-modified", "light-defect", "light-defect-full-torque", "light-defect-partial-slip",
    "smooth-rail"};

std::string textOf(const std::string& name) {
  std::ifstream file(findCase(name));
  return {std::istreambuf_iterator<char>(file), {}};
}

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
    EXPECT_THAT(textOf(name), testing::AnyOf(testing::HasSubstr("assumed"), testing::HasSubstr("estimated"))) << name;
    EXPECT_THAT(textOf(name), testing::HasSubstr("paper")) << name;
  }
}

// Paper, section 3.1: a defect of about 50 mm, a next wave of about 40 mm, sampled every 5 mm.
TEST(ShippedCases, TheDrawnLightDefectHasThePapersLengths) {
  const DefectSurface surface(loadCase("light-defect-long-overhang").defect);
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

// One wheelset and one sleeper for all cases of the paper; each estimated value is marked as one. The sleeper keeps the
// paper's 244 kg; 0.1 kg is the rounding of its sizes.
TEST(ShippedCases, ThePapersCasesShareTheirEstimatedInputs) {
  const auto first = loadCase("light-defect");
  const auto& s = first.sleeper;
  EXPECT_NEAR(2 * s.halfLength * s.width * s.height * s.material.density, 244, 0.1);
  EXPECT_EQ(first.track.defectFromSleeper, 0.154);
  for (const auto& name : estimated) {
    const auto description = loadCase(name);
    const auto text = textOf(name);
    for (const auto& parameter : parameterTable()) {
      if (parameter.group != "wheelset" && parameter.group != "sleeper") continue;
      EXPECT_EQ(valueText(description, parameter), valueText(first, parameter)) << name << ": " << parameter.key;
      if (valueText(description, parameter) == defaultTextOf(parameter)) continue;
      const auto key = parameter.key.substr(parameter.key.find('.') + 1);
      EXPECT_THAT(text, testing::ContainsRegex("\n" + key + " = [^\n]*# [^\n]*estimated by hand")) << name;
    }
  }
}

// Only the case that shows the paper's torque exceeds the adhesion limit; no shipped case states a key without effect.
TEST(ShippedCases, WarnOfNothingButThePapersTorque) {
  for (const auto& name : shippedCases()) {
    const auto warnings = validate(loadCase(name)).warnings;
    if (name != "light-defect-full-torque") {
      for (const auto& warning : warnings) ADD_FAILURE() << name << ": " << toWarning(warning);
      continue;
    }
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].key, "motion.torque") << toWarning(warnings[0]);
    EXPECT_EQ(loadCase(name).motion.torque, 12450.49);
    EXPECT_THAT(textOf(name), testing::HasSubstr("adhesion limit"));
  }
}

TEST(ShippedCases, SmoothRailHasNoDefect) {
  const DefectSurface surface(loadCase("smooth-rail").defect);
  EXPECT_EQ(surface.first(), surface.last());
  EXPECT_EQ(surface.height(0), 0);
}

// The two differ in the torque alone.
TEST(ShippedCases, FullTorqueIsTheLightDefectWithThePapersTorque) {
  const CaseDescription within = loadCase("light-defect");
  CaseDescription full = loadCase("light-defect-full-torque");
  EXPECT_LT(within.motion.torque, full.motion.torque);
  full.motion.torque = within.motion.torque;
  EXPECT_EQ(caseHash(full), caseHash(within));
}

// The two differ in traction alone, which stays below friction.
TEST(ShippedCases, PartialSlipStaysBelowFriction) {
  CaseDescription full = loadCase("light-defect"), partial = loadCase("light-defect-partial-slip");
  EXPECT_EQ(partial.motion.tractionCoefficient, 0.2);
  EXPECT_EQ(validate(partial).warnings.size(), 0u);
  partial.motion.tractionCoefficient = full.motion.tractionCoefficient;
  partial.motion.torque = full.motion.torque;
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
