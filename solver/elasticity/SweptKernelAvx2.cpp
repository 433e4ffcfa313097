#define LANES 4
#define WIDEST 2
#include "elasticity/SweptKernel.inl"

namespace squat::elasticity {

KernelSet kernelsAvx2(Precision precision) { return kernels("avx2", precision); }

}  // namespace squat::elasticity
