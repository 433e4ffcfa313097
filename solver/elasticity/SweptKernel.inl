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

// Sums and differences of both stations for all nodes: per node d_a, s_b, s_c, s_a, d_b, d_c.
template <int V>
inline void gather(const KernelCall& call, int at) {
  double* out = call.workspace;
  for (int n = 0; n < call.nodes; ++n) {
    const double* line = call.source + static_cast<std::size_t>(n) * 3 * call.stride + at;
    for (int c = 0; c < 3; ++c, line += call.stride)
      for (int v = 0; v < V; ++v) {
        const Vector left = load(line + v * LANES), right = loadLoose(line + v * LANES + 1);
        const Vector sum = right + left, difference = right - left;
        store(out + (c * V + v) * LANES, c == 0 ? difference : sum);
        store(out + ((c + 3) * V + v) * LANES, c == 0 ? sum : difference);
      }
    out += 6 * V * LANES;
  }
}

// Inner force of node n on the stations at .. at + V * LANES - 1, and the carry to the next.
template <int V>
inline void innerForce(const KernelCall& call, int n, Vector (&force)[3][V]) {
  Vector s[3][V], t[3][V];
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < V; ++v) s[c][v] = Vector{}, t[c][v] = Vector{};
  for (int p = call.rowStart[n]; p < call.rowStart[n + 1]; ++p) {
    const double* k = call.coefficients + 18 * static_cast<std::size_t>(p);
    const double* in = call.workspace + static_cast<std::size_t>(call.columns[p]) * 6 * V * LANES;
#pragma GCC unroll 3
    for (int column = 0; column < 3; ++column) {
      Vector x[V];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = load(in + (column * V + v) * LANES);
#pragma GCC unroll 3
      for (int row = 0; row < 3; ++row)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) s[row][v] += k[3 * row + column] * x[v];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = load(in + ((column + 3) * V + v) * LANES);
#pragma GCC unroll 3
      for (int row = 0; row < 3; ++row)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) t[row][v] += k[9 + 3 * row + column] * x[v];
    }
  }
  for (int c = 0; c < 3; ++c) {
    double* carry = call.carry + 3 * n + c;
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

template <int V>
inline void applyGroup(const KernelCall& call, int at) {
  gather<V>(call, at);
  for (int n = 0; n < call.nodes; ++n) {
    Vector force[3][V];
    innerForce<V>(call, n, force);
    for (int c = 0; c < 3; ++c)
      for (int v = 0; v < V; ++v)
        store(call.force + (static_cast<std::size_t>(n) * 3 + c) * call.stride + at + v * LANES, force[c][v]);
  }
}

template <int V>
inline void advanceGroup(const KernelCall& call, int at) {
  gather<V>(call, at);
  const double step = call.step, beta = call.beta, both = step + beta, cosine = call.cosine, sine = call.sine;
  const bool turns = sine != 0;
  for (int n = 0; n < call.nodes; ++n) {
    Vector force[3][V];
    innerForce<V>(call, n, force);
    const int line = call.externalLine[n];
    double* outer = line < 0 ? nullptr : call.external + static_cast<std::size_t>(line) * 3 * call.stride + at;
    if (call.slave[n]) {
      for (int c = 0; c < 3; ++c)
        for (int v = 0; v < V; ++v) store(outer + c * call.stride + v * LANES, force[c][v]);
      continue;
    }
    const std::size_t base = static_cast<std::size_t>(n) * 3 * call.stride + at;
    const double* inverse = call.inverseMass + static_cast<std::size_t>(n) * call.stride + at;
    const double spin = call.radialWeight ? call.spinAcceleration * call.radialWeight[n] : 0.0;
    for (int v = 0; v < V; ++v) {
      const Vector mass = load(inverse + v * LANES);
      Vector velocity[3], displacement[3];
      for (int c = 0; c < 3; ++c) {
        const std::size_t here = base + c * call.stride + v * LANES;
        Vector total = -force[c][v];
        if (outer) {
          total += load(outer + c * call.stride + v * LANES);
          store(outer + c * call.stride + v * LANES, Vector{});
        }
        Vector acceleration = total * mass + load(call.acceleration + c * call.stride + at + v * LANES);
        if (c == 0) acceleration += spin;
        const Vector old = load(call.velocity + here);
        velocity[c] = (old + step * acceleration) * call.fixedMask[3 * n + c];
        displacement[c] = load(call.source + here) - beta * old + both * velocity[c];
      }
      if (turns) {
        const Vector va = velocity[0], vb = velocity[1], ua = displacement[0], ub = displacement[1];
        velocity[0] = cosine * va + sine * vb, velocity[1] = cosine * vb - sine * va;
        displacement[0] = cosine * ua + sine * ub, displacement[1] = cosine * ub - sine * ua;
      }
      for (int c = 0; c < 3; ++c) {
        const std::size_t here = base + c * call.stride + v * LANES;
        store(call.velocity + here, velocity[c]);
        store(call.target + here, displacement[c]);
      }
    }
  }
}

void carryOver(const KernelCall& call) {
  gather<1>(call, call.first - LANES);
  for (int n = 0; n < call.nodes; ++n) {
    Vector force[3][1];
    innerForce<1>(call, n, force);
  }
}

void applyStiffness(const KernelCall& call) {
  int at = call.first;
  const int end = call.first + call.count;
  for (; at + WIDEST * LANES <= end; at += WIDEST * LANES) applyGroup<WIDEST>(call, at);
  for (; at < end; at += LANES) applyGroup<1>(call, at);
}

void advanceStep(const KernelCall& call) {
  int at = call.first;
  const int end = call.first + call.count;
  for (; at + WIDEST * LANES <= end; at += WIDEST * LANES) advanceGroup<WIDEST>(call, at);
  for (; at < end; at += LANES) advanceGroup<1>(call, at);
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
