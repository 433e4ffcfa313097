// tests/app/MadeUpPaperRun.h - a made-up run that carries one of the paper's cases; no mechanics in it.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "results/RunResult.h"

namespace squat::tests {

struct Wave {
  double height = 0, frequency = 0;  // [m/s2], [Hz]
};

// Waves that fade after the impact at x = 0; one of 1000 Hz is 30 m/s / 1000 Hz = 30 mm long. From -0.3 to 0.9 m.
inline results::RunResult madeUpPaperRun(const std::string& name, const std::vector<Wave>& waves) {
  results::RunResult result;
  result.stem = name;
  results::setCase(result, cases::loadCase(name, {"tiny", {}}));
  result.complete = true;
  result.speed = 30;
  const int samples = 1000;
  results::Channel aba{"aba_filtered", "m/s2", "", {}};
  for (int i = 0; i < samples; ++i) {
    const double time = i / 25000.0, position = -0.3 + 30 * time, after = time - 0.01;
    result.time.push_back(time);
    result.position.push_back(position);
    double value = 0.001 * std::sin(i);
    if (after >= -1e-9) {
      value = 0;
      for (const auto& wave : waves)
        value += wave.height * std::exp(-after / 0.01) * std::cos(2 * std::numbers::pi * wave.frequency * after);
    }
    aba.values.push_back(value);
  }
  result.signals.push_back(aba);
  result.performance = {{"energy_residual", "1", "", 0.0005}};
  result.equilibrium = {{"half_axis_rolling", "m", "", 7.0e-3}, {"hertz_half_axis_rolling", "m", "", 6.8e-3}};
  result.meshFigures = {{"elements", "1", "", 13710}};
  result.modes = {{345, 0.1, 0.02, 0.01}};
  return result;
}

}  // namespace squat::tests
