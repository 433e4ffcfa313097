#define LANES 2
#include "plasticity/LayerKernel.inl"

namespace squat::plasticity {

LayerKernels layerKernelsNeon() { return {returnToYield, plasticForce}; }

}  // namespace squat::plasticity
