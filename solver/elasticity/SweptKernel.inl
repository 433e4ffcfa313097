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

// Last lane of `before`, then all but the last of `now`.
inline Vector shifted(Vector before, Vector now) {
#if LANES == 8
  return __builtin_shufflevector(before, now, 7, 8, 9, 10, 11, 12, 13, 14);
#elif LANES == 4
  return __builtin_shufflevector(before, now, 3, 4, 5, 6);
#else
  return __builtin_shufflevector(before, now, 1, 2);
#endif
}

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
  std::size_t state = 0;  // of station `at` in line 0 of a state vector
  std::size_t next = 0;   // of the station after the group
};

inline std::size_t placeOf(const KernelCall& call, int station) {
  return station / chunk * call.chunkSize + station % chunk;
}

inline std::size_t placeOfMass(const KernelCall& call, int node, int station) {
  return station / chunk * (call.chunkSize / 3) + node * std::size_t{chunk} + station % chunk;
}

// Vectors a part where fewer than a whole chunk of stations are left: their number is a multiple of eight.
constexpr int narrowest = 8 / LANES < WIDEST ? 8 / LANES : WIDEST;

// Sums and differences of both stations of one node, for each part: d_a, s_b, s_c, s_a, d_b, d_c.
template <int V>
inline void gather(const KernelCall& call, const Group& group, int node, int slot) {
  double* out = call.workspace + slot * std::size_t{6 * chunk};
  const std::size_t lines = static_cast<std::size_t>(node) * 3 * chunk;
  const double *line = call.source + group.state + lines, *next = call.source + group.next + lines;
  const int vectors = group.parts * V;
  for (int c = 0; c < 3; ++c, line += chunk, next += chunk) {
    double *sums = out + (c == 0 ? 3 : c) * V * LANES, *differences = out + (c == 0 ? 0 : c + 3) * V * LANES;
    Vector left = load(line);
    for (int i = 0; i < vectors; ++i) {
      const Vector after = i + 1 < vectors ? load(line + (i + 1) * LANES) : splat(*next);
      const Vector right = advanced(left, after);
      const std::size_t to = (i / V * 6 * V + i % V) * LANES;
      store(sums + to, right + left);
      store(differences + to, right - left);
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
template <int V>
inline void innerForce(const KernelCall& call, int row, int part, Vector (&force)[3][V]) {
  Vector s[3][V], t[3][V];
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < V; ++v) s[c][v] = Vector{}, t[c][v] = Vector{};
  const double* workspace = call.workspace + part * 6 * V * LANES;
  const double* k = call.coefficients + 18 * static_cast<std::size_t>(call.rowStart[row]);
  const int *slot = call.slots + call.rowStart[row], *end = call.slots + call.rowStart[row + 1];
  for (; slot != end; ++slot, k += 18) {
    const double* in = workspace + *slot * std::size_t{6 * chunk};
#pragma GCC unroll 3
    for (int column = 0; column < 3; ++column) {
      Vector x[V];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = load(in + (column * V + v) * LANES);
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) s[line][v] += k[3 * line + column] * x[v];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = load(in + ((column + 3) * V + v) * LANES);
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) t[line][v] += k[9 + 3 * line + column] * x[v];
    }
  }
  for (int c = 0; c < 3; ++c) {
    double* carry = call.carry + 3 * call.order[row] + c;
    Vector before = splat(*carry);
    for (int v = 0; v < V; ++v) {
      const Vector right = s[c][v] + t[c][v];
      const Vector left = c == 0 ? t[c][v] - s[c][v] : s[c][v] - t[c][v];
      force[c][v] = left + shifted(before, right);
      before = right;
    }
    *carry = before[LANES - 1];
  }
}

// Goes through the rows of a group: a node is gathered shortly before the first row that needs it. The forces of a
// bundle are collected, so that `row(row, force)` meets whole lines: memory comes in long pieces then.
template <int V, typename Ahead, typename Row>
inline void overRows(const KernelCall& call, const Group& group, const Ahead& ahead, const Row& row) {
  alignas(64) double forces[rowBundle][3][chunk];
  int gathered = 0, slot = 0;
  for (int first = 0, bundle = 0; first < call.nodes; first += rowBundle, ++bundle) {
    for (const int upTo = call.gatherUpTo[bundle]; gathered < upTo; ++gathered) {
      gather<V>(call, group, call.order[gathered], slot);
      slot = slot + 1 == call.window ? 0 : slot + 1;
    }
    const int end = first + rowBundle < call.nodes ? first + rowBundle : call.nodes;
    for (int part = 0; part < group.parts; ++part)
      for (int i = first; i < end; ++i) {
        if (part == 0) ahead(call.order[i]);
        Vector force[3][V];
        innerForce<V>(call, i, part, force);
        for (int c = 0; c < 3; ++c)
          for (int v = 0; v < V; ++v) store(forces[i - first][c] + (part * V + v) * LANES, force[c][v]);
      }
    for (int i = first; i < end; ++i) row(call.order[i], forces[i - first]);
  }
}

