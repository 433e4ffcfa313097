// app/commands/FigureNames.h - which figures a call asks for, and in which formats.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "analysis/FigureSettings.h"
#include "plots/PrintedSize.h"

namespace squat::commands {

// A list with commas between its entries; one that is named twice counts once.
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<std::string>& entries,
                     const std::string& help);

// --figure-size and --dpi.
void addFigureSize(CLI::App& command, plots::PrintedSize& size);

struct NamedFigures {
  std::vector<std::string> figures, formats;  // empty: all
  plots::PrintedSize size = {};
  analysis::FigureSettings settings = {};
};

// --figures, --format, --figure-size, --dpi and --spectrum. The help lists the figures with their titles.
void addFigureNames(CLI::App& command, NamedFigures& named);

}  // namespace squat::commands
