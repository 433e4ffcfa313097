// app/commands/ValidationText.h - judged statements, parameters and sensitivity as tables for a terminal.
#pragma once

#include <string>
#include <vector>

#include "validation/Judge.h"
#include "validation/Sensitivity.h"

namespace squat::commands {

std::string countsText(const std::vector<validation::Judged>& judged);  // "9 met, 11 not met, 2 not judged"
std::string statementsText(const std::vector<validation::Judged>& judged);
// How many are as in the paper, and a table of the others.
std::string parametersText(const std::vector<validation::ComparedParameter>& parameters);
std::string numbersText(const validation::Reference& reference);
// Numbers that are not met have a star.
std::string sensitivityText(const validation::SensitivityTable& table);

}  // namespace squat::commands
