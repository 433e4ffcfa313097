// app/commands/SignalOptions.h - how a call says what a file of measured signals holds; shared by analyse and compare.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "readers/SignalFile.h"

namespace squat::commands {

struct SignalOptions {
  readers::SignalFileOptions file;
  std::string speed, delimiter = "auto";
  std::vector<std::string> units;  // COLUMN=UNIT
  bool decimalComma = false;
};

void addSignalOptions(CLI::App& command, SignalOptions& options);

// A path, or the name of a shipped record.
std::string recordFile(const std::string& nameOrPath);

// With the texts turned into values; throws CaseError.
readers::SignalFileOptions fileOptions(const SignalOptions& options);

}  // namespace squat::commands
