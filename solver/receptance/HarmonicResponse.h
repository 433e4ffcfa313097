// solver/receptance/HarmonicResponse.h - response of a damped system to harmonic forces, at many frequencies.
//
// The system is solved directly at a few frequencies; between them it is projected (Galerkin) on the real and imaginary
// parts of these solutions and of the first terms of their Taylor series in the frequency, which reproduces the
// solutions but for what is negligible. Each stretch of frequencies is solved directly in its middle and held against
// the projection: where they differ by more than the tolerance the stretch is halved.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "core/Monitor.h"
#include "core/ThreadTeam.h"
#include "receptance/BlockMatrix.h"

namespace squat::receptance {

struct HarmonicOptions {
  double tolerance = 0.005;  // of the magnitude: 0.04 dB
  int firstStretches = 4;
  int maximumSolutions = 120;
};

struct HarmonicResponse {
  std::vector<std::vector<std::complex<double>>> values;  // per pair of load and response: per frequency
  int solutions = 0;
  double largestDifference = 0;  // of direct solutions from the projection, in stretches that were not halved
  double largestResidual = 0;    // of the direct solutions
  bool cancelled = false;
};

// `frequencies` [Hz] ascending; pairs of columns: response of column i to load of column i.
HarmonicResponse harmonicResponse(const std::vector<HarmonicTerm>& terms, const Eigen::MatrixXd& loads,
                                  const Eigen::MatrixXd& responses, const std::vector<double>& frequencies,
                                  const HarmonicOptions& options, ThreadTeam& team, Monitor& monitor);

}  // namespace squat::receptance
