// What moves wheel, track and contact calls no function of the system whose last bit differs from one to the next
// (core/ElementaryFunctions.h). Powers and logarithms are excepted: levels in dB, progress, the mean height of a
// tapered sleeper, and the recovery of back-stresses in a yielding layer. Runs with these may differ by round-off.
#include <gmock/gmock.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "arch/SourceTree.h"

namespace squat::arch {
namespace {

std::vector<std::string> functionsOfTheSystem(const std::string& code) {
  static const std::regex call(
      R"(std::(sin|cos|tan|sinh|cosh|tanh|asin|acos|atan|atan2|exp|exp2|expm1|cbrt|hypot|polar)\s*\()");
  std::vector<std::string> found;
  for (std::sregex_iterator i(code.begin(), code.end(), call), end; i != end; ++i) found.push_back((*i)[1]);
  return found;
}

TEST(SameBits, MechanicsCallsNoFunctionsOfTheSystem) {
  const std::set<std::string> mechanics{"contact", "dynamics",   "elasticity", "forces",     "geometry",
                                        "model",   "plasticity", "scenario",   "simulation", "statics"};
  std::vector<std::string> list;
  std::set<std::string> folders;
  for (const auto& file : readSources(SQUAT_SOURCE_DIR, {"solver"})) {
    if (!mechanics.count(file.folder)) continue;
    folders.insert(file.folder);
    for (const auto& name : functionsOfTheSystem(file.code))
      list.push_back(file.path + " calls std::" + name + "; use elementary::" + name);
  }
  EXPECT_THAT(list, ::testing::IsEmpty());
  EXPECT_EQ(folders, mechanics);
}

TEST(SameBits, CallsAreFound) {
  EXPECT_THAT(functionsOfTheSystem("a = std::sin(x) + elementary::cos(x) + std::sqrt(x) * std::hypot (x, y);"),
              ::testing::ElementsAre("sin", "hypot"));
}

}  // namespace
}  // namespace squat::arch
