// solver/core/Monitor.h - how a long computation reports its progress and asks whether to continue.
#pragma once

#include <string>

namespace squat {

// A live look at the run. Fields that a phase does not know stay at zero.
struct Progress {
  std::string phase;               // "mesh", "equilibrium", "rolling", "spectra", ...
  double fraction = 0.0;           // of this phase, 0..1
  double simulatedTime = 0.0;      // [s]
  double remainingSeconds = -1.0;  // wall time to the end of the phase; below zero: not known yet
  double elementUpdatesPerSecond = 0.0;
  double position = 0.0;              // [m] wheel relative to the deepest point of the defect
  double contactForce = 0.0;          // [N] vertical
  double axleBoxAcceleration = 0.0;   // [m/s2] vertical, anti-aliased: its filter waits for what comes, so that it
                                      // belongs to an earlier location than `position`
  double accelerationPosition = 0.0;  // [m] of the wheel at that instant
  double energyResidual = 0.0;        // of the energy balance, relative
  double step = 0.0;                  // [s] that the run takes; known once the stable step is
  std::string limitedBy;              // what sets the stable step: block and location
};

// The seam to whoever watches: terminal, studio, tests. Called from the computing thread, several times a second.
// Does nothing by default.
class Monitor {
 public:
  virtual ~Monitor() = default;
  virtual void report(const Progress&) {}
  virtual void message(const std::string&) {}  // one line worth keeping: a warning or a figure
  virtual bool cancelled() { return false; }   // asked often; true ends the run at a clean step
  virtual bool paused() { return false; }      // true holds the run; asked until false
};

}  // namespace squat
