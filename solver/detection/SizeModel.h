// solver/detection/SizeModel.h - how the energies of an event follow from the size of a squat, over many vehicles.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "detection/Example.h"
#include "detection/PathSpectrum.h"

namespace squat::detection {

inline constexpr auto eigenBands = static_cast<Eigen::Index>(bandCount);
using BandValues = Eigen::Matrix<double, eigenBands, 1>;
using BandMatrix = Eigen::Matrix<double, eigenBands, eigenBands>;

// log10 of an event's energies by the square of its speed, y_b, is taken to be
//   y_b = sum_j c_bj p_j + m_b + t_b ln(v / 28 m/s) + u_b + e_b
// p_j: log10 of the energies of a rigid wheel's path over the squat, by the square of the speed, in band b and the
// bands beside it; u, the vehicle and its track: normal over vehicles, with the covariance `betweenVehicles`; e, what
// the path does not say: normal over passages, with the covariance `betweenPassages`. c by ridge regression with an
// offset for each vehicle; the rest from what these leave. An example counts with its weight, a vehicle with the mean
// weight of its squats.
//
// Left out one after the other, vehicles of 15 squats without noise: 85 % of severities are right where the vehicle is
// not known, 87 % where its other passages are.
class SizeModel {
 public:
  // Squats of at least eight vehicles, else it is not known. Where an example does not say its form, the mean of the
  // three forms stands for it.
  explicit SizeModel(const std::vector<Example>& examples);
  SizeModel() = default;

  bool isKnown() const { return known_; }
  // y without u, of squats whose p is given.
  BandValues expected(const BandValues& path, double speed) const;
  const BandMatrix& betweenVehicles() const { return betweenVehicles_; }
  const BandMatrix& betweenPassages() const { return betweenPassages_; }
  // u of a vehicle among the examples; nothing for another.
  const BandValues* deviation(const std::string& vehicle) const;

 private:
  BandMatrix slopes_ = BandMatrix::Zero();
  BandValues mean_ = BandValues::Zero(), trend_ = BandValues::Zero();
  BandMatrix betweenVehicles_ = BandMatrix::Identity(), betweenPassages_ = BandMatrix::Identity();
  std::map<std::string, BandValues> deviations_;
  bool known_ = false;
};

// p of a path; of an example's squat; y of an example.
BandValues pathEnergies(const PathSpectrum& path, double speed);
BandValues pathEnergies(const Example& example);
BandValues measuredEnergies(const Example& example);

bool hasSize(const Example& example);

}  // namespace squat::detection
