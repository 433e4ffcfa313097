// app/commands/EstimateSummary.h - an estimated profile as text.
#pragma once

#include <string>

#include "estimation/Estimation.h"

namespace squat::commands {

// Lines of at most 100 columns.
std::string estimateSummary(const estimation::Estimate& estimate);

}  // namespace squat::commands
