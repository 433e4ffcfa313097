#include "elasticity/SweptKernel.h"

#include <stdexcept>

#include "elasticity/SweptKernelUnits.h"

namespace squat::elasticity {

std::vector<std::string> knownInstructionSets() {
  std::vector<std::string> sets;
  for (const auto& unit : kernelUnits()) sets.push_back(unit.name);
  return sets;
}

std::vector<std::string> availableInstructionSets() {
  std::vector<std::string> sets;
  for (const auto& unit : kernelUnits())
    if (unit.isUsable) sets.push_back(unit.name);
  return sets;
}

KernelSet kernelsFor(const std::string& isa, Precision precision) {
  const std::string wanted = isa.empty() ? availableInstructionSets().back() : isa;
  std::string names;
  for (const auto& unit : kernelUnits()) {
    if (!unit.isUsable) continue;
    if (unit.name == wanted) return unit.kernels(precision);
    names += (names.empty() ? "" : ", ") + unit.name;
  }
  throw std::invalid_argument("instruction set '" + wanted + "' is not available here; this processor has " + names);
}

// Six values of each station of a chunk per node.
std::size_t kernelWorkspace(int window) { return static_cast<std::size_t>(window) * 6 * stationChunk; }

// At least one row: the kernels leave what nobody asks for there.
std::size_t forceWorkspace(int forceSlots) { return (static_cast<std::size_t>(forceSlots) + 1) * 3 * stationChunk; }

}  // namespace squat::elasticity
