// tests/RandomWheelsets.h - wheelsets of any shape that the parameter table and its relations allow.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "case/Validation.h"

namespace squat::tests {

using KeyValues = std::vector<std::pair<std::string, std::string>>;

// Every length of the wheelset evenly within its range; those that break a relation are drawn again. The mass follows
// from the shape.
class RandomWheelsets {
 public:
  explicit RandomWheelsets(unsigned long seed) : random_(seed) {
    for (const auto& parameter : cases::parameterTable())
      if (parameter.group == "wheelset" && parameter.kind == cases::Kind::number &&
          (parameter.unit == "mm" || parameter.unit == "m"))
        lengths_.push_back(&parameter);
  }

  KeyValues next() {
    auto description = cases::loadCase(fixtureCase("smooth-rail"), {"tiny", {{"wheelset.total_mass", "0"}}});
    for (;;) {
      KeyValues values{{"wheelset.total_mass", "0"}};
      for (const auto* length : lengths_) {
        const double share = std::uniform_real_distribution<double>(0, 1)(random_);
        values.emplace_back(length->key,
                            cases::formatDecimal(length->minimum + share * (length->maximum - length->minimum)));
        cases::setValue(description, length->key, values.back().second);
      }
      const auto findings = cases::validateRelations(description);
      if (std::none_of(findings.begin(), findings.end(),
                       [](const auto& finding) { return finding.severity == cases::Severity::problem; }))
        return values;
    }
  }

 private:
  std::mt19937_64 random_;
  std::vector<const cases::Parameter*> lengths_;
};

}  // namespace squat::tests
