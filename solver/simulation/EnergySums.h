// solver/simulation/EnergySums.h - energies of all nodes, summed by the threads of the run.
//
// Each node's sum runs along its stations, the sum of all nodes in their order: the same bits for any number of
// threads.
#pragma once

#include <array>
#include <vector>

#include "dynamics/Rolling.h"

namespace squat::simulation {

class EnergySums {
 public:
  // Keeps a reference to the model.
  explicit EnergySums(const dynamics::Rolling& rolling);

  struct Solids {
    double rail = 0, wheelset = 0, sleepers = 0;
    double sum() const { return rail + wheelset + sleepers; }
  };
  // x . K x per kind of solid, K the bare solids. `x`: state layout; its tied nodes and ghost stations are filled.
  Solids quadratic(const dynamics::Rolling& rolling, AlignedVector& x);
  // [J] What the weight of solids, sprung mass and axle box does over `displacement` [m].
  double workOfWeight(const dynamics::Rolling& rolling, const AlignedVector& displacement);
  struct Motion {
    double energy = 0, momentum = 0;  // [J]; [kg m/s] along x
  };
  // Of the solids, from the velocities.
  Motion motion(const dynamics::Rolling& rolling);

 private:
  struct Nodes {
    int block = 0, first = 0, last = 0;
  };
  template <typename Sum>
  void forEachNode(ThreadTeam& team, const Sum& sum);
  std::vector<Nodes> groups_;                // all nodes of all blocks, some tens together
  std::vector<std::size_t> firstRow_;        // per block
  std::vector<std::array<double, 3>> rows_;  // sums of each node
  std::vector<std::vector<elasticity::Segment>> work_;
  std::vector<std::unique_ptr<elasticity::KernelScratch>> scratch_;
  AlignedVector force_, tieWorkspace_;
};

}  // namespace squat::simulation
