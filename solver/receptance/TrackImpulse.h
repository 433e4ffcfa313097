// solver/receptance/TrackImpulse.h - the track alone, struck on the rail head: the operator of the rolling run without
// the wheelset.
#pragma once

#include <vector>

#include "core/Monitor.h"
#include "core/ThreadTeam.h"
#include "elasticity/SweptKernel.h"
#include "model/Model.h"

namespace squat::receptance {

struct ImpulseOptions {
  double step = 0, beta = 0;             // [s] of the central difference; stiffness-proportional damping
  double duration = 0.4;                 // [s] of the record
  double shortest = 0.1, enough = 1e-4;  // the record ends earlier where `left` is below `enough` after `shortest` [s]
  double pulse = 4e-4;     // [s] length of the force sin^2(pi t / pulse), 1 N high; first zero of its spectrum: 2/pulse
  double sampling = 1e-5;  // [s] wished between samples of the response
  double patch = 0.01;     // [m] side of the square on the running surface over which the force is spread
};

struct ImpulseRecord {
  std::vector<double> force;             // [N] downwards, at every step while the pulse lasts
  std::vector<double> response;          // [m] downwards, mean displacement of the rail's section weighted by area
  double forceStep = 0, sampleStep = 0;  // [s]
  double left = 0;                       // largest response in the last tenth of the record, of the largest at all
  bool cancelled = false;
};

// Strikes the running surface above the rail's axis at `position` [m] and records the section there.
// Throws RunError where the response grows without bound.
ImpulseRecord strikeTrack(const model::Model& model, const elasticity::KernelSet& kernels, ThreadTeam& team,
                          double position, const ImpulseOptions& options, Monitor& monitor);

}  // namespace squat::receptance
