// solver/detection/AxleSides.h - on which rail the defect is that both axle boxes of a wheelset feel.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "detection/Example.h"
#include "detection/FirstArrival.h"

namespace squat::detection {

enum class RailSide { left, right, both };
std::string toText(RailSide side);

struct SideJudgement {
  std::array<double, 3> probability{};  // of each RailSide

  RailSide side() const;
  double sureness() const;  // probability of side()
};

// Of defects on one rail, the logarithm of the ratio of the boxes' first energies is taken to be normal over vehicles,
// tracks and defects; defects on both rails are pairs of such passages of one vehicle, whose energies add. Bayes' rule
// gives the side. Noise adds to the energies, with the scatter that a stretch so short brings.
class AxleSides {
 public:
  // Needs ten examples with a first arrival (Example.h), of three vehicles; with fewer, nothing is known.
  explicit AxleSides(const std::vector<Example>& examples);
  AxleSides() = default;

  bool isKnown() const { return known_; }
  // `arrival`: of the left box and the right one.
  SideJudgement judge(const FirstArrival& arrival, Kind kind) const;

 private:
  struct Ratio {  // log10 of the energy here by that of the other side
    double mean = 0, spread = 1;
  };
  static double density(const FirstArrival& arrival, std::size_t struck, const Ratio& ratio);

  Ratio oneRail_, bothRails_;
  bool known_ = false;
};

}  // namespace squat::detection
