// Body of the kernels; included once per instruction set with LANES (doubles a vector) and WIDEST (vectors a group)
// set. GCC vector types: the same text for every width. No reassociation is allowed, so that a lane's result does not
// depend on how stations are grouped.
#include <chrono>

#include "elasticity/SweptKernel.h"

namespace squat::elasticity {
namespace {

using Vector = double __attribute__((vector_size(LANES * sizeof(double)), may_alias));
using Loose = double __attribute__((vector_size(LANES * sizeof(double)), aligned(8), may_alias));

inline Vector loadLoose(const double* p) { return *reinterpret_cast<const Loose*>(p); }
inline Vector load(const double* p) { return *reinterpret_cast<const Vector*>(p); }
inline void store(double* p, Vector v) { *reinterpret_cast<Vector*>(p) = v; }
inline Vector splat(double value) { return value - Vector{}; }

// What the elasticity is computed in: vectors of COUNT numbers. State vectors, and the step itself, are double always.
template <typename Number, int COUNT>
struct Arithmetic {
  using Real = Number;
  typedef Number Packed __attribute__((vector_size(COUNT * sizeof(Number)), may_alias));  // `using` loses the size
  static constexpr int lanes = COUNT;
  static Packed load(const Real* p) { return *reinterpret_cast<const Packed*>(p); }
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

inline const double* coefficientsOf(const KernelCall& call, double) { return call.coefficients; }
inline const float* coefficientsOf(const KernelCall& call, float) { return call.singleCoefficients; }

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

// The stations that are worked on at a time: within one chunk, `parts` parts of V vectors. Rows go in bundles: within a
// bundle the coefficients of its rows stay in the first-level cache while all parts pass.
struct Group {
  int at = 0, parts = 0;
  std::size_t state = 0;         // of station `at` in line 0 of a state vector
  const double* next = nullptr;  // displacement of node 0 at the station after the group
  std::size_t nextNode = 3 * chunk, nextLine = chunk;
};

inline std::size_t placeOf(const KernelCall& call, int station) {
  return station / chunk * call.chunkSize + station % chunk;
}

inline std::size_t placeOfMass(const KernelCall& call, int node, int station) {
  return station / chunk * (call.chunkSize / 3) + node * std::size_t{chunk} + station % chunk;
}

// Vectors a part where fewer than a whole chunk of stations are left: their number is a multiple of eight.
template <typename Kind>
constexpr int narrowest = 8 / Kind::lanes < WIDEST ? 8 / Kind::lanes : WIDEST;

// A rigid translation of the group, in the local components of each station and the one after: it strains nothing, and
// without it displacements are small enough to be rounded. Taken from one node at the first station of the chunk, so
// that it does not depend on where stretches are cut.
template <bool>
struct Translation {
  Translation(const KernelCall&, const Group&, int) {}
};
template <>
struct Translation<true> {
  alignas(64) double lines[3][chunk + 1];

