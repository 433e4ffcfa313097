// tests/FixtureCase.h - cases of the tests' own (tests/fixtures), which stay as they are when shipped cases improve.
#pragma once

#include <string>

namespace squat::tests {

// Path of tests/fixtures/cases/NAME.toml, for cases::loadCase.
inline std::string fixtureCase(const std::string& name) {
  return std::string(SQUAT_SOURCE_DIR "/tests/fixtures/cases/") + name + ".toml";
}

}  // namespace squat::tests
