#include "elasticity/SweptKernelUnits.h"

namespace squat::elasticity {

KernelSet kernelsSse2(Precision precision);
KernelSet kernelsAvx2(Precision precision);
KernelSet kernelsAvx512(Precision precision);

std::vector<KernelUnit> kernelUnits() {
  const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool hasAvx512 = hasAvx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                         __builtin_cpu_supports("avx512vl");
  return {{"sse2", true, kernelsSse2}, {"avx2", hasAvx2, kernelsAvx2}, {"avx512", hasAvx512, kernelsAvx512}};
}

}  // namespace squat::elasticity
