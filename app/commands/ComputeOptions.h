// app/commands/ComputeOptions.h - options of every command that computes: the same words, ranges and help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace squat::commands {

// --mesh; `help` says what it falls back to. The names are those of the parameter table.
CLI::Option* addMesh(CLI::App& command, std::string& mesh, const std::string& help, const std::string& name = "--mesh");

// As many threads as are taken on a machine of so many cores.
int usefulThreads(int cores);

// --threads; 0 where none are named. Many more than the machine has cores are lowered, and a line says so.
void addThreads(CLI::App& command, int& threads,
                const std::string& help = "Threads (default: SQUAT_THREADS of the environment, else all cores)");

// --isa; empty where none is named: the best that the processor has.
void addInstructionSet(CLI::App& command, std::string& isa);

}  // namespace squat::commands
