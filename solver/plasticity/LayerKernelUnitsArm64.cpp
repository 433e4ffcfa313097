#include "plasticity/LayerKernel.h"

namespace squat::plasticity {

LayerKernels layerKernelsNeon();

LayerKernels layerKernelsFor(const std::string&) { return layerKernelsNeon(); }

}  // namespace squat::plasticity
