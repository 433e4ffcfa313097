// widgets/plots/Figures.h - all figures of a run as files.
#pragma once

#include <string>
#include <vector>

#include "analysis/FigureSettings.h"
#include "case/CaseDeclaration.h"
#include "plots/PrintedSize.h"
#include "results/RunResult.h"
#include "scene/ModelPicture.h"

namespace squat::plots {

struct FigureRequest {
  std::vector<std::string> figures;                       // empty: all that the result has something for
  std::vector<std::string> formats{"png", "svg", "pdf"};  // the 3-D picture comes as png whatever stands here
  analysis::FigureSettings settings = {};
  PrintedSize size = {};
};

// Throws CaseError for unknown names of figures, formats and colours and, where a case is given, for figures that a run
// of it will have nothing for.
void checkRequest(const FigureRequest& request, const cases::CaseDescription* description = nullptr);

// The same for figures that the result has nothing for.
void checkRequest(const FigureRequest& request, const results::RunResult& result);

// Of the 3-D picture.
scene::PictureSize modelSize(const PrintedSize& size);

// Writes NAME.FORMAT into `folder` (made where missing) for rows of figureRegistry() and returns the paths written.
// Call plots::ensureApplication() before. Where the 3-D picture cannot be drawn on this machine, or the result has
// nothing for any figure, that is added to `messages`. Throws CaseError for unknown names, formats or colour maps, and
// for a named figure that the result has nothing for, before anything is written, FileError where a file cannot be
// written.
std::vector<std::string> renderFigures(const results::RunResult& result, const std::string& folder,
                                       const FigureRequest& request = {}, std::vector<std::string>* messages = nullptr);

}  // namespace squat::plots
