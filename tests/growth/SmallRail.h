// tests/growth/SmallRail.h - the tiny mesh of the light defect, for tests that need a rail but no rolling.
#pragma once

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "growth/Grow.h"
#include "growth/RailSurface.h"
#include "growth/RollingTraffic.h"
#include "model/Model.h"

namespace squat::tests {

// One freely rolling wheelset without torque stands for the traffic.
inline cases::CaseDescription growingDefect(std::vector<std::pair<std::string, std::string>> besides = {}) {
  std::vector<std::pair<std::string, std::string>> values{
      {"motion.torque", "0"}, {"growth.wheelsets", "1"}, {"mesh.zone_before", "70"}, {"mesh.zone_behind", "110"}};
  values.insert(values.end(), besides.begin(), besides.end());
  return cases::loadCase(fixtureCase("light-defect"), {"tiny", values});
}

inline const model::Model& smallModel() {
  static const auto model =
      model::buildModel(cases::resolve(growth::growingCase(growingDefect({{"rail.plastic", "true"}}))));
  return model;
}

inline growth::SurfaceGrid smallGrid() {
  auto grid = growth::surfaceGrid(smallModel(), -0.07, 0.11);
  grid.taper = growth::fadingLength;
  grid.referenceFrom = grid.x.front() + growth::endEffect, grid.referenceTo = grid.referenceFrom + growth::fadingLength;
  return grid;
}

}  // namespace squat::tests
