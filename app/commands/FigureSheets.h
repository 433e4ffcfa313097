// app/commands/FigureSheets.h - figures of the signal analysis as files; a headless build writes none.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "analysis/Analysis.h"
#include "analysis/FileComparison.h"
#include "calibration/Calibration.h"
#include "commands/FigureNames.h"
#include "detection/DetectionFiles.h"
#include "growth/Forecast.h"
#include "growth/Grow.h"
#include "receptance/DecayFiles.h"
#include "receptance/Receptance.h"
#include "results/RunResult.h"
#include "roughness/RoughnessFiles.h"
#include "statements/Judge.h"
#include "studies/StudyTable.h"

namespace squat::estimation {
struct Estimate;
}

namespace squat::commands {

struct FigureChoice {
  std::vector<std::string> formats;  // empty: png, svg, pdf
  std::string colours = "viridis";
  plots::PrintedSize size = {};
  bool none = false;  // --no-figures
};

// --format, --colours, --figure-size, --dpi and, where asked for, --no-figures.
void addFigureOptions(CLI::App& command, FigureChoice& choice, bool mayBeNone = true);

// Each writes into the folder and returns the paths; nothing where none are wanted or the build has no figures (then
// one line on stderr says so). Throw FileError.
std::vector<std::string> writeAnalysisFigures(const analysis::Analysis& analysis, const std::string& folder,
                                              const FigureChoice& choice);
std::vector<std::string> writeComparisonFigures(const std::vector<analysis::FileComparison>& comparisons, bool smooth,
                                                const std::string& folder, const FigureChoice& choice);
std::vector<std::string> writeStudyFigures(const studies::StudyTable& table, const std::string& folder,
                                           const FigureChoice& choice);

std::vector<std::string> writeCalibrationFigure(const calibration::Calibration& calibration, const std::string& folder,
                                                const FigureChoice& choice);

std::vector<std::string> writeEstimateFigure(const estimation::Estimate& estimate, const std::string& folder,
                                             const FigureChoice& choice);

// STEM_growth: profiles, maps, depth and peak against tonnage.
std::vector<std::string> writeGrowthFigures(const growth::Growth& growth, const std::string& stem,
                                            const std::string& folder, const FigureChoice& choice);

// STEM_forecast: the band of depths against tonnage.
std::vector<std::string> writeForecastFigure(const growth::Forecast& forecast, const std::string& stem,
                                             const std::string& folder, const FigureChoice& choice);

// The overview along the track, and one figure an event.
std::vector<std::string> writeDetectionFigures(const detection::DetectionReport& report, const std::string& folder,
                                               const FigureChoice& choice);

// The judged statements as a figure; `note` stands beside its title.
std::vector<std::string> writeValidationFigure(const std::vector<statements::Judged>& judged, const std::string& note,
                                               const std::string& folder, const FigureChoice& choice);

// FOLDER/NAME.FORMAT; title and hash of the case stand in the caption.
std::vector<std::string> writeReceptanceFigure(const receptance::TrackReceptance& receptance, const std::string& name,
                                               const std::string& title, const std::string& hash,
                                               receptance::ReceptanceQuantity quantity, const std::string& folder,
                                               const FigureChoice& choice);
std::vector<std::string> writeDecayFigure(const receptance::DecayRates& rates,
                                          const receptance::MeasuredDecayRates* measured, const std::string& name,
                                          const std::string& title, const std::string& hash, const std::string& folder,
                                          const FigureChoice& choice);

// NAME_roughness of each signal.
std::vector<std::string> writeRoughnessFigures(const std::vector<roughness::NamedRoughness>& roughness,
                                               const std::string& folder, const FigureChoice& choice);

struct PaperResults {
  const results::RunResult *light = nullptr, *squat = nullptr, *modified = nullptr;
  std::vector<analysis::SignalAnalysis> lightMeasured = {}, squatMeasured = {};  // passages over the two defects
};
// Counterparts of the figures of the paper.
std::vector<std::string> writePaperFigures(const PaperResults& results, const std::string& folder,
                                           const FigureChoice& choice);

}  // namespace squat::commands
