// tests/verification/CreepForce.h - creep forces of rolling blocks, creepage counted from free rolling, and what they
// should be.
#pragma once

#include "verification/RollingBlocks.h"

namespace squat::contact {

// F / mu N of pure longitudinal creepage for R 0.46 m on R300 under 87.8 kN, mu 0.3, E 210 GPa, nu 0.3: computed with
// the open-source CONTACT 25.2, 60 x 60 elements, steady rolling.
struct CreepForce {
  double creepage = 0, share = 0;
};
constexpr CreepForce creepForces[6] = {{1e-4, 0.0500}, {5e-4, 0.2347}, {1e-3, 0.4325},
                                       {2e-3, 0.7270}, {3e-3, 0.9024}, {5e-3, 0.9991}};

// Creepages are asked for in ascending order, so that each state starts from the one before.
class CreepCurve {
 public:
  explicit CreepCurve(const RolledCase& with) : blocks_(with) {
    blocks_.press();
    free_ = blocks_.settle(0).share;
    slope_ = (blocks_.settle(small).share - free_) / small;
  }
  double slope() const { return slope_; }                  // of F / mu N at free rolling
  double freeCreepage() const { return -free_ / slope_; }  // at which no force is felt
  double at(double creepage) { return settle(creepage).share; }
  RollingBlocks::Steady settle(double creepage) { return blocks_.settle(freeCreepage() + creepage); }

 private:
  static constexpr double small = 1e-4;
  RollingBlocks blocks_;
  double free_ = 0, slope_ = 0;
};

}  // namespace squat::contact
