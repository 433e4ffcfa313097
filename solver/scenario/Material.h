// solver/scenario/Material.h - an elastic material.
#pragma once

namespace squat::scenario {

struct Material {
  double young = 0, poisson = 0, density = 0;  // [Pa], [-], [kg/m3]
};

}  // namespace squat::scenario
