// solver/estimation/Estimation.h - the profile of a defect that explains measured passages over it.
//
// Regularised nonlinear least squares over the real solver. Equilibrium and run-up are computed once (warm states);
// every profile starts where the wheel begins to feel it. The start is the best of a few dips (StartProfile.h); then
// steps of Gauss and Newton with derivatives by differences, one run for each height, and Broyden's updates between
// them, until the differences between measured and computed acceleration are no larger than the noise of the record
// before the event. What the record does not show is kept smooth (LeastSquares.h), and the bounds say how far that may
// be wrong. A wheel that bridges a gap does not feel how deep it is: such stretches are marked.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/Monitor.h"
#include "readers/SignalFile.h"

namespace squat::estimation {

struct EstimateDefinition {
  std::string caseName;            // as the user named it: vehicle, track and location; its own defect does not count
  cases::CaseOverrides overrides;  // with the mesh
  std::vector<std::string> files;  // of measured passages over one location
  readers::SignalFileOptions reading;
  double cutoff = 2000;        // [Hz] low-pass of both signals
  double longest = 0.07;       // [m] longest dip that is looked for
  double beyond = 0.13;        // [m] that is compared behind the impact
  bool isSpreadWanted = true;  // depth with the shipped wheelsets as well, where the case's does not explain the record
};

struct EstimateOptions {
  int jobs = 1, threads = 1;  // runs at once; threads of each
  std::string isa;
  int runs = 150;  // at most, about
};

struct Interval {
  double value = 0, low = 0, high = 0;  // 90 %
};

struct ProfileSample {
  double position = 0;                      // [m] from the deepest sample
  double height = 0, lower = 0, upper = 0;  // [m]
  bool isFelt = true;                       // false: the wheel bridges it, the rail may be deeper
};

// One passage beside what the estimated profile gives. Positions as in the record.
struct ExplainedPassage {
  std::string name;                        // file and run
  double speed = 0;                        // [m/s]
  double location = 0;                     // [m] of the deepest sample, on the record's own axis
  double noise = 0;                        // [m/s2] of the record before the event
  double difference = 0;                   // [m/s2] root mean square between both
  double peak = 0;                         // [m/s2] largest absolute value of the record
  std::vector<double> position;            // [m] from the deepest sample
  std::vector<double> measured, computed;  // [m/s2]
};

struct Estimate {
  bool complete = false;  // false: cancelled; what is known so far
  std::vector<ProfileSample> profile;
  Interval depth, length;  // [m]; length between 5 % of the depth
  double misfit = 0;       // root mean square of all differences over the noise
  double depthOfPath = 0;  // [m] of the rigid wheel's path
  std::vector<ExplainedPassage> passages;
  cases::CaseDescription description;  // the case with the profile
  std::vector<std::string> notes;
  int runs = 0;
};

// Throws CaseError for a case that cannot be run, FileError for records that are too short, without an event or
// without a unit, RunError where no profile at all can be run.
Estimate estimateProfile(const EstimateDefinition& definition, const EstimateOptions& options, Monitor& monitor);

}  // namespace squat::estimation
