// app/commands/SignalOptions.h - how a call says what a file of measured signals holds; shared by analyse and compare.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "measured/SignalFile.h"

namespace squat::commands {

struct SignalOptions {
  measured::SignalFileOptions file;
  std::string speed, delimiter = "auto";
  bool decimalComma = false;
};

void addSignalOptions(CLI::App& command, SignalOptions& options);

// With the texts turned into values; throws CaseError.
measured::SignalFileOptions fileOptions(const SignalOptions& options);

}  // namespace squat::commands
