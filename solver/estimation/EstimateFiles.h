// solver/estimation/EstimateFiles.h - an estimate as files: table, case with its profile, JSON.
#pragma once

#include <string>
#include <vector>

#include "estimation/Estimation.h"

namespace squat::estimation {

// estimate.csv (position, height, bounds, whether the wheel feels it), estimate.toml (the case with the profile), the
// profile that it names, and estimate.json, in this order.
std::vector<std::string> estimateFiles(const std::string& folder);

// Writes them, each whole or not at all. Throws FileError.
void writeEstimate(const Estimate& estimate, const std::string& folder);

// Everything but the case, SI units but for the profile's mm and um.
std::string estimateJson(const Estimate& estimate);

}  // namespace squat::estimation
