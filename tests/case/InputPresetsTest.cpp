// wheelset.preset and track.preset: what they set, what overrides them, and that a written case keeps its values.
// Expected values stand in the files of resources/presets and are repeated here by hand.
#include "case/InputPresets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "case/ShippedCases.h"
#include "case/Validation.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;
using Overrides = std::vector<std::pair<std::string, std::string>>;

CaseDescription parsed(const std::string& text, const Overrides& set = {}) {
  return parseCase(text, "test", {}, {{}, set});
}

std::string valueOf(const CaseDescription& description, const char* key) {
  return valueText(description, *findParameter(key));
}

TEST(InputPresets, NamesAreThoseOfTheFiles) {
  for (const char* key : inputPresetKeys) {
    const std::string group = std::string(key).substr(0, std::string(key).find('.'));
    std::vector<std::string> files{noPreset};
    for (const auto& entry : std::filesystem::directory_iterator(resourcesFolder() / "presets" / group))
      files.push_back(entry.path().stem().string());
    EXPECT_THAT(inputPresetNames(key), testing::UnorderedElementsAreArray(files));
  }
}

// Each value has its source beside it, or what it stands for.
TEST(InputPresets, EveryValueHasItsSource) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(resourcesFolder() / "presets")) {
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (line.find('=') != std::string::npos && line.front() != '#') {
        EXPECT_NE(line.find('#'), std::string::npos) << entry.path() << ": " << line;
      }
  }
}

TEST(InputPresets, EveryOneMakesAGoodCase) {
  for (const char* key : inputPresetKeys)
    for (const auto& name : inputPresetNames(key)) {
      CaseDescription description = defaultCase();
      applyInputPreset(description, key, name);
      for (const auto& problem : validate(description).problems) ADD_FAILURE() << name << ": " << toText(problem);
    }
}

TEST(InputPresets, KeysOfTheCaseOverrideItsPreset) {
  const auto c = parsed(
      "[wheelset]\naxle_radius = 82\npreset = \"trailer\"\n[pad]\nstiffness = 400\n"
      "[track]\npreset = \"soft-pads\"");
  EXPECT_EQ(valueOf(c, "wheelset.preset"), "trailer");
  EXPECT_EQ(valueOf(c, "wheelset.axle_radius"), "82");
  EXPECT_EQ(valueOf(c, "wheelset.axle_box_mass"), "120");
  EXPECT_EQ(valueOf(c, "suspension.damping"), "2.5");
  EXPECT_EQ(valueOf(c, "suspension.stiffness"), "1.2");
  EXPECT_EQ(valueOf(c, "pad.stiffness"), "400");
  EXPECT_EQ(valueOf(c, "pad.damping"), "28");
  EXPECT_EQ(valueOf(c, "ballast.damping"), "47");
}

// It takes the place of the file's: what that one had set is gone, what the file states itself stays, and single --set
// keys come last, in whatever order they are typed.
TEST(InputPresets, TheCommandLineReplacesThePreset) {
  const std::string file = "[wheelset]\npreset = \"estimated\"\njournal_radius = 70\naxle_box_mass = 121";
  const auto c = parsed(file, {{"wheelset.bearing_width", "150"}, {"wheelset.preset", "trailer"}});
  EXPECT_EQ(valueOf(c, "wheelset.preset"), "trailer");
  EXPECT_EQ(valueOf(c, "wheelset.bearing_centre"), "250");
  EXPECT_EQ(valueOf(c, "wheelset.journal_radius"), "70");
  EXPECT_EQ(valueOf(c, "wheelset.bearing_width"), "150");
  // What the file states as its own preset has it counts as not stated.
  EXPECT_EQ(valueOf(c, "wheelset.axle_box_mass"), "120");
  const auto none = parsed(file, {{"wheelset.preset", "none"}});
  EXPECT_EQ(valueOf(none, "wheelset.bearing_centre"), "250");
  EXPECT_EQ(valueOf(none, "wheelset.total_mass"), "950");
  EXPECT_EQ(valueOf(none, "wheelset.journal_radius"), "70");
}

