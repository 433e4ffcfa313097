// solver/elasticity/SweptKernel.h - the inner loop of the whole program, once for each instruction set.
//
// The kernels' sources may include nothing but this header and what it includes: inline functions of other headers
// would be compiled for their instruction set, and the linker might choose those for the whole program.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace squat::elasticity {

constexpr int stationChunk = 32;   // stations that state vectors keep together (SweptBlock.h)
constexpr int rowBundle = 8;       // rows that share their coefficients in the first-level cache
constexpr int maximumRows = 32;    // nodes of a cluster
constexpr int advancedPerRow = 2;  // nodes that are advanced after each row: they keep up and wait for clusters only

// Between the force and the velocity of a node stand its accelerations times its station's mass (SweptBlock.h): for
// nodes with a mass of the section alone that is their force times one number (evenInverse).

// SelectiveMassScaling: clusters share their inertia with 16 stations, [16 k, 16 k + 16), where these are of one run,
// else with eight. What is kept along the sweep, two fields: their weights in both amplitudes, then both fields, a line
// of stations each. Where a run's stand: on eight and on 16 stations; of the run's first group, which shares a station
// with the run before, and of the others.
constexpr int stationUnit = 8, maximumStations = 16, keptAlong = 2;
constexpr int projectionLocation[2][2] = {{0, 32}, {64, 128}}, projectionsSize = 192;

// Intervals of one length, [first, last), both multiples of 8.
struct KernelRun {
  int first = 0, last = 0;
  double length = 0;                          // in the unit of the stations
  const double* coefficients = nullptr;       // in the order of the rows
  const float* singleCoefficients = nullptr;  // the same
  const double* along = nullptr;       // SelectiveMassScaling: projections along the sweep (of accelerations times
                                       // station mass), or null
  const float* singleAlong = nullptr;  // the same
};

// Places [first, end) whose nodes share the inertia of short waves.
struct KernelCluster {
  int first = 0, end = 0;
};

// Filter of a cluster on its stations whose masses are no product: weights in the amplitudes of six fields, then the
// fields, [2][keptInBlock][rows][stations].
constexpr int keptAcross = 3, keptInBlock = keptAcross * keptAlong;
struct KernelFilter {
  const double* values = nullptr;
  const float* singleValues = nullptr;
};

// A stretch of intervals [first, first + count), both multiples of 8. Memory as laid out in SweptBlock.h; pointers are
// to the first value of the block.
struct KernelCall {
  int nodes = 0;
  const int* order = nullptr;  // SectionOrder, as are the next ten
  const int* bundleStart = nullptr;
  int bundles = 0;
  const int* rowStart = nullptr;
  const int* slots = nullptr;
  const int* gatherUpTo = nullptr;
  int window = 0;
  const int* members = nullptr;
  const int* memberSlot = nullptr;
  const int* rowSlot = nullptr;
  const int* readyAfter = nullptr;
  int middle = 0, far = 0;              // nodes next to the section's centre and farthest from it
  const double* coordinates = nullptr;  // nodes x 2: section coordinates [m]
  const KernelRun* runs = nullptr;      // of the whole block
  std::size_t stride = 0;               // of the lines of masses, forces and accelerations
  std::size_t chunkSize = 0;            // doubles of a chunk of the state vectors
  int first = 0, count = 0;
  const double* source = nullptr;                     // displacement that the elasticity acts on, u + beta v
  const double *cosines = nullptr, *sines = nullptr;  // around an axis: of every station's angle; null along a line
  double* carry = nullptr;      // nodes x 3: what the interval before adds to station `first`; left for the next
  double* workspace = nullptr;  // kernelWorkspace(window) doubles, 64-byte aligned
  double* waiting = nullptr;    // forceWorkspace(forceSlots) doubles, 64-byte aligned
  // Where `target` is `source`: displacements at station first + count as they were before this step, nodes x 3
  // (SegmentEnds), else null.
  const double* after = nullptr;

  // applyStiffness: K times source, stations first .. first + count - 1 written.
  double* force = nullptr;

  // advanceStep: one step of the central difference for the same stations.
  const double* stationMass = nullptr;   // one line
  const double* inverseMass = nullptr;   // one value for each node and station, in chunks
  const double* evenInverse = nullptr;   // per node: inverse mass times station mass, or 0: as in inverseMass
  const double* fixedMask = nullptr;     // nodes x 3: 1 free, 0 fixed
  const int* externalLine = nullptr;     // per node: line triple in `external`, or -1
  const unsigned char* slave = nullptr;  // per node: 1: not advanced, its inner force is left in `external` instead
  double* external = nullptr;            // triples of lines; added to the inner force and cleared
  double* velocity = nullptr;            // in place
  double* target = nullptr;              // new u + beta v; may be `source`
  // 3 lines: body acceleration of each station in local components; null: evenAcceleration at all stations, no line is
  // fixed, and the wheelset is not accelerated about its axis.
  const double* acceleration = nullptr;
  double evenAcceleration[3] = {};
  const double* radialWeight = nullptr;     // per node: radius, for the angular acceleration; or null
  double angularAcceleration = 0;           // [rad/s2] added times radius to a
  double step = 0, beta = 0;                // [s]
  double cosine = 1, sine = 0;              // of the angle by which the local basis turns in this step
  const KernelCluster* clusters = nullptr;  // SelectiveMassScaling, as are the next four
  int clusterCount = 0;
  const double* clusterWeights = nullptr;
  const float* singleClusterWeights = nullptr;
  double shortShare = 1;
  // Per cluster and eight stations, the first of those that share: index into `filters` or -1; null: none has one.
  const int* ownFilter = nullptr;
  int stationUnits = 0;  // of eight, in the whole block
  const KernelFilter* filters = nullptr;
  // One line, or null: per station += sum of w_a f_b - w_b f_a [N m], w = u + beta v, f = K w.
  double* turningMoment = nullptr;
};

// What the elasticity is computed in. Single inside: sums and differences of neighbouring stations are formed from the
// double state, then rounded; forces go back to double. State and step are double always.
enum class Precision { doubleInside, singleInside };

struct KernelSet {
  std::string name;  // "sse2", "avx2", "avx512"; "neon"
  Precision precision = Precision::doubleInside;
  void (*applyStiffness)(const KernelCall&) = nullptr;
  void (*carryOver)(const KernelCall&) = nullptr;  // carry of the interval before call.first, nothing else
  void (*advanceStep)(const KernelCall&) = nullptr;
  double (*multiplyAddPeak)(double seconds) = nullptr;  // measured multiply-add peak of one core [flop/s]
};

// Kernels for a named instruction set; empty: the best that this processor has. Throws std::invalid_argument for a name
// that is not known or that this processor lacks.
KernelSet kernelsFor(const std::string& isa, Precision precision = Precision::doubleInside);
std::vector<std::string> availableInstructionSets();  // the best last
std::vector<std::string> knownInstructionSets();      // whether or not this one of the kind of processor has them

std::size_t kernelWorkspace(int window);     // doubles
std::size_t forceWorkspace(int forceSlots);  // doubles

}  // namespace squat::elasticity
