// solver/calibration/Calibration.h - unknown inputs of a case, found from what the case has to reproduce.
//
// Search: the case's own values, points that fill the limits evenly, local searches from the best of them (BOBYQA of
// the NLopt library: M. J. D. Powell, 2009), then steps by the derivatives of all residuals about the best (Gauss and
// Newton). On a coarse mesh; the best points are computed again on a finer one, which decides. What is known: see
// Knowledge.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/FreeInput.h"
#include "calibration/TargetValue.h"
#include "calibration/Targets.h"
#include "case/CaseFile.h"
#include "core/Monitor.h"
#include "studies/Partition.h"

namespace squat::calibration {

struct CalibrationDefinition {
  std::string caseName;  // as the user named it
  std::string caseHash;  // of the case at the start; filled in by calibrate()
  cases::CaseOverrides overrides;
  std::vector<FreeInput> inputs;
  Targets targets;
  std::string searchMesh = "tiny", confirmMesh = "draft";
  int evaluations = 0;  // points to compute, about; 0: 20 plus 40 for each input
};

enum class Stage { start, global, local, derivatives, spread, confirm };
std::string toText(Stage stage);

// One point of the search. `misfit` is the weighted mean over the targets.
struct Evaluation {
  Stage stage = Stage::start;
  std::string mesh;
  Values values;
  bool hasFailed = false;  // the case cannot be run with these values, or its run failed
  std::string message;     // why
  double misfit = 0;
  std::vector<TargetValue> targets;  // in the order of Targets::names()
};

struct CalibrationOptions {
  std::string folder = ".";
  int jobs = 1, threads = 1;  // points at once; threads of each run
  std::string isa;
  // A share of the points that fill the limits, in FOLDER/parts; the stages that follow depend on all of them.
  std::optional<studies::Partition> part;
};

// What is known of one input after the search, in the unit of the case file.
struct InputRange {
  double best = 0, low = 0, high = 0;
  bool reachesLow = false, reachesHigh = false;  // the limit of the search ends the range
  bool isSeen = false;                           // the targets change with it
};

struct Calibration {
  CalibrationDefinition definition;
  std::vector<Evaluation> evaluations;
  std::size_t best = 0, bestOfSearch = 0;        // on the finer mesh; on the search's own
  std::vector<std::size_t> equallyGood;          // of the search mesh, as good as bestOfSearch
  std::vector<InputRange> ranges;                // one for each input
  std::vector<std::vector<double>> correlation;  // of the inputs over the equally good points; empty: too few
  std::vector<std::string> outOfReach;           // targets that no point comes near to, in words
  bool complete = false;                         // false: cancelled
};

// Every evaluated point is kept in FOLDER/calibration.csv at once; a call for the same calibration in the same folder
// takes them from there and resumes. Throws CaseError for a folder that holds another calibration and for a case that
// can be run at no point; FileError for targets that cannot be what they claim to be (units). What parts have computed
// in FOLDER/parts is taken from there. For a part, only its evaluations are returned.
Calibration calibrate(const CalibrationDefinition& definition, const CalibrationOptions& options, Monitor& monitor);

// The files that a calibration writes into its folder.
std::vector<std::string> calibrationFiles(const std::string& folder);

// FOLDER/parts/calibrate-slice-3-of-16: of a part.
std::string partFolder(const std::string& folder, const studies::Partition& part);

}  // namespace squat::calibration