  Translation(const KernelCall& call, const Group& group, int count) {
    const int from = group.at / chunk * chunk;
    const double* u = call.source + placeOf(call, from) + static_cast<std::size_t>(call.nodes / 2) * 3 * chunk;
    std::size_t line = chunk;
    if (call.references) u = call.references + 3 * (from / chunk - call.firstReference), line = 1;
    const double a = u[0], b = u[line], c = u[2 * line];
    for (int i = 0; i <= count; ++i) {
      double cosine = 1, sine = 0;
      if (call.cosines) {
        const double *cosines = call.cosines, *sines = call.sines;
        const int s = group.at + i;
        cosine = cosines[s] * cosines[from] + sines[s] * sines[from];
        sine = sines[s] * cosines[from] - cosines[s] * sines[from];
      }
      lines[0][i] = cosine * a - sine * b, lines[1][i] = cosine * b + sine * a, lines[2][i] = c;
    }
  }
};

// Sums and differences of both stations of one node, for each part: d_a, s_b, s_c, s_a, d_b, d_c.
template <typename Kind, int V, bool ROUNDS>
inline void gather(const KernelCall& call, const Group& group, const Translation<ROUNDS>& rigid, int node, int slot) {
  using Real = typename Kind::Real;
  constexpr int part = V * Kind::lanes;
  Real* out = reinterpret_cast<Real*>(call.workspace) + slot * std::size_t{6 * chunk};
  const std::size_t lines = static_cast<std::size_t>(node) * 3 * chunk;
  const double *line = call.source + group.state + lines, *next = group.next + node * group.nextNode;
  const int count = group.parts * part;
  for (int c = 0; c < 3; ++c, line += chunk, next += group.nextLine) {
    Real *sums = out + (c == 0 ? 3 : c) * part, *differences = out + (c == 0 ? 0 : c + 3) * part;
    const auto at = [&](int i) {
      Vector u = i < count ? load(line + i) : splat(*next);
      if constexpr (ROUNDS) u -= i < count ? loadLoose(rigid.lines[c] + i) : splat(rigid.lines[c][count]);
      return u;
    };
    Vector left = at(0);
    for (int i = 0; i < count; i += LANES) {
      const Vector after = at(i + LANES);
      const Vector right = advanced(left, after);
      const int to = i / part * 6 * part + i % part;
      storeAs(sums + to, right + left);
      storeAs(differences + to, right - left);
      left = after;
    }
  }
}

// The processor's own prefetchers do not know the order of the nodes.
template <int COUNT, int WRITE>
inline void fetch(const double* values) {
  for (int i = 0; i < COUNT; i += 8) __builtin_prefetch(values + i, WRITE, 2);
}

// Inner force of one row's node on the stations of one part, and the carry to the next.
template <typename Kind, int V>
inline void innerForce(const KernelCall& call, int row, int part, typename Kind::Packed (&force)[3][V]) {
  using Real = typename Kind::Real;
  using Packed = typename Kind::Packed;
  constexpr int lanes = Kind::lanes;
  Packed s[3][V], t[3][V];
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < V; ++v) s[c][v] = Packed{}, t[c][v] = Packed{};
  const Real* workspace = reinterpret_cast<const Real*>(call.workspace) + part * 6 * V * lanes;
  const Real* k = coefficientsOf(call, Real{}) + 18 * static_cast<std::size_t>(call.rowStart[row]);
  const int *slot = call.slots + call.rowStart[row], *end = call.slots + call.rowStart[row + 1];
  for (; slot != end; ++slot, k += 18) {
    const Real* in = workspace + *slot * std::size_t{6 * chunk};
#pragma GCC unroll 3
    for (int column = 0; column < 3; ++column) {
      Packed x[V];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = Kind::load(in + (column * V + v) * lanes);
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) s[line][v] += k[3 * line + column] * x[v];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = Kind::load(in + ((column + 3) * V + v) * lanes);
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) t[line][v] += k[9 + 3 * line + column] * x[v];
    }
  }
  for (int c = 0; c < 3; ++c) {
    double* carry = call.carry + 3 * call.order[row] + c;
    Packed before = Kind::splat(*carry);
    for (int v = 0; v < V; ++v) {
      const Packed right = s[c][v] + t[c][v];
      const Packed left = c == 0 ? t[c][v] - s[c][v] : s[c][v] - t[c][v];
      force[c][v] = left + Kind::shifted(before, right);
      before = right;
    }
    *carry = before[lanes - 1];
  }
}

