// solver/dynamics/ContactInertia.h - the penalties of closed contact leave the stable step alone.
//
// A stiff penalty raises the highest frequency of the mesh, by a quarter and more, while nothing but it needs the short
// step. So the surface nodes of closed points carry as much more mass as keeps the penalty's own frequencies below
// what the step resolves: with K_c the penalties' stiffness and w = u + beta v what it acts on, central difference is
// stable with the step of the bare mesh where the added mass D satisfies
//   D - (dt^2 + 2 beta dt) / 4 K_c >= 0,
// for then x.(K + K_c) x <= 4 / (dt^2 + 2 beta dt) x.(M + D) x for every x. D is diagonal: by the bound of Gershgorin
// for 3x3 blocks the largest penalty times the node's share in the closed area, twice because the weights of either
// body sum to one. That is some grams in a patch, with the usual penalties what four layers of elements weigh: nothing
// to a wheelset of a thousand kilograms at the frequencies that an axle box feels. The energy balance leaves its motion
// out (millijoules at the 0.4 m/s with which material enters the patch). But tread that leaves the patch of a driven
// wheel moves otherwise than tread that enters, which takes some newtons of force and, times the speed, 45 W: the
// moment
//   sum of r D dv_alpha/dt - a' sum of r^2 D
// is given to the turning reference one step later (Rolling.h); the weight of D is left out.
// Masses that come and go may be heavy only so far: where stiff penalties asked for 30 (tiny) to 150 (draft) layers of
// elements, runs did not close their energy balance or broke off. Beyond ten layers the step is shortened instead
// (StableStep). Where short waves have more inertia, blocks with such nodes have a filter of their own, orthogonal in M
// + D: the effective mass grows by D at least (SelectiveMassScaling.h).
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "contact/RollingContact.h"
#include "core/AlignedVector.h"
#include "model/Model.h"

namespace squat::dynamics {

// The larger of the normal and the tangential penalty [Pa/m]: what the added mass is for.
double stiffestPenalty(const scenario::Scenario& scenario);

// Smallest 4 / (dt^2 + 2 beta dt) [rad2/s2] with which the added mass stays below maximumLayers layers of contact
// elements: D per area = (dt^2 + 2 beta dt) / 4 * 2 k <= maximumLayers * density * size.
constexpr double maximumLayers = 10;
double eigenvalueOfStiffContact(const scenario::Scenario& scenario);

class ContactInertia {
 public:
  // `penalty` [Pa/m]: the larger of normal and tangential. `step`, `beta` [s] of the central difference. Keeps a
  // reference to the model.
  ContactInertia(const model::Model& model, double penalty, double step, double beta);

  // Filled by the contact, then put into effect.
  contact::ClosedArea& closed() { return closed_; }
  // Inverse masses of rail (0) or rim (1) as from inChunks(): takes back what the patch before has left and adds the
  // mass of this one. Two threads may do a side each.
  void apply(int side, double* inverse);
  // For the step in place (BlockStep), of rail (0) and rim (1); filters() until the next apply().
  const int* ownFilter(int side) const { return sides_[side].slotOf.data(); }
  const elasticity::KernelFilter* filters(int side) const { return sides_[side].filters.data(); }
  // [kg] in both bodies together, as last applied.
  double addedMass() const { return sides_[0].added + sides_[1].added; }
  // What closed points add to the wheel: its inertia about the axis [kg m2], and its angular momentum [kg m2/s] against
  // the rolling, sum of r v_alpha, in velocities (state layout) whose bases have turned since by an angle of this
  // cosine and sine.
  double addedInertia() const;
  double addedAngularVelocity(const double* velocity, double cosine, double sine) const;

 private:
  static constexpr int maximum = elasticity::maximumRows * elasticity::maximumStations;
  using Areas = std::array<double, maximum>;  // [m2] per node of a cluster and station
  // A cluster on stations that share their inertia, where the patch touches it.
  struct Touched {
    int key = 0;  // cluster * units + unit of the first station
    int stations = 0;
    Areas areas{};
    std::vector<double> values;  // KernelFilter
    std::vector<float> singleValues;
    bool used = false;
  };
  struct Side {
    const elasticity::SweptBlock* block = nullptr;
    double added = 0;                     // [kg]
    const AlignedVector* mass = nullptr;  // bare, in lines
    int units = 0;                        // of eight stations
    std::vector<int> clusterOf, rankOf;   // per section node: cluster and place in it, or -1
    std::vector<Touched> slots;           // used or free
    std::vector<int> slotOf;              // per key, or -1
    std::vector<elasticity::KernelFilter> filters;
    struct Next {
      int key = 0, stations = 0;
      Areas areas{};
    };
    std::vector<Next> next;
    std::vector<int> nextOf;          // per key: 1 + index into next, 0 where there is none
    std::vector<std::size_t> single;  // heavy nodes outside such blocks
  };
  void applyBlocks(Side& side, double* inverse);
  void weigh(Side& side, Touched& touched, double* inverse) const;

  double massPerArea_;
  std::array<Side, 2> sides_;
  contact::ClosedArea closed_;
};

}  // namespace squat::dynamics
