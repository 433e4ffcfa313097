#define LANES 2
#include "plasticity/LayerKernel.inl"

namespace squat::plasticity {

LayerKernels layerKernelsSse2() { return {returnToYield, plasticForce}; }

}  // namespace squat::plasticity
