#include "commands/FigureSheets.h"

#include <utility>

#include "plots/AnalysisFigures.h"
#include "plots/Application.h"
#include "plots/CalibrationFigure.h"
#include "plots/ComparisonFigures.h"
#include "plots/DecayFigures.h"
#include "plots/DetectionFigures.h"
#include "plots/EstimateFigure.h"
#include "plots/GrowthFigures.h"
#include "plots/PaperFigures.h"
#include "plots/ReceptanceFigures.h"
#include "plots/RoughnessFigure.h"
#include "plots/StudyFigures.h"
#include "plots/ValidationFigure.h"

namespace squat::commands {

namespace {

plots::Style styleOf(const FigureChoice& choice) {
  plots::ensureApplication();
  auto style = plots::lightStyle();
  style.colourMap = choice.colours;
  return style;
}

std::vector<std::string> write(const std::vector<plots::FigureSheet>& sheets, const std::string& folder,
                               const FigureChoice& choice) {
  std::vector<std::string> written;
  for (const auto& sheet : sheets) {
    if (choice.size.width > 0)
      for (const auto& panel : sheet.panels) panel->setPrintedSize({choice.size.width, choice.size.height});
    for (auto& path : plots::writeSheet(sheet, folder, choice.formats, choice.size.resolution))
      written.push_back(std::move(path));
  }
  return written;
}

}  // namespace

std::vector<std::string> writeAnalysisFigures(const analysis::Analysis& analysis, const std::string& folder,
                                              const FigureChoice& choice) {
  if (choice.none) return {};
  return write(plots::analysisFigures(analysis, styleOf(choice)), folder, choice);
}

std::vector<std::string> writeComparisonFigures(const std::vector<analysis::FileComparison>& comparisons, bool smooth,
                                                const std::string& folder, const FigureChoice& choice) {
  if (choice.none) return {};
  return write(plots::comparisonFigures(comparisons, smooth, styleOf(choice)), folder, choice);
}

std::vector<std::string> writeStudyFigures(const studies::StudyTable& table, const std::string& folder,
                                           const FigureChoice& choice) {
  if (choice.none) return {};
  return write(plots::studyFigures(table, styleOf(choice)), folder, choice);
}

std::vector<std::string> writeCalibrationFigure(const calibration::Calibration& calibration, const std::string& folder,
                                                const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::calibrationFigure(calibration, styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeEstimateFigure(const estimation::Estimate& estimate, const std::string& folder,
                                             const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::estimateFigure(estimate, styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeGrowthFigures(const growth::Growth& growth, const std::string& stem,
                                            const std::string& folder, const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::growthFigure(growth, stem, styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeForecastFigure(const growth::Forecast& forecast, const std::string& stem,
                                             const std::string& folder, const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::forecastFigure(forecast, stem, styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeDetectionFigures(const detection::DetectionReport& report, const std::string& folder,
                                               const FigureChoice& choice) {
  if (choice.none) return {};
  return write(plots::detectionFigures(report, styleOf(choice)), folder, choice);
}

std::vector<std::string> writeValidationFigure(const std::vector<statements::Judged>& judged, const std::string& note,
                                               const std::string& folder, const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::validationFigure(judged, note, styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeReceptanceFigure(const receptance::TrackReceptance& receptance, const std::string& name,
                                               const std::string& title, const std::string& hash,
                                               receptance::ReceptanceQuantity quantity, const std::string& folder,
                                               const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::receptanceFigures(receptance, name, title, hash, styleOf(choice), quantity));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeDecayFigure(const receptance::DecayRates& rates,
                                          const receptance::MeasuredDecayRates* measured, const std::string& name,
                                          const std::string& title, const std::string& hash, const std::string& folder,
                                          const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  sheets.push_back(plots::decayFigures(rates, measured, name, title, hash, styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writeRoughnessFigures(const std::vector<roughness::NamedRoughness>& roughness,
                                               const std::string& folder, const FigureChoice& choice) {
  if (choice.none) return {};
  std::vector<plots::FigureSheet> sheets;
  for (std::size_t i = 0; i < roughness.size(); ++i)
    sheets.push_back(plots::roughnessFigure(roughness[i].second, roughness::fileStem(roughness, i), styleOf(choice)));
  return write(sheets, folder, choice);
}

std::vector<std::string> writePaperFigures(const PaperResults& results, const std::string& folder,
                                           const FigureChoice& choice) {
  plots::PaperRuns runs{results.light, results.squat, results.modified};
  for (const auto& signal : results.lightMeasured) runs.lightMeasured.push_back(plots::aroundImpact(signal));
  for (const auto& signal : results.squatMeasured) runs.squatMeasured.push_back(plots::aroundImpact(signal));
  return write(plots::paperFigures(runs, styleOf(choice)), folder, choice);
}

}  // namespace squat::commands
