// Every key of the parameter table is named in a test that shows what it does: in the folders whose tests compute.
// Tests that read, write, check or show keys (case, gui, app, studies, fuzz) do not count, nor do those that hold the
// paper's numbers (statements).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "case/ParameterTable.h"

namespace squat {
namespace {

constexpr const char* kFolders[] = {"contact", "dynamics",   "elasticity", "forces",      "geometry",
                                    "keys",    "simulation", "statics",    "verification"};

std::string sourcesOf(const char* folder) {
  std::string all;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SQUAT_SOURCE_DIR "/tests/") + folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    if (entry.path().filename() == "EveryKeyTest.cpp") continue;
    std::ifstream file(entry.path());
    all.append(std::istreambuf_iterator<char>(file), {});
  }
  return all;
}

std::vector<std::string> keysWithoutATest(const std::string& sources) {
  std::vector<std::string> missing;
  for (const auto& parameter : cases::parameterTable())
    if (sources.find('"' + parameter.key + '"') == std::string::npos) missing.push_back(parameter.key);
  return missing;
}

TEST(EveryKey, IsNamedInATestThatShowsWhatItDoes) {
  std::string sources;
  for (const char* folder : kFolders) sources += sourcesOf(folder);
  EXPECT_THAT(keysWithoutATest(sources), testing::IsEmpty()) << "add what it does to tests/keys";
}

TEST(EveryKey, IsMissedWhereNoTestNamesIt) {
  EXPECT_EQ(keysWithoutATest("").size(), cases::parameterTable().size());
  EXPECT_THAT(keysWithoutATest("\"pad.stiffness\""), testing::Not(testing::Contains("pad.stiffness")));
}

}  // namespace
}  // namespace squat
