#define LANES 8
#define WIDEST 4
#include "elasticity/SweptKernelX86.inl"

namespace squat::elasticity {

KernelSet kernelsAvx512(Precision precision) { return kernels("avx512", precision); }

}  // namespace squat::elasticity
