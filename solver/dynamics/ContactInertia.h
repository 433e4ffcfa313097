// solver/dynamics/ContactInertia.h - the penalties of closed contact leave the stable step alone.
//
// A stiff penalty raises the highest frequency of the mesh, by a quarter and more, while nothing but it needs the short
// step. So the surface nodes of closed points carry as much more mass as keeps the penalty's own frequencies below
// what the step resolves: with K_c the penalties' stiffness and w = u + beta v what it acts on, central difference is
// stable with the step of the bare mesh where the added mass D satisfies
//   D - (dt^2 + 2 beta dt) / 4 K_c >= 0,
// for then x.(K + K_c) x <= 4 / (dt^2 + 2 beta dt) x.(M + D) x for every x. D is diagonal: by the bound of Gershgorin
// for 3x3 blocks the largest penalty times the node's share in the closed area, twice because the weights of either
// body sum to one. That is one to three grams in a patch, about what the layer of elements under it weighs: nothing to
// a wheelset of a thousand kilograms at the frequencies that an axle box feels. The energy ledger leaves its motion out
// (half a millijoule at the 0.4 m/s with which material enters the patch).
#pragma once

#include <array>
#include <vector>

#include "contact/RollingContact.h"
#include "elasticity/SweptWork.h"

namespace squat::dynamics {

class ContactInertia {
 public:
  // `penalty` [Pa/m]: the larger of normal and tangential. `step`, `beta` [s] of the central difference.
  ContactInertia(const elasticity::SweptBlock& rail, const elasticity::SweptBlock& rim, double penalty, double step,
                 double beta);

  // Filled by the contact, then put into effect.
  contact::ClosedArea& closed() { return closed_; }
  // Inverse masses of both blocks as from inChunks(): takes back what the patch before has left and adds the mass of
  // this one.
  void apply(double* railInverse, double* rimInverse);
  double addedMass() const { return added_; }  // [kg] in both bodies together, as last applied

 private:
  struct Heavy {
    std::size_t place = 0;
    double bare = 0, area = 0;  // inverse mass without contact; [m2]
  };
  struct Side {
    int nodes = 0;
    std::vector<int> heavyAt;  // per place: 1 + index into heavy, 0 where light
    std::vector<Heavy> heavy;
  };
  void applySide(Side& side, const std::vector<contact::AreaShare>& shares, double* inverse);

  double massPerArea_;
  double added_ = 0;
  std::array<Side, 2> sides_;
  contact::ClosedArea closed_;
};

}  // namespace squat::dynamics
