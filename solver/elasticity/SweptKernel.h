// solver/elasticity/SweptKernel.h - the inner loop of the whole program, once for each instruction set.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace squat::elasticity {

// One run's stretch of intervals [first, first + count), count a multiple of 8. All lines as in SweptBlock: component
// lines of `stride` doubles; pointers are to the first line of the block.
struct KernelCall {
  int nodes = 0;
  const int* rowStart = nullptr;
  const int* columns = nullptr;
  const double* coefficients = nullptr;  // of the run
  std::size_t stride = 0;
  int first = 0, count = 0;
  const double* source = nullptr;  // displacement that the elasticity acts on, u + beta v
  double* carry = nullptr;         // nodes x 3: what the interval before adds to station `first`; left for the next
  double* workspace = nullptr;     // kernelWorkspace(nodes) doubles, 64-byte aligned

  // applyStiffness: K times source, stations first .. first + count - 1 written.
  double* force = nullptr;

  // advanceStep: one step of the central difference for the same stations.
  const double* inverseMass = nullptr;   // nodes lines (one per node)
  const double* fixedMask = nullptr;     // nodes x 3: 1 free, 0 held
  const int* externalLine = nullptr;     // per node: line triple in `external`, or -1
  const unsigned char* slave = nullptr;  // per node: 1: not advanced, its inner force is left in `external` instead
  double* external = nullptr;            // triples of lines; added to the inner force and cleared
  double* velocity = nullptr;            // in place
  double* target = nullptr;              // new u + beta v
  const double* acceleration = nullptr;  // 3 lines: body acceleration of each station in local components
  const double* radialWeight = nullptr;  // per node: radius for the spin, or null
  double spinAcceleration = 0;           // [rad/s2] added times radius to a
  double step = 0, beta = 0;             // [s]
  double cosine = 1, sine = 0;           // of the angle by which the local basis turns in this step
};

struct KernelSet {
  std::string name;  // "sse2", "avx2", "avx512"
  void (*applyStiffness)(const KernelCall&) = nullptr;
  void (*carryOver)(const KernelCall&) = nullptr;  // carry of the interval before call.first, nothing else
  void (*advanceStep)(const KernelCall&) = nullptr;
  double (*multiplyAddPeak)(double seconds) = nullptr;  // measured multiply-add peak of one core [flop/s]
};

// Kernels for a named instruction set; empty: the best that this processor has. Throws std::invalid_argument for a name
// that is not known or that this processor lacks.
KernelSet kernelsFor(const std::string& isa);
std::vector<std::string> availableInstructionSets();

std::size_t kernelWorkspace(int nodes);  // doubles

}  // namespace squat::elasticity
