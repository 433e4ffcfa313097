// solver/analysis/OptionText.h - options of the signal analysis as a user types them. Errors name the option.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/Analysis.h"

namespace squat::analysis {

// "130-320" or "130:320", in Hz, with an optional name before: "squat=250-350". Throws CaseError.
signals::Band bandFromText(const std::string& text);

// "," ";" "tab" "space" "|" or any single character; "auto" and "" give 0. Throws CaseError.
char delimiterFromText(const std::string& text);

// Chainage in m, with its unit, or as kilometres and metres: "12345", "12.345 km", "12+345.6" [m]. Throws CaseError.
double chainageFromText(const std::string& text);

// Speed in m/s, or with its unit: "30", "30 m/s", "108 km/h". Throws CaseError.
double speedFromText(const std::string& text);

// "aba=g": column and unit, parted by the last "=". Throws CaseError.
std::pair<std::string, std::string> columnUnitFromText(const std::string& text);

// Window and detrend by name into the options of the spectrum; throws CaseError naming the known ones.
void setWindow(signals::PowerSpectrumOptions& options, const std::string& text);
void setDetrend(signals::PowerSpectrumOptions& options, const std::string& text);

}  // namespace squat::analysis
