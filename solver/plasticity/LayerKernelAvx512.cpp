#define LANES 8
#include "plasticity/LayerKernel.inl"

namespace squat::plasticity {

LayerKernels layerKernelsAvx512() { return {returnToYield, plasticForce}; }

}  // namespace squat::plasticity
