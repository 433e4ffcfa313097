// app/commands/ValidationText.h - judged statements, parameters and sensitivity as tables for a terminal.
#pragma once

#include <string>
#include <vector>

#include "statements/Judge.h"
#include "statements/Sensitivity.h"

namespace squat::commands {

std::string countsText(const std::vector<statements::Judged>& judged);  // "9 met, 11 not met, 2 not judged"
// Below the table: reasonsText().
std::string statementsText(const std::vector<statements::Judged>& judged);
std::string valueText(const statements::Judged& judged);  // "1041 Hz"; "none"
// Why there is no result, for each statement without one, below an empty line; empty where all have one.
std::string reasonsText(const std::vector<statements::Judged>& judged);
// How many match the paper, and a table of the others.
std::string parametersText(const std::vector<statements::ComparedParameter>& parameters);
std::string numbersText(const statements::Reference& reference);
// One table for each input; numbers that do not meet their statement have a star.
std::string sensitivityText(const statements::SensitivityTable& table);

}  // namespace squat::commands
