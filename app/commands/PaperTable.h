// app/commands/PaperTable.h - what a run found, beside what the paper states (Molodova et al. 2014).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/WheelsetModes.h"
#include "results/RunResult.h"

namespace squat::commands {

struct PaperRow {
  std::string what, ours, paper, verdict;  // verdict: empty, "met", "not met"
};

// Peak, lines of the spectrum, wavelength; contact against Hertz; quietness; energy; cost. Rows whose numbers the
// result does not hold say "not available". The paper's column is filled for the cases that the paper has.
std::vector<PaperRow> paperRows(const results::RunResult& result);

std::string paperTable(const results::RunResult& result);

// Natural modes of the half wheelset: frequency, shares at box, wheel centre, contact.
std::string modesTable(const results::RunResult& result);
std::string modesTable(const std::vector<model::HarmonicMode>& modes);

// Wall time of each phase of the run; empty where the result does not hold it.
std::string phasesTable(const results::RunResult& result);

// The number under `name` in a list of scalars.
std::optional<double> scalarNamed(const std::vector<results::Scalar>& list, const std::string& name);

}  // namespace squat::commands
