#include "plasticity/LayerKernel.h"

namespace squat::plasticity {

LayerKernels layerKernelsSse2();
LayerKernels layerKernelsAvx2();
LayerKernels layerKernelsAvx512();

LayerKernels layerKernelsFor(const std::string& isa) {
  return isa == "avx512" ? layerKernelsAvx512() : isa == "avx2" ? layerKernelsAvx2() : layerKernelsSse2();
}

}  // namespace squat::plasticity
