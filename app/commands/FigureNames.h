// app/commands/FigureNames.h - which figures a call asks for, and in which formats.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace squat::commands {

// A list with commas between its entries; one that is named twice counts once.
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<std::string>& entries,
                     const std::string& help);

// --figures and --format; empty: all. The help lists the figures with their titles.
void addFigureNames(CLI::App& command, std::vector<std::string>& figures, std::vector<std::string>& formats);

}  // namespace squat::commands
