#define LANES 4
#include "plasticity/LayerKernel.inl"

namespace squat::plasticity {

LayerKernels layerKernelsAvx2() { return {returnToYield, plasticForce}; }

}  // namespace squat::plasticity
