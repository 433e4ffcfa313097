#include "elasticity/SweptKernelUnits.h"

namespace squat::elasticity {

KernelSet kernelsNeon(Precision precision);

std::vector<KernelUnit> kernelUnits() { return {{"neon", true, kernelsNeon}}; }

}  // namespace squat::elasticity