// Goes through the rows of a group: a node is gathered shortly before the first row that needs it. The forces of a
// bundle are collected, so that `row(row, force)` meets whole lines: memory comes in long pieces then.
template <typename Kind, int V, typename Ahead, typename Row>
inline void overRows(const KernelCall& call, const Group& group, const Ahead& ahead, const Row& row) {
  alignas(64) typename Kind::Real forces[rowBundle][3][chunk];
  const Translation<(sizeof(typename Kind::Real) < sizeof(double))> rigid(call, group, group.parts * V * Kind::lanes);
  int gathered = 0, slot = 0;
  for (int first = 0, bundle = 0; first < call.nodes; first += rowBundle, ++bundle) {
    for (const int upTo = call.gatherUpTo[bundle]; gathered < upTo; ++gathered) {
      gather<Kind, V>(call, group, rigid, call.order[gathered], slot);
      slot = slot + 1 == call.window ? 0 : slot + 1;
    }
    const int end = first + rowBundle < call.nodes ? first + rowBundle : call.nodes;
    for (int part = 0; part < group.parts; ++part)
      for (int i = first; i < end; ++i) {
        if (part == 0) ahead(call.order[i]);
        typename Kind::Packed force[3][V];
        innerForce<Kind, V>(call, i, part, force);
        for (int c = 0; c < 3; ++c)
          for (int v = 0; v < V; ++v) Kind::store(forces[i - first][c] + (part * V + v) * Kind::lanes, force[c][v]);
      }
    for (int i = first; i < end; ++i) row(call.order[i], forces[i - first]);
  }
}

template <typename Kind, int V>
inline void applyGroup(const KernelCall& call, const Group& group) {
  double* out = call.force + group.state;
  overRows<Kind, V>(
      call, group, [](int) {},
      [&](int node, const typename Kind::Real(&force)[3][chunk]) {
        double* lines = out + static_cast<std::size_t>(node) * 3 * chunk;
        for (int c = 0; c < 3; ++c)
          for (int i = 0; i < group.parts * V * Kind::lanes; i += LANES)
            store(lines + c * chunk + i, widened(force[c] + i));
      });
}

// One node through the central difference on all stations of the group.
template <typename Real>
inline void advanceNode(const KernelCall& call, const Group& group, int n, int count, const Real (&force)[3][chunk]) {
  const std::size_t stride = call.stride;
  const std::size_t base = group.state + static_cast<std::size_t>(n) * 3 * chunk;
  const double* source = call.source + base;
  if (call.turningMoment)
    for (int i = 0; i < count; i += LANES) {
      double* moment = call.turningMoment + group.at + i;
      store(moment, load(moment) +
                        (load(source + i) * widened(force[1] + i) - load(source + chunk + i) * widened(force[0] + i)));
    }
  const int line = call.externalLine[n];
  double* outer = line < 0 ? nullptr : call.external + static_cast<std::size_t>(line) * 3 * stride + group.at;
  if (call.slave[n]) {
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < count; i += LANES) store(outer + c * stride + i, widened(force[c] + i));
    return;
  }
  const double step = call.step, beta = call.beta, both = step + beta, cosine = call.cosine, sine = call.sine;
  const double spin = call.radialWeight ? call.spinAcceleration * call.radialWeight[n] : 0.0;
  const double pushed[3] = {spin, 0, 0};
  const double* inverse = call.inverseMass + placeOfMass(call, n, group.at);
  double *rates = call.velocity + base, *target = call.target + base;
  for (int c = 0; c < 3; ++c) {
    const double mask = call.fixedMask[3 * n + c], push = pushed[c];
    const double* body = call.acceleration + c * stride + group.at;
    const Real* inner = force[c];
    double* added = outer ? outer + c * stride : nullptr;
    for (int i = 0; i < count; i += LANES) {
      Vector total = -widened(inner + i);
      if (added) {
        total += load(added + i);
        store(added + i, Vector{});
      }
      const Vector acceleration = total * load(inverse + i) + (load(body + i) + push);
      const Vector old = load(rates + c * chunk + i);
      const Vector velocity = (old + step * acceleration) * mask;
      store(rates + c * chunk + i, velocity);
      store(target + c * chunk + i, load(source + c * chunk + i) - beta * old + both * velocity);
    }
  }
  if (sine == 0) return;
  for (double* lines : {rates, target})
    for (int i = 0; i < count; i += LANES) {
      const Vector a = load(lines + i), b = load(lines + chunk + i);
      store(lines + i, cosine * a + sine * b);
      store(lines + chunk + i, cosine * b - sine * a);
    }
}

