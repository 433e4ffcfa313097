#define LANES 2
#define WIDEST 2
#include "elasticity/SweptKernel.inl"

namespace squat::elasticity {

KernelSet kernelsSse2() { return {"sse2", applyStiffness, carryOver, advanceStep, multiplyAddPeak}; }

}  // namespace squat::elasticity
