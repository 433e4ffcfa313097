// tests/simulation/PlasticRun.h - a run whose rail yields. The yield stress is half of the real one, so that the tiny
// mesh, which smooths the pressure over 5 mm, yields well.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "FixtureCase.h"
#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "simulation/RunCase.h"

namespace squat::tests {

using Overrides = std::vector<std::pair<std::string, std::string>>;

inline cases::CaseDescription softRail(Overrides besides = {}) {
  Overrides values{
      {"motion.run_up", "0.05"}, {"motion.beyond", "0.03"}, {"rail.plastic", "true"}, {"rail.yield_stress", "0.4"}};
  values.insert(values.end(), besides.begin(), besides.end());
  return cases::loadCase(tests::fixtureCase("light-defect"), {"tiny", values});
}

inline simulation::RunOptions plain(int threads = 1) {
  simulation::RunOptions options;
  options.threads = threads;
  options.wheelsetModes = false;
  return options;
}

inline results::RunResult run(const cases::CaseDescription& description,
                              const simulation::RunOptions& options = plain()) {
  Monitor silent;
  return simulation::runCase(description, options, silent);
}

inline const results::RunResult& yielded() {
  static const results::RunResult result = run(softRail());
  return result;
}

inline double scalar(const std::vector<results::Scalar>& list, const std::string& name) {
  for (const auto& item : list)
    if (item.name == name) return item.value;
  ADD_FAILURE() << name << " is missing";
  return 0;
}

}  // namespace squat::tests
