// widgets/plots/Figures.h - all figures of a run as files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::plots {

class Figure;
struct Style;

struct FigureRequest {
  std::vector<std::string> figures;                       // empty: all that the result has something for
  std::vector<std::string> formats{"png", "svg", "pdf"};  // the 3-D picture comes as png whatever stands here
  std::string colourMap = "viridis";                      // or "cividis", "jet"
};

// Throws CaseError for unknown names of figures, formats and colours.
void checkRequest(const FigureRequest& request);

// "defect_profile", "aba_position", "aba_time", "psd", "scalogram", "contact_force", "permanent_change",
// "residual_stress" (the last two: where the rail may yield), "model" (the 3-D picture).
std::vector<std::string> figureNames();

// Those that this result has something for.
std::vector<std::string> availableFigures(const results::RunResult& result);

// The named figure as an object, for screen or file. Null for "model" and unknown names.
std::unique_ptr<Figure> makeFigure(const std::string& name, const results::RunResult& result, const Style& style);

// Writes NAME.FORMAT into `folder` (made where missing) and returns the paths written. Call plots::ensureApplication()
// before. Where the 3-D picture cannot be drawn on this machine, its reason is added to `messages` and the other
// figures are written all the same. Throws CaseError for unknown names, formats or colour maps, and for a named figure
// that the result has nothing for, before anything is written, FileError where a file cannot be written.
std::vector<std::string> renderFigures(const results::RunResult& result, const std::string& folder,
                                       const FigureRequest& request = {}, std::vector<std::string>* messages = nullptr);

}  // namespace squat::plots
