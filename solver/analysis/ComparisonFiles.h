// solver/analysis/ComparisonFiles.h - comparisons as tables.
#pragma once

#include <string>
#include <vector>

#include "analysis/FileComparison.h"

namespace squat::analysis {

std::string comparisonCsv(const std::vector<FileComparison>& comparisons);   // one row a pair
std::string comparisonJson(const std::vector<FileComparison>& comparisons);  // the same with both feature tables

// Both signals and their difference over the common axis; spectra and their ratio over frequency.
std::string overlayCsv(const signals::Comparison& comparison);
std::string spectraCsv(const signals::Comparison& comparison);

// comparison.csv, comparison.json, NAME_overlay.csv and NAME_spectra.csv for each pair; returns the paths. Everything
// is made before anything is written. Throws CaseError where a table would replace a file that was compared.
std::vector<std::string> writeComparisons(const std::vector<FileComparison>& comparisons, const std::string& folder);

}  // namespace squat::analysis
