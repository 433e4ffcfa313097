// tests/keys/Keys.h - scenarios and models that differ from the tests' smooth rail by the keys given.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "model/Model.h"

namespace squat::tests {

using Values = std::vector<std::pair<std::string, std::string>>;

inline scenario::Scenario scenarioWith(const Values& values) {
  return cases::loadScenario(fixtureCase("smooth-rail"), {"tiny", values});
}

inline model::Model modelWith(const Values& values) { return model::buildModel(scenarioWith(values)); }

}  // namespace squat::tests