TEST(InputPresets, TheCommandLineActsOnWrittenCases) {
  const auto plain = writeCase(defaultCase());
  const auto c = parsed(plain, {{"track.preset", "soft-pads"}});
  EXPECT_EQ(valueOf(c, "pad.stiffness"), "200");
  EXPECT_EQ(valueOf(c, "sleeper.height"), "0.152");
}

// The cases that carry the estimated values name them, so that another preset takes their place.
TEST(InputPresets, ShippedCasesGiveWay) {
  const auto estimated = loadCase("light-defect"),
             trailer = loadCase("light-defect", {{}, {{"wheelset.preset", "trailer"}}});
  EXPECT_EQ(valueOf(estimated, "wheelset.preset"), "estimated");
  EXPECT_EQ(valueOf(estimated, "wheelset.total_mass"), "896");
  EXPECT_EQ(valueOf(estimated, "sleeper.height"), "0.194");
  CaseDescription expected = estimated;
  applyInputPreset(expected, "wheelset.preset", "trailer");
  EXPECT_EQ(writeCase(trailer), writeCase(expected));
}

TEST(InputPresets, AnUnknownNameBringsTheListAndTheNearest) {
  for (const bool inFile : {true, false}) {
    try {
      inFile ? parsed("[wheelset]\npreset = \"trailor\"") : parsed("", {{"wheelset.preset", "trailor"}});
      FAIL();
    } catch (const CaseError& error) {
      EXPECT_THAT(error.what(), HasSubstr("none, estimated, trailer"));
      EXPECT_THAT(error.what(), HasSubstr("Did you mean trailer?"));
    }
  }
}

// Values are written in full, and the name changes none of them: also where the preset's file is not there, or says
// something else by then.
TEST(InputPresets, AWrittenCaseReadsBackTheSame) {
  auto c = parsed("[wheelset]\npreset = \"trailer\"\nweb_thickness = 30\n[track]\npreset = \"stiff-pads\"");
  c.wheelset.brakeDiscMass = 101.0 / 3;
  const auto text = writeCase(c);
  EXPECT_EQ(writeCase(parsed(text)), text);
  const auto nowhere = std::filesystem::path(testing::TempDir()) / "no-presets";
  std::filesystem::create_directories(nowhere);
  ASSERT_EQ(setenv("SQUAT_RESOURCES", nowhere.c_str(), 1), 0);
  EXPECT_EQ(writeCase(parseCaseOfResult(text, "test")), text);
  EXPECT_THROW(parsed("[wheelset]\npreset = \"trailer\""), FileError);
  unsetenv("SQUAT_RESOURCES");
}

// The hash stands for what the physics sees.
TEST(InputPresets, TheNameIsNotHashed) {
  auto named = parsed("[track]\npreset = \"soft-pads\""), spelt = named;
  spelt.trackPreset = noPreset;
  EXPECT_EQ(caseHash(named), caseHash(spelt));
  EXPECT_NE(caseHash(named), caseHash(defaultCase()));
}

// Neither is what has no effect: a case of before the keys keeps its hash.
TEST(InputPresets, KeysWithoutEffectAreNotHashed) {
  for (const auto& [key, text] : Overrides{{"sleeper.middle_half_length", "0.2"},
                                           {"wheelset.brake_disc_mass", "70"},
                                           {"wheelset.brake_disc_position", "300"}}) {
    CaseDescription changed = defaultCase();
    setValue(changed, key, text);
    EXPECT_EQ(caseHash(changed), caseHash(defaultCase())) << key;
    setValue(changed, "sleeper.middle_height", "0.1"), setValue(changed, "wheelset.brake_discs", "1");
    CaseDescription other = changed;
    setToDefault(other, *findParameter(key));
    EXPECT_NE(caseHash(changed), caseHash(other)) << key;
  }
}

}  // namespace
}  // namespace squat::cases
