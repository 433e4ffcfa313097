// app/commands/RoughnessOptions.h - --roughness CASE, with which analyse and detect give the roughness that a record
// implies.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "commands/CaseOptions.h"
#include "commands/FigureSheets.h"
#include "commands/TerminalMonitor.h"
#include "roughness/RoughnessFiles.h"

namespace squat::commands {

struct RoughnessOptions {
  CaseOptions caseOptions;  // name empty: not asked for
  std::string filter = "remington", waves = "10-1000";

  bool asked() const { return !caseOptions.name.empty(); }
};

void addRoughnessOptions(CLI::App& command, RoughnessOptions& options);

// Throws CaseError for --contact-filter and --waves.
roughness::GaugeOptions gaugeOptions(const RoughnessOptions& options);

// Of the case's vehicle and track; not complete where it was cancelled.
roughness::TransferFunction transferFunctionOf(const RoughnessOptions& options, int threads, TerminalMonitor& monitor);

// Prints the summaries to `list`.
void printRoughness(const std::vector<roughness::NamedRoughness>& all, std::FILE* list);
// Tables and figures into the folder; returns their paths.
std::vector<std::string> writeRoughnessOutput(const std::vector<roughness::NamedRoughness>& all,
                                              const roughness::TransferFunction& transfer,
                                              const RoughnessOptions& options, const std::string& folder,
                                              const FigureChoice& figures);

}  // namespace squat::commands