template <int V>
inline void applyGroup(const KernelCall& call, const Group& group) {
  double* out = call.force + group.state;
  overRows<V>(
      call, group, [](int) {},
      [&](int node, const double(&force)[3][chunk]) {
        double* lines = out + static_cast<std::size_t>(node) * 3 * chunk;
        for (int c = 0; c < 3; ++c)
          for (int v = 0; v < group.parts * V; ++v) store(lines + c * chunk + v * LANES, load(force[c] + v * LANES));
      });
}

// One node through the central difference on all stations of the group.
inline void advanceNode(const KernelCall& call, const Group& group, int n, int vectors,
                        const double (&force)[3][chunk]) {
  const std::size_t stride = call.stride;
  const int line = call.externalLine[n];
  double* outer = line < 0 ? nullptr : call.external + static_cast<std::size_t>(line) * 3 * stride + group.at;
  if (call.slave[n]) {
    for (int c = 0; c < 3; ++c)
      for (int v = 0; v < vectors; ++v) store(outer + c * stride + v * LANES, load(force[c] + v * LANES));
    return;
  }
  const double step = call.step, beta = call.beta, both = step + beta, cosine = call.cosine, sine = call.sine;
  const double spin = call.radialWeight ? call.spinAcceleration * call.radialWeight[n] : 0.0;
  const double pushed[3] = {spin, 0, 0};
  const std::size_t base = group.state + static_cast<std::size_t>(n) * 3 * chunk;
  const double *inverse = call.inverseMass + placeOfMass(call, n, group.at), *source = call.source + base;
  double *rates = call.velocity + base, *target = call.target + base;
  for (int c = 0; c < 3; ++c) {
    const double mask = call.fixedMask[3 * n + c], push = pushed[c];
    const double *body = call.acceleration + c * stride + group.at, *inner = force[c];
    double* added = outer ? outer + c * stride : nullptr;
    for (int i = 0; i < vectors * LANES; i += LANES) {
      Vector total = -load(inner + i);
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
    for (int i = 0; i < vectors * LANES; i += LANES) {
      const Vector a = load(lines + i), b = load(lines + chunk + i);
      store(lines + i, cosine * a + sine * b);
      store(lines + chunk + i, cosine * b - sine * a);
    }
}

template <int V>
inline void advanceGroup(const KernelCall& call, const Group& group) {
  overRows<V>(
      call, group,
      [&](int node) {
        const std::size_t base = group.state + static_cast<std::size_t>(node) * 3 * chunk;
        fetch<3 * chunk, 1>(call.velocity + base);
        fetch<3 * chunk, 1>(call.target + base);
        fetch<chunk, 0>(call.inverseMass + placeOfMass(call, node, group.at));
      },
      [&](int node, const double(&force)[3][chunk]) { advanceNode(call, group, node, group.parts * V, force); });
}

void carryOver(const KernelCall& call) {
  const int at = call.first - LANES;
  overRows<1>(
      call, {at, 1, placeOf(call, at), placeOf(call, call.first)}, [](int) {}, [](int, const double(&)[3][chunk]) {});
}

// Whole chunks, and what lies in a chunk with the end of a run or stretch.
template <typename Whole, typename Piece>
inline void overGroups(const KernelCall& call, const Whole& whole, const Piece& piece) {
  const int end = call.first + call.count;
  for (int at = call.first; at < end;) {
    const int stop = (at / chunk + 1) * chunk < end ? (at / chunk + 1) * chunk : end, count = stop - at;
    Group group{at, 0, placeOf(call, at), placeOf(call, stop)};
    if (count == chunk) {
      group.parts = chunk / (WIDEST * LANES);
      whole(group);
    } else {
      group.parts = count / (narrowest * LANES);
      piece(group);
    }
    at = stop;
  }
}

void applyStiffness(const KernelCall& call) {
  overGroups(
      call, [&](const Group& group) { applyGroup<WIDEST>(call, group); },
      [&](const Group& group) { applyGroup<narrowest>(call, group); });
}

void advanceStep(const KernelCall& call) {
  overGroups(
      call, [&](const Group& group) { advanceGroup<WIDEST>(call, group); },
      [&](const Group& group) { advanceGroup<narrowest>(call, group); });
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

}  // namespace
}  // namespace squat::elasticity
