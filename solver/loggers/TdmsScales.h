// solver/loggers/TdmsScales.h - the scales of a TDMS channel: from what was stored to what was measured.
#pragma once

#include <string>
#include <vector>

#include "loggers/TdmsObjects.h"

namespace squat::loggers {

// Polynomials, each of the value that the one before gave: coefficients in rising powers.
struct TdmsScaling {
  std::vector<std::vector<double>> steps;
  std::string refusal;  // "it ..." or "its ...": why the channel cannot be scaled; empty: it can
};

// From the properties of a channel, its group and the file: those of the first that has scales count. Linear and
// polynomial scales are applied, unless NI_Scaling_Status says that the values are "scaled" already.
TdmsScaling tdmsScaling(const TdmsObject& channel, const TdmsProperties& group, const TdmsProperties& file);

void applyTdmsScaling(const TdmsScaling& scaling, std::vector<double>& values);

}  // namespace squat::loggers
