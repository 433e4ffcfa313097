// solver/model/Centre.h - how the halves of the model move to each other where they meet at the track centre
// (CentrePlane.h).
#pragma once

namespace squat::model {

enum class Centre {
  symmetric,      // a mirror: what crosses the plane does not move along y
  antisymmetric,  // what crosses the plane moves along y only
  shared          // free: whoever steps both halves joins them (joinAtCentre)
};

}  // namespace squat::model
