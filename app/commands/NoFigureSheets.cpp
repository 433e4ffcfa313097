// The headless build: tables, no figures.
#include <cstdio>

#include "commands/FigureSheets.h"

namespace squat::commands {

namespace {

std::vector<std::string> none(const FigureChoice& choice) {
  if (!choice.none)
    std::fprintf(stderr, "No figures: this build is headless. Build with cmake --preset release to draw them.\n");
  return {};
}

}  // namespace

std::vector<std::string> writeAnalysisFigures(const analysis::Analysis&, const std::string&,
                                              const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeComparisonFigures(const std::vector<analysis::FileComparison>&, bool, const std::string&,
                                                const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeStudyFigures(const studies::StudyTable&, const std::string&, const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeCalibrationFigure(const calibration::Calibration&, const std::string&,
                                                const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeGrowthFigures(const growth::Growth&, const std::string&, const std::string&,
                                            const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeForecastFigure(const growth::Forecast&, const std::string&, const std::string&,
                                             const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeDetectionFigures(const detection::DetectionReport&, const std::string&,
                                               const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeEstimateFigure(const estimation::Estimate&, const std::string&,
                                             const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeValidationFigure(const std::vector<statements::Judged>&, const std::string&,
                                               const std::string&, const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeReceptanceFigure(const receptance::TrackReceptance&, const std::string&,
                                               const std::string&, const std::string&, receptance::ReceptanceQuantity,
                                               const std::string&, const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeDecayFigure(const receptance::DecayRates&, const receptance::MeasuredDecayRates*,
                                          const std::string&, const std::string&, const std::string&,
                                          const std::string&, const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writeRoughnessFigures(const std::vector<roughness::NamedRoughness>&, const std::string&,
                                               const FigureChoice& choice) {
  return none(choice);
}

std::vector<std::string> writePaperFigures(const PaperResults&, const std::string&, const FigureChoice& choice) {
  return none(choice);
}

}  // namespace squat::commands
