// solver/estimation/EstimateSummary.h - an estimated profile as text.
#pragma once

#include <string>

#include "estimation/Estimation.h"

namespace squat::estimation {

// Lines of at most 100 columns.
std::string estimateSummary(const Estimate& estimate);

}  // namespace squat::estimation
