// solver/receptance/TrackSystem.h - the assembled track without the wheelset: rail in section shapes, sleepers, pads,
// ballast and rail ends, the same elements, force elements and lumped masses as in the rolling run.
#pragma once

#include <vector>

#include "receptance/BlockMatrix.h"
#include "receptance/SectionShapes.h"

namespace squat::receptance {

class TrackSystem {
 public:
  TrackSystem(const model::Model& model, const SectionShapes& railShapes);
  TrackSystem(const TrackSystem&) = delete;
  TrackSystem& operator=(const TrackSystem&) = delete;

  const Groups& groups() const { return groups_; }
  const BlockMatrix& stiffness() const { return stiffness_; }
  const BlockMatrix& damping() const { return damping_; }
  const BlockMatrix& mass() const { return mass_; }

  // 1 N downwards, spread evenly over a square of the running surface above the rail's axis at `position` [m].
  Eigen::VectorXd load(double position, double side) const;
  // Mean downward displacement of the rail's section there, weighed by mass.
  Eigen::VectorXd sectionMean(double position) const;

 private:
  struct Part {
    int block = 0, firstGroup = 0;
    SectionShapes shapes;
  };
  // What a weighted sum of unknowns of the state is in the groups of this system.
  std::map<int, Eigen::VectorXd> pieces(const std::vector<std::pair<std::size_t, double>>& terms) const;
  Eigen::VectorXd whole(const std::map<int, Eigen::VectorXd>& pieces) const;
  void addBlock(const Part& part);
  void addHeight(const Part& sleeper);
  void addForceElements(const forces::ForceElements& set);
  void fix(std::size_t index);

  const model::Model& model_;
  Groups groups_;
  std::vector<Part> parts_;
  BlockMatrix stiffness_, damping_, mass_;
};

}  // namespace squat::receptance