template <typename Kind, int V>
inline void advanceGroup(const KernelCall& call, const Group& group) {
  overRows<Kind, V>(
      call, group,
      [&](int node) {
        const std::size_t base = group.state + static_cast<std::size_t>(node) * 3 * chunk;
        fetch<3 * chunk, 1>(call.velocity + base);
        if (call.target != call.source) fetch<3 * chunk, 1>(call.target + base);
        fetch<chunk, 0>(call.inverseMass + placeOfMass(call, node, group.at));
      },
      [&](int node, const typename Kind::Real(&force)[3][chunk]) {
        advanceNode(call, group, node, group.parts * V * Kind::lanes, force);
      });
}

template <typename Kind>
void carryOver(const KernelCall& call) {
  const int at = call.first - Kind::lanes;
  overRows<Kind, 1>(
      call, {at, 1, placeOf(call, at), call.source + placeOf(call, call.first)}, [](int) {},
      [](int, const typename Kind::Real(&)[3][chunk]) {});
}

// Whole chunks in vectors of one kind, and what lies in a chunk with the end of a run or stretch in those of another.
template <typename WholeKind, typename PieceKind, typename Whole, typename Piece>
inline void overGroups(const KernelCall& call, const Whole& whole, const Piece& piece) {
  const int end = call.first + call.count;
  for (int at = call.first; at < end;) {
    const int stop = (at / chunk + 1) * chunk < end ? (at / chunk + 1) * chunk : end, count = stop - at;
    Group group{at, 0, placeOf(call, at), call.source + placeOf(call, stop)};
    if (stop == end && call.after) group.next = call.after, group.nextNode = 3, group.nextLine = 1;
    if (count == chunk) {
      group.parts = chunk / (WIDEST * WholeKind::lanes);
      whole(group);
    } else {
      group.parts = count / (narrowest<PieceKind> * PieceKind::lanes);
      piece(group);
    }
    at = stop;
  }
}

template <typename WholeKind, typename PieceKind>
void applyStiffness(const KernelCall& call) {
  overGroups<WholeKind, PieceKind>(
      call, [&](const Group& group) { applyGroup<WholeKind, WIDEST>(call, group); },
      [&](const Group& group) { applyGroup<PieceKind, narrowest<PieceKind>>(call, group); });
}

template <typename WholeKind, typename PieceKind>
void advanceStep(const KernelCall& call) {
  overGroups<WholeKind, PieceKind>(
      call, [&](const Group& group) { advanceGroup<WholeKind, WIDEST>(call, group); },
      [&](const Group& group) { advanceGroup<PieceKind, narrowest<PieceKind>>(call, group); });
}

// Twelve independent chains hide the latency of the multiply-add; what comes out is the peak of one core.
double multiplyAddPeak(double seconds) {
  Vector x[12];
  for (int i = 0; i < 12; ++i) x[i] = splat(1.0 + 1e-3 * i);
  const Vector a = splat(0.999999), b = splat(1e-6);
  long rounds = 0;
  const auto start = std::chrono::steady_clock::now();
  double elapsed = 0;
  do {
    for (int k = 0; k < 2000; ++k)
#pragma GCC unroll 12
      for (int i = 0; i < 12; ++i) x[i] = x[i] * a + b;
    rounds += 2000;
    elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  } while (elapsed < seconds);
  double sum = 0;
  for (int i = 0; i < 12; ++i) sum += x[i][0];
  return sum > 1e300 ? 0 : 2.0 * 12 * LANES * static_cast<double>(rounds) / elapsed;
}

KernelSet kernels(const char* name, Precision precision) {
  if (precision == Precision::singleInside)
    return {name,
            precision,
            applyStiffness<Single, SinglePiece>,
            carryOver<SinglePiece>,
            advanceStep<Single, SinglePiece>,
            multiplyAddPeak};
  return {name,           precision, applyStiffness<Double, Double>, carryOver<Double>, advanceStep<Double, Double>,
          multiplyAddPeak};
}

}  // namespace
}  // namespace squat::elasticity
