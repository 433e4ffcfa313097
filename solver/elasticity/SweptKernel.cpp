#include "elasticity/SweptKernel.h"

#include <stdexcept>

namespace squat::elasticity {

KernelSet kernelsSse2(Precision precision);
KernelSet kernelsAvx2(Precision precision);
KernelSet kernelsAvx512(Precision precision);

std::vector<std::string> availableInstructionSets() {
  std::vector<std::string> sets{"sse2"};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    sets.push_back("avx2");
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
      sets.push_back("avx512");
  }
  return sets;
}

KernelSet kernelsFor(const std::string& isa, Precision precision) {
  const auto available = availableInstructionSets();
  const std::string wanted = isa.empty() ? available.back() : isa;
  std::string names;
  for (const auto& name : available) {
    if (name == wanted)
      return name == "avx512" ? kernelsAvx512(precision)
             : name == "avx2" ? kernelsAvx2(precision)
                              : kernelsSse2(precision);
    names += (names.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument("instruction set '" + wanted + "' is not available here; this processor has " + names);
}

// Six values of each station of a chunk per node.
std::size_t kernelWorkspace(int window) { return static_cast<std::size_t>(window) * 6 * stationChunk; }

// At least one row: the kernels leave what nobody asks for there.
std::size_t forceWorkspace(int forceSlots) { return (static_cast<std::size_t>(forceSlots) + 1) * 3 * stationChunk; }

}  // namespace squat::elasticity
