// widgets/plots/MapFigure.h - a coloured map over position and frequency: scalograms, short-time transforms, and how
// two of them differ.
#pragma once

#include <memory>

#include "plots/Figure.h"
#include "results/AnalysedRecord.h"

namespace squat::plots {

struct MapLook {
  QString name, label;       // of the figure; of the colour scale
  double low = 0, high = 0;  // of the colours; equal: from zero to the largest value shown
  bool diverging = false;    // blue, white, red about the middle, in place of the style's map
};

// scalogramPower of the record as it stands, within judgedWindow() and 50 to 3000 Hz; a notice where there is none.
std::unique_ptr<Figure> mapFigure(const results::AnalysedRecord& record, const Style& style, const MapLook& look);

}  // namespace squat::plots
