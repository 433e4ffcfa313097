#include "commands/ComputeOptions.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "case/ParameterTable.h"
#include "elasticity/SweptKernel.h"

namespace squat::commands {

CLI::Option* addMesh(CLI::App& command, std::string& mesh, const std::string& help, const std::string& name) {
  return command.add_option(name, mesh, help)
      ->check(CLI::IsMember(cases::findParameter("mesh.preset")->choices))
      ->type_name("PRESET");
}

namespace {

constexpr int maximumThreads = 1024;

// Threads wait for each other at every step: far more than there are cores bring a run to a crawl. The numbers of a
// result do not depend on how many there are, so fewer than asked for do no harm.
std::string limitThreads(std::string& input) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int maximum = usefulThreads(cores);
  int threads = 0;
  if (CLI::detail::lexical_cast(input, threads) && threads > maximum && threads <= maximumThreads) {
    std::fprintf(stderr, "note: using %d threads instead of %d; this machine has %d cores\n", maximum, threads, cores);
    input = std::to_string(maximum);
  }
  return {};
}

// "sse2, avx2 or avx512": man pages and completion read the choices there.
std::string namesOf(const std::vector<std::string>& names) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

}  // namespace

int usefulThreads(int cores) { return std::max(8, 4 * cores); }

void addThreads(CLI::App& command, int& threads, const std::string& help) {
  command.add_option("--threads", threads, help)
      ->check(CLI::Range(1, maximumThreads))
      ->transform(CLI::Validator(limitThreads, ""))
      ->type_name("N");
}

void addInstructionSet(CLI::App& command, std::string& isa) {
  const auto names = elasticity::knownInstructionSets();
  command.add_option("--isa", isa, "Instruction set: " + namesOf(names) + " (default: best available)")
      ->check(CLI::IsMember(names))
      ->type_name("NAME");
}

}  // namespace squat::commands
