#define LANES 8
#define WIDEST 4
#include "elasticity/SweptKernel.inl"

namespace squat::elasticity {

KernelSet kernelsAvx512() { return {"avx512", applyStiffness, carryOver, advanceStep, multiplyAddPeak}; }

}  // namespace squat::elasticity
