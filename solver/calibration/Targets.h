// solver/calibration/Targets.h - what a calibrated case has to reproduce.
#pragma once

#include <string>
#include <vector>

#include "readers/SignalFile.h"
#include "statements/Reference.h"

namespace squat::calibration {

// A statement about one run, or the ratio of two (statements/Reference.h).
struct StatementTarget {
  statements::Statement statement;
  double weight = 1;
};

// Measured axle box accelerations of one place: one or several runs, aligned over position.
struct SignalTarget {
  std::string name, run;
  std::vector<std::string> files;
  readers::SignalFileOptions reading;
  double weight = 1;
  double before = 0.1, after = 0.28;  // [m] around the deepest point of the defect that is compared
  double cutoff = 2000;               // [Hz] both signals are low-passed
  double noise =
      0;  // share of the measured peak; 0: what the scatter of the runs leaves in their mean; a tenth for one run
};

// Measured receptance of the unloaded track: a table of frequency and magnitude, or real and imaginary part.
struct ReceptanceTarget {
  std::string name, file;
  std::string point;  // "over a sleeper" or "midspan"
  double weight = 1;
  double lowest = 50, highest = 1500;  // [Hz] that is compared
  double tolerance = 1;                // [dB] of the magnitude; 6.6 degrees of phase go with 1 dB
};

// Measured track decay rates: a table as receptance/DecayFiles.h reads it.
struct DecayTarget {
  std::string name, file;
  double weight = 1;
  double lowest = 100, highest = 5000;  // [Hz] third octaves that are compared
  double tolerance = 1;                 // [dB]
};

struct Targets {
  std::string path;
  std::vector<statements::ReferenceRun> runs;  // that statements and signals are about
  std::vector<StatementTarget> statements;
  std::vector<SignalTarget> signals;
  std::vector<ReceptanceTarget> receptances;
  std::vector<DecayTarget> decays;
  std::vector<std::string> notes;  // what was left out, and why

  std::size_t count() const { return statements.size() + signals.size() + receptances.size() + decays.size(); }
  std::vector<std::string> names() const;  // statements, signals, receptances, decay rates
  std::vector<double> weights() const;
};

// Reads target files, several together. JSON (schema "squat-targets" 1) has
//   runs         as paper.json: name, case (left out: the case that is calibrated), set
//   statements   as paper.json, with a weight; "run" left out: the calibrated case as it is
//   paper        {"run": NAME, "sections": ["3"], "weight": 1}: the statements of paper.json about that run alone
//   signals      {"files": [...], "run", "weight", "noise", "before", "after", "cutoff", "column", "speed", "rate"}
//   receptance   {"file", "point", "weight", "lowest", "highest", "tolerance"}
//   decay        {"file", "weight", "lowest", "highest", "tolerance"}
// "light-defect" names the shipped targets of the paper's section 3, "paper" all of its statements.
// A reference file (paper.json) serves as it is: its statements on runs of the calibrated case. A table of signals or,
// where its first column is a frequency, of receptance over a sleeper is a target by itself.
// Files that a target file names are looked for beside it. `caseName` as the user named the case.
//
// Throws FileError with the entry: no target, unknown run, measure or unit, statements that contradict each other,
// weights that are not positive, a file that is missing.
Targets readTargets(const std::vector<std::string>& paths, const std::string& caseName);

}  // namespace squat::calibration
