// What the kernels of one instruction set work with; LANES (doubles a vector) and WIDEST (vectors a group) are set. GCC
// vector types: the same text for every width. No reassociation is allowed, so that a lane's result does not depend on
// how stations are grouped; products and sums may become one operation (cmake/Kernels.cmake).
#include "elasticity/SweptKernel.h"

namespace squat::elasticity {
namespace {

using Vector = double __attribute__((vector_size(LANES * sizeof(double)), may_alias));
inline Vector load(const double* p) { return *reinterpret_cast<const Vector*>(p); }
inline void store(double* p, Vector v) { *reinterpret_cast<Vector*>(p) = v; }
inline Vector splat(double value) { return value - Vector{}; }

// What the elasticity is computed in: vectors of COUNT numbers. State vectors, and the step itself, are double always.
template <typename Number, int COUNT>
struct Arithmetic {
  using Real = Number;
  typedef Number Packed __attribute__((vector_size(COUNT * sizeof(Number)), may_alias));  // `using` loses the size
  static constexpr int lanes = COUNT;
  typedef Number Loose __attribute__((vector_size(COUNT * sizeof(Number)), aligned(sizeof(Number)), may_alias));
  static Packed load(const Real* p) { return *reinterpret_cast<const Packed*>(p); }
  static Packed loadLoose(const Real* p) { return *reinterpret_cast<const Loose*>(p); }
  static void store(Real* p, Packed v) { *reinterpret_cast<Packed*>(p) = v; }
  static Packed splat(double value) { return static_cast<Real>(value) - Packed{}; }
  // Last lane of `before`, then all but the last of `now`.
  static Packed shifted(Packed before, Packed now) {
    if constexpr (COUNT == 16)
      return __builtin_shufflevector(before, now, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30);
    else if constexpr (COUNT == 8)
      return __builtin_shufflevector(before, now, 7, 8, 9, 10, 11, 12, 13, 14);
    else if constexpr (COUNT == 4)
      return __builtin_shufflevector(before, now, 3, 4, 5, 6);
    else
      return __builtin_shufflevector(before, now, 1, 2);
  }
};
using Double = Arithmetic<double, LANES>;
using Single = Arithmetic<float, 2 * LANES>;
// Stations come in multiples of eight: the widest vectors do not fit every piece.
using SinglePiece = Arithmetic<float, (2 * LANES < 8 ? 2 * LANES : 8)>;

// As many single numbers as a Vector holds doubles.
using Half = float __attribute__((vector_size(LANES * sizeof(float)), may_alias));
inline Vector widened(const double* p) { return load(p); }
inline Vector widened(const float* p) { return __builtin_convertvector(*reinterpret_cast<const Half*>(p), Vector); }
inline void storeAs(double* p, Vector v) { store(p, v); }
inline void storeAs(float* p, Vector v) { *reinterpret_cast<Half*>(p) = __builtin_convertvector(v, Half); }

inline const double* coefficientsOf(const KernelRun& run, double) { return run.coefficients; }
inline const float* coefficientsOf(const KernelRun& run, float) { return run.singleCoefficients; }
inline const double* alongOf(const KernelRun& run, double) { return run.along; }
inline const float* alongOf(const KernelRun& run, float) { return run.singleAlong; }
inline const double* clusterWeightsOf(const KernelCall& call, double) { return call.clusterWeights; }
inline const float* clusterWeightsOf(const KernelCall& call, float) { return call.singleClusterWeights; }
inline const double* filterOf(const KernelFilter& filter, double) { return filter.values; }
inline const float* filterOf(const KernelFilter& filter, float) { return filter.singleValues; }

// All but the first lane of `now`, then the first of `after`.
inline Vector advanced(Vector now, Vector after) {
#if LANES == 8
  return __builtin_shufflevector(now, after, 1, 2, 3, 4, 5, 6, 7, 8);
#elif LANES == 4
  return __builtin_shufflevector(now, after, 1, 2, 3, 4);
#else
  return __builtin_shufflevector(now, after, 1, 2);
#endif
}

constexpr int chunk = stationChunk;

// Vectors at a time where many stations of one run follow each other (half of them where fewer are left, and so on),
// and where only eight may be left.
template <typename Kind>
constexpr int wide = WIDEST* Kind::lanes < chunk ? WIDEST : chunk / Kind::lanes;
template <typename Kind>
constexpr int narrow = 8 / Kind::lanes < WIDEST ? 8 / Kind::lanes : WIDEST;

// Parts of these widths fill any stretch of stations, whole chunks with wide ones alone.
template <typename Whole, typename Piece>
constexpr bool fills = chunk % (wide<Whole> * Whole::lanes) == 0 && 8 % (narrow<Piece> * Piece::lanes) == 0;
static_assert(fills<Double, Double> && fills<Single, SinglePiece>);

// Stations of a group that are worked on together: of one run, or every eight of a run of their own (a mixed part).
template <typename Real>
struct Part {
  int offset = 0, width = 0;  // first station in the group, and how many
  bool isMixed = false;
  const Real* coefficients[chunk / 8] = {};  // of every eight stations
};

// The stations that are worked on at a time: those of one chunk. Rows go in bundles: within a bundle the coefficients
// of its rows stay in the first-level cache while all parts pass.
template <typename Real>
struct Group {
  int at = 0, count = 0, parts = 0;
  Part<Real> part[chunk / 4];
  // Per eight stations: projection along the sweep of the 8 or 16 that begin here, or null.
  const Real* along[chunk / stationUnit] = {};
  int alongStations[chunk / stationUnit] = {};
  alignas(64) double stepOver[chunk];  // a step: over the mass of each station
  std::size_t state = 0;               // of station `at` in line 0 of a state vector
  const double* next = nullptr;        // displacement of node 0 at the station after the group
  std::size_t nextNode = 3 * chunk, nextLine = chunk;
};

// Where the forces of nodes wait for each other: three lines of a chunk each.
template <typename Real>
inline Real (*waiting(const KernelCall& call, int slot))[3][chunk] {
  return reinterpret_cast<Real(*)[3][chunk]>(call.waiting) + slot;
}

inline std::size_t stateIndex(const KernelCall& call, int station) {
  return station / chunk * call.chunkSize + station % chunk;
}

inline std::size_t massIndex(const KernelCall& call, int node, int station) {
  return station / chunk * (call.chunkSize / 3) + node * std::size_t{chunk} + station % chunk;
}

}  // namespace
}  // namespace squat::elasticity
