#include "commands/ComputeOptions.h"

#include "case/ParameterTable.h"

namespace squat::commands {

CLI::Option* addMesh(CLI::App& command, std::string& mesh, const std::string& help) {
  return command.add_option("--mesh", mesh, help)
      ->check(CLI::IsMember(cases::findParameter("mesh.preset")->choices))
      ->type_name("PRESET");
}

void addThreads(CLI::App& command, int& threads, const std::string& help) {
  command.add_option("--threads", threads, help)->check(CLI::Range(1, 1024))->type_name("N");
}

void addInstructionSet(CLI::App& command, std::string& isa) {
  command.add_option("--isa", isa, "Instruction set: sse2, avx2 or avx512 (default: the best there is)")
      ->check(CLI::IsMember({"sse2", "avx2", "avx512"}))
      ->type_name("NAME");
}

}  // namespace squat::commands
