#define LANES 2
#define WIDEST 2
#include "elasticity/SweptKernelX86.inl"

namespace squat::elasticity {

KernelSet kernelsSse2(Precision precision) { return kernels("sse2", precision); }

}  // namespace squat::elasticity
