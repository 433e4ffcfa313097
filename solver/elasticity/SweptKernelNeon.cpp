// Thirty-two registers, as AVX-512 has: groups of as many vectors.
#define LANES 2
#define WIDEST 4
#include "elasticity/SweptKernelArm64.inl"

namespace squat::elasticity {

KernelSet kernelsNeon(Precision precision) { return kernels("neon", precision); }

}  // namespace squat::elasticity
