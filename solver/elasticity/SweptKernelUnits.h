// solver/elasticity/SweptKernelUnits.h - the kernels that there are for one kind of processor. Each kind has a source
// of its own, SweptKernelUnitsX86.cpp and so on; cmake/Kernels.cmake takes the one that is compiled for.
#pragma once

#include <string>
#include <vector>

#include "elasticity/SweptKernel.h"

namespace squat::elasticity {

struct KernelUnit {
  std::string name;       // of its instruction set
  bool isUsable = false;  // this processor has it
  KernelSet (*kernels)(Precision) = nullptr;
};

std::vector<KernelUnit> kernelUnits();  // the better the later; the first is usable on every processor

}  // namespace squat::elasticity
