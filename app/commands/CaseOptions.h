// app/commands/CaseOptions.h - how a call names and changes a case; shared by the commands that take one.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "case/CaseDeclaration.h"
#include "case/CaseFile.h"

namespace squat::commands {

struct CaseOptions {
  std::string name;               // path of a TOML file or name of a shipped case
  std::string mesh;               // --mesh
  std::vector<std::string> sets;  // --set key=value
  std::string stem;               // --name; empty: that of the case
};

void addCaseOptions(CLI::App& command, CaseOptions& options);
// The command has meshes of its own. `name`: "case", or "--case" where other files come first.
void addCaseWithoutMesh(CLI::App& command, CaseOptions& options, const std::string& name = "case");

// --name NAME, for a command that writes files named after its case.
void addName(CLI::App& command, CaseOptions& options,
             const std::string& help = "Name of the files (default: that of the case)");
// What the names of its files begin with: --name, else the name of the case.
std::string stemOf(const CaseOptions& options);

// The changes alone. Throws CaseError for a --set that is no KEY=VALUE.
cases::CaseOverrides caseOverrides(const CaseOptions& options);

// The case with all changes. Throws CaseError (all errors together) and FileError.
cases::CaseDescription readCase(const CaseOptions& options);

}  // namespace squat::commands
