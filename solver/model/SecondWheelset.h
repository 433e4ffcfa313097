// solver/model/SecondWheelset.h - the bogie's other wheelset, which rolls beside the defect.
//
// Its contact is far from the defect: no mesh of its patch is needed. Each half is what the modes of vibration say
// (WheelsetModes.h), rigid motion first; its wheels stand on Hertz's springs on the same rails, over which a force is
// spread along a stretch that the stations of the rail resolve. Only vertical forces act: no creepage, no lateral
// motion, the tread round, no damper in the bearing.
//
// Of a whole model motions are sums of symmetric and antisymmetric ones, left = s + a, right = s - a (CentrePlane.h).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/WheelsetModes.h"

namespace squat::model {

struct Model;

// Motions of one symmetry. Rigid motion: by how much the wheel of the left side rises, and with it the axle box.
struct SecondMotions {
  double rigidMass = 0;             // [kg] over one half, at the wheel
  double boxLever = 1;              // rise of the axle box over that of the wheel
  std::vector<HarmonicMode> modes;  // that a vertical force excites
};

struct SecondWheelset {
  double offset = 0;                    // [m] x from the first wheelset
  double hertz = 0;                     // [N/m^1.5] force = hertz approach^1.5
  double approach(double force) const;  // [m] of wheel and rail, by Hertz's spring
  double halfLength = 0;                // [m] of the patch at rest
  double spread = 0;                    // [m] half of the stretch of rail that a wheel's force is spread over
};

// Of the case of a model, whose rail has been meshed.
SecondWheelset secondWheelset(const Model& model);
// Symmetric motions; antisymmetric ones behind them where the case has both rails.
std::vector<SecondMotions> secondMotions(const scenario::Scenario& scenario);

// [m] How far stations along the second wheelset's path may lie apart, and how far the path's fine stretch reaches
// beyond where its wheels roll.
inline constexpr double secondPathSize = 0.020, secondPathMargin = 0.10;

// [N] Load of the second wheelset's wheels at rest, by statics: of the left and, in a whole model, the right side.
// `sides` left first.
std::vector<double> secondLoads(std::span<const scenario::Scenario* const> sides);

// A wheel of the second wheelset on the rail of its side: the vertical displacement of the running surface below it is
// a weighted mean over nodes where it touches, raised cosine along the rail.
class SecondRailSeat {
 public:
  explicit SecondRailSeat(const Model& model);

  void moveTo(double x);                                   // [m]
  double mean(const double* state) const;                  // upwards, of displacements or velocities
  void addToForces(double upwards, double* forces) const;  // [N], force buffer of the model
  void addToState(double upwards, double* state) const;    // the same, state layout

 private:
  template <typename Work>
  void forEach(const Work& work) const;

  const Model& model_;
  double spread_;
  std::vector<std::pair<int, double>> nodes_;  // section nodes and their weights, which sum to 1
  int first_ = 0;
  std::vector<double> weight_;  // of the stations from first_ on, which sum to 1
};

}  // namespace squat::model
