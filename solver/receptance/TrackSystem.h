// solver/receptance/TrackSystem.h - the assembled track without the wheelset: rail in section shapes, sleepers, pads,
// ballast and rail ends, the same elements, force elements and lumped masses as in the rolling run.
#pragma once

#include <vector>

#include "receptance/BlockMatrix.h"
#include "receptance/SectionShapes.h"

namespace squat::receptance {

// What moves as its mirror image about the track centre, and what moves against it.
enum class TrackSymmetry { symmetric, antisymmetric };

// Parts of the track whose stiffness depends on the frequency in its own way.
enum class TrackPart { rail, sleepers, padsVertical, padsHorizontal, ballast, others };
inline constexpr std::size_t trackParts = 6;

// Which way a force acts on the rail and its motion is read: downwards, or outwards from the track centre.
enum class RailDirection { vertical, lateral };

// A hammer strikes one rail. The half model is one half of a track that moves as its mirror image, both rails struck
// alike, as in the rolling run; what one struck rail answers is half the sum of that solution and of the antisymmetric
// one, with another condition in the middle of the sleepers. Sleepers bend and rock in both.
enum class StruckRails { one, both };

inline constexpr double loadedSquare = 0.010;  // [m] of the running surface over which a vertical force is spread

// The solutions whose mean is the answer.
std::vector<TrackSymmetry> symmetriesOf(StruckRails rails);

class TrackSystem {
 public:
  TrackSystem(const model::Model& model, const SectionShapes& railShapes,
              TrackSymmetry symmetry = TrackSymmetry::symmetric);
  TrackSystem(const TrackSystem&) = delete;
  TrackSystem& operator=(const TrackSystem&) = delete;

  const Groups& groups() const { return groups_; }
  // The dynamic stiffness as a sum: parts with a loss factor, or pads by their measured stiffness, are complex and have
  // no dashpots (scenario/Track.h).
  std::vector<HarmonicTerm> terms() const;
  // The same without pads: the sleepers by themselves on their ballast.
  std::vector<HarmonicTerm> termsWithoutPads() const;

  // Groups of the first and of the last station of the rail: where a cell of a periodic track meets the next.
  std::vector<int> firstStation() const { return railStation(0); }
  std::vector<int> lastStation() const;

  // 1 N downwards, spread evenly over a square of the running surface above the rail's axis at `position` [m].
  Eigen::VectorXd load(double position, double side = loadedSquare) const;
  // Mean displacement of the rail's section there, weighed by mass, downwards.
  Eigen::VectorXd sectionMean(double position) const;
  // The same of the rail's head alone, in either direction. As a load: 1 N spread over the head.
  Eigen::VectorXd headMean(double position, RailDirection direction) const;
  // Mean downward displacement of the first sleeper's top under its pad; as a load, 1 N spread there.
  Eigen::VectorXd sleeperSeat() const;

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
  std::vector<HarmonicTerm> termsOf(bool pads) const;
  void addForceElements(const forces::ForceElements& set);
  TrackPart partOf(const forces::ForceElements& set, std::size_t element) const;
  void fix(std::size_t index);
  void fixCentre(TrackSymmetry symmetry);
  std::vector<int> railStation(int station) const;
  Eigen::VectorXd meanOf(double position, double lowest, const Eigen::Vector3d& direction) const;
  BlockMatrix& stiffness(TrackPart part) { return stiffness_[static_cast<std::size_t>(part)]; }
  BlockMatrix& damping(TrackPart part) { return damping_[static_cast<std::size_t>(part)]; }

  const model::Model& model_;
  Groups groups_;
  std::vector<Part> parts_;
  std::vector<BlockMatrix> stiffness_, damping_;  // one a part
  BlockMatrix mass_;
};

}  // namespace squat::receptance
