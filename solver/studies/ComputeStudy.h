// solver/studies/ComputeStudy.h - a study of a case from its definition to its table, as command and studio compute it.
#pragma once

#include <string>

#include "case/CaseFile.h"
#include "simulation/RunCase.h"
#include "studies/CostEstimate.h"
#include "studies/RunStudy.h"

namespace squat::studies {

struct StudyJob {
  StudyDefinition definition;
  cases::CaseOverrides overrides = {};
  StudyOptions study = {};
  simulation::RunOptions run = {};
  std::string stem = "run";  // result files: STEM-0001.h5; of parts by hash, the point's hash in place of its number
  bool keepResults = false;
};

// What is still to be computed.
struct StudyCost {
  CostEstimate run;
  std::size_t runs = 0;

  double coreHours() const { return run.coreSeconds * static_cast<double>(runs) / 3600; }
};

// "12 runs of 21600 elements and 5300 steps, 0.4 core hours; 140 MiB a run"
std::string toText(const StudyCost& cost);

// What the job's folder holds, or no run ended yet. Throws as readTable().
StudyTable tableSoFar(const StudyJob& job);

// Reads what the job's folder holds. Of a part only the memory, by a rule of thumb: the rest would cost more than all
// else of its start. Throws as readTable() and costOfARun().
StudyCost costAhead(const StudyJob& job);

// `jobs` and `threads` as the machine allows (Jobs.h); 0 in either: not chosen by the user.
void shareCores(StudyJob& job, int jobs, int threads, const StudyCost& cost);

// FOLDER/STEM-0001.h5, where it keeps the result of this point.
std::string resultFile(const StudyJob& job, const StudyPoint& point);

// Makes the folder and computes what is missing in its table, from one warm state where that can be (SharedStart.h).
// The caller holds the folder's lock; parts have locks of their own. Throws as runStudy().
StudyTable computeStudy(StudyJob job, Monitor& monitor);

}  // namespace squat::studies
