// A small result with every member filled, and what reading a result refuses.
#pragma once

#include <cmath>
#include <string>

#include "TemporaryFolder.h"
#include "core/Errors.h"
#include "results/ResultFile.h"

namespace squat::tests {

inline results::RunResult sampleResult(int samples = 300) {
  results::RunResult result;
  result.stem = "sample";
  result.title = "Länge 20 mm";
  result.caseToml = "title = \"sample\"\n" + std::string(100000, '#') + "\n";  // longer than 64 kB
  result.caseHash = "0123abcd";
  result.codeVersion = "0.1.0";
  result.commit = "0123456789ab-changed";
  result.isa = "avx2";
  result.threads = 2;
  result.complete = true;
  result.stopReason = "done";
  result.created = "2026-01-02T03:04:05Z";
  result.speed = 30;
  result.warnings = {"first warning", "second warning"};
  for (int i = 0; i < samples; ++i) {
    result.time.push_back(i / 25000.0);
    result.position.push_back(-0.3 + i * 30 / 25000.0);
  }
  for (const char* name : {"wheel_speed", "aba", "contact_force"}) {  // not in the order of the alphabet
    results::Channel channel{name, "m/s2", std::string("what ") + name + " is", {}};
    for (int i = 0; i < samples; ++i) channel.values.push_back(std::sin(0.1 * i) / 3 * (name[0] - 'a' + 1));
    result.signals.push_back(channel);
  }
  result.frequency = {0, 100, 200};
  result.psd = {1, 2, 3};
  result.psdWheel = {4, 5, 6};
  result.psdWindow = "Hann";
  result.psdFrom = -0.1;
  result.psdTo = 0.28;
  result.scalogramFrequency = {100, 200};
  result.scalogramTime = {0, 0.1, 0.2};
  result.scalogramPosition = {-0.1, 0, 0.1};
  result.scalogramPower = {1, 2, 3, 4, 5, 6};
  result.coneOfInfluence = {500, 100, 500};
  result.profilePosition = {-0.1, 0, 0.1};
  result.profileHeight = {0, -0.0001, 0};
  result.wheelPath = {0, -0.00005, 0};
  result.energyTime = {0, 1e-3};
  result.energy = {{"strain", "J", "", {1, 2}}, {"kinetic", "J", "", {3, 4}}};
  result.equilibrium = {{"contact_force", "N", "vertical", 87759.5}, {"approach", "m", "", 9e-5}};
  result.meshFigures = {{"elements", "1", "", 12345}};
  result.performance = {{"steps", "1", "", 1000}, {"element_updates_per_second", "1/s", "", 4.2e7}};
  result.features = {{"peak", "m/s2", "largest absolute value", 110.25}, {"free_vibration", "s", "", 0.004}};
  result.plasticity = {{"largest_equivalent_strain", "1", "at a point", 3e-3}};
  result.permanent = {{-0.1, 0, 0.1},     {-0.01, 0.01},      {-1e-6, 0, -2e-6, 0, -1e-6, 0},
                      {0, 0.005},         {1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6},
                      {1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6}};
  result.modes = {{345, 0.1, 0.02, 0.01}, {500, 0.2, 0.03, 0.02}};
  result.surface.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  result.surface.quads = {0, 1, 2, 3};
  result.surface.part = {1};
  result.surface.partNames = {"rail", "sleepers"};
  result.surface.springs = {0, 0, 0, 0, 0, -1};
  result.snapshots = {{"equilibrium", 0, -0.3, 0, 0, std::vector<float>(12, 1e-4F), {1, 2, 3, 4}, {}},
                      {"impact", 0.01, 0, 0.3, 0.65, std::vector<float>(12, 2e-4F), {5, 6, 7, 8}, {0, 0, 1, 0}}};
  result.patches = {{"equilibrium",
                     0,
                     -0.3,
                     {0.F, 0.001F},
                     {0.F, 0.F},
                     {1e9F, 9e8F},
                     {1e8F, 0.F},
                     {0.F, 0.F},
                     {0, 1},
                     {1e-6F, 1e-6F}}};
  return result;
}

// What the reader says to a file, or "accepted".
inline std::string refusal(const std::string& path) {
  try {
    results::readResult(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace squat::tests
