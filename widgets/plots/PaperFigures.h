// widgets/plots/PaperFigures.h - counterparts of the figures of the paper (Molodova et al. 2014) from our own runs.
#pragma once

#include <vector>

#include "plots/FigureSheet.h"
#include "results/RunResult.h"

namespace squat::plots {

// The three runs of the paper; a null one leaves its panels with a notice. Passages measured over the two defects, as
// aroundImpact() gives them; none leave a notice in their panels.
struct PaperRuns {
  const results::RunResult* light = nullptr;                // "light-defect": figures 4, 5, 6
  const results::RunResult* squat = nullptr;                // "class-c-squat": figures 8 and 9
  const results::RunResult* modified = nullptr;             // "class-c-squat-modified": figures 9, 10, 11
  std::vector<results::AnalysedRecord> lightMeasured = {};  // figures 4, 5, 6
  std::vector<results::AnalysedRecord> squatMeasured = {};  // figures 8, 10, 11
};

// paper_figure_04, 05, 06, 08, 09, 10, 11. The paper gives its curves as pictures without numbers, so nothing of its
// measurements is drawn but what its text states as a number; the panels of measured curves say so in words, or show
// the user's own measurements. Colours of the scalograms by Style::colourMap.
std::vector<FigureSheet> paperFigures(const PaperRuns& runs, const Style& style);

}  // namespace squat::plots
