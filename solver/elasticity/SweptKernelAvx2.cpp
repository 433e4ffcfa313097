#define LANES 4
#define WIDEST 2
#include "elasticity/SweptKernelX86.inl"

namespace squat::elasticity {

KernelSet kernelsAvx2(Precision precision) { return kernels("avx2", precision); }

}  // namespace squat::elasticity
