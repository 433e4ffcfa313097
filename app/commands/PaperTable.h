// app/commands/PaperTable.h - what a run found, beside what the paper states (Molodova et al. 2014).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::commands {

struct PaperRow {
  // Verdict: empty; "met", "not met" for a statement of the paper, "not judged" where a key differs from the paper's
  // case; "passed", "failed" for a limit; the deviation from Hertz.
  std::string what, ours, paper, verdict;
};

// Peak, lines of the spectrum, wavelength; where there are several wheels, the smallest force of each; contact against
// Hertz; residual vibration; energy; cost. Rows whose numbers the result does not hold say "not available". The paper's
// statements stand beside the paper's own cases only, known by their values, whatever the file is called: name, number,
// range and verdict are those of `squat validate` (statements::judgeRun). Of the keys that differ from the paper's case
// a few are listed, those in `setByHand` first.
std::vector<PaperRow> paperRows(const results::RunResult& result, const std::vector<std::string>& setByHand = {});

std::string paperTable(const results::RunResult& result, const std::vector<std::string>& setByHand = {});

// Natural modes of the half wheelset: frequency, mass-normalised mode shape at axle box, wheel centre, contact.
std::string modesTable(const results::RunResult& result);

// Wall time of each phase of the run; empty where the result does not hold it.
std::string phasesTable(const results::RunResult& result);

// The number under `name` in a list of scalars.
std::optional<double> scalarNamed(const std::vector<results::Scalar>& list, const std::string& name);

}  // namespace squat::commands
