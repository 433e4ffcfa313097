// app/commands/FigureNames.h - which figures a call asks for, and in which formats.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace squat::commands {

// A list with commas between its entries; one that is named twice counts once.
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<std::string>& entries,
                     const std::string& help);

struct FigureSize {
  double width = 0, height = 0;  // [mm] of each plot; 0: its own, one or two columns of a journal
  double resolution = 300;       // [dpi] of PNG
};

// --figure-size and --dpi.
void addFigureSize(CLI::App& command, FigureSize& size);

struct NamedFigures {
  std::vector<std::string> figures, formats;  // empty: all
  FigureSize size = {};
};

// --figures, --format, --figure-size and --dpi. The help lists the figures with their titles.
void addFigureNames(CLI::App& command, NamedFigures& named);

}  // namespace squat::commands
