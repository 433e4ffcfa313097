// widgets/plots/AnalysisFigures.h - figures of signals of any origin, and of repeated runs over one defect.
#pragma once

#include <vector>

#include "analysis/Analysis.h"
#include "plots/FigureSheet.h"
#include "results/AnalysedRecord.h"

namespace squat::plots {

// Of each signal RUN_history (whole record), RUN_psd (the window around the anchor, lines named as in the table of
// features), RUN_stft and RUN_scalogram (0.1 m before to 0.28 m behind the impact); of repeated runs scatter_time and
// scatter_position: every run, their mean and the band between minimum and maximum.
std::vector<FigureSheet> analysisFigures(const analysis::Analysis& analysis, const Style& style);

// The stretch of those 0.38 m with its spectrum and scalogram; positions from the anchor. Records may be long.
results::AnalysedRecord aroundImpact(const analysis::SignalAnalysis& signal);

std::unique_ptr<Figure> historyFigure(const analysis::SignalAnalysis& signal, const Style& style);
std::unique_ptr<Figure> scatterFigure(const signals::AlignedRuns& runs, const std::string& unit, const Style& style);

}  // namespace squat::plots
