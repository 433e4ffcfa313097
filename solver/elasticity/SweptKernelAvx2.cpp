#define LANES 4
#define WIDEST 2
#include "elasticity/SweptKernel.inl"

namespace squat::elasticity {

KernelSet kernelsAvx2() { return {"avx2", applyStiffness, carryOver, advanceStep, multiplyAddPeak}; }

}  // namespace squat::elasticity
