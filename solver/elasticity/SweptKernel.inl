// Body of the kernels; included once per instruction set with LANES (doubles a vector) and WIDEST (vectors a group)
// set.
#include <chrono>

#include "elasticity/SweptKernelVectors.inl"
// After it.
#include "elasticity/SweptKernelInertia.inl"

namespace squat::elasticity {
namespace {

// A rigid motion of each interval, in the local components of its two stations: it strains nothing, and without it
// displacements are small enough to be rounded. What is left of a turn would be felt: rounding errors have a resultant,
// and where bodies roll that does work. Taken from two nodes at both stations; nothing beyond the interval enters, so
// that it does not depend on where stretches are cut.
//   u = T + W x (0, b, c), b and c from the middle node: T and W on the left and on the right.
template <typename Real>
struct RigidMotion {
  RigidMotion(const KernelCall&, const Group<Real>&) {}
};
template <>
struct RigidMotion<float> {
  alignas(64) double left[3][chunk], right[3][chunk], leftTurn[3][chunk], rightTurn[3][chunk];

  RigidMotion(const KernelCall& call, const Group<float>& group) {
    const KernelRun* run = call.runs;
    const double* middle = call.places + 2 * call.middle;
    const double acrossB = call.places[2 * call.far] - middle[0], acrossC = call.places[2 * call.far + 1] - middle[1];
    const double size2 = acrossB * acrossB + acrossC * acrossC;
    double hereM[3], hereF[3], m[3], f[3];
    at(call, group, call.middle, 0, hereM), at(call, group, call.far, 0, hereF);
    for (int i = 0; i < group.count; ++i) {
      while (run->last <= group.at + i) ++run;
      at(call, group, call.middle, i + 1, m), at(call, group, call.far, i + 1, f);
      const double nextM[3] = {m[0], m[1], m[2]}, nextF[3] = {f[0], f[1], f[2]};
      double cosine = 1, sine = 0, alongA = run->length, alongB = 0;  // from left to right, in the left one's basis
      if (call.cosines) {
        const double *cosines = call.cosines + group.at + i, *sines = call.sines + group.at + i;
        cosine = cosines[1] * cosines[0] + sines[1] * sines[0];
        sine = sines[1] * cosines[0] - cosines[1] * sines[0];
        alongA = middle[0] * sine, alongB = middle[0] * (cosine - 1);
        back(cosine, sine, m), back(cosine, sine, f);
      }
      // W x along is how the middle moves from left to right, W x across how the far node moves beside it.
      const double besideB = 0.5 * (hereF[1] + f[1] - hereM[1] - m[1]),
                   besideC = 0.5 * (hereF[2] + f[2] - hereM[2] - m[2]);
      const double turn[3] = {(besideC * acrossB - besideB * acrossC) / size2, (hereM[2] - m[2]) / alongA,
                              (m[1] - hereM[1]) / alongA};
      const double moved[3] = {-turn[2] * alongB, turn[2] * alongA, turn[0] * alongB - turn[1] * alongA};
      double first[3], second[3], turned[3];
      for (int k = 0; k < 3; ++k) {
        const double mean = 0.5 * (hereM[k] + m[k]);
        first[k] = mean - 0.5 * moved[k], second[k] = mean + 0.5 * moved[k], turned[k] = turn[k];
      }
      back(cosine, -sine, second), back(cosine, -sine, turned);
      for (int k = 0; k < 3; ++k) {
        left[k][i] = first[k], right[k][i] = second[k], leftTurn[k][i] = turn[k], rightTurn[k][i] = turned[k];
        hereM[k] = nextM[k], hereF[k] = nextF[k];
      }
    }
  }

  // Displacement of a node at station i of the group.
  static void at(const KernelCall& call, const Group<float>& group, int node, int i, double* u) {
    const auto n = static_cast<std::size_t>(node);
    const double* line =
        i < group.count ? call.source + group.state + n * 3 * chunk + i : group.next + n * group.nextNode;
    const std::size_t step = i < group.count ? chunk : group.nextLine;
    for (int c = 0; c < 3; ++c) u[c] = line[c * step];
  }
  // From the basis of the right station to that of the left; the other way round with the sine's sign turned.
  static void back(double cosine, double sine, double* v) {
    const double a = cosine * v[0] + sine * v[1];
    v[1] = cosine * v[1] - sine * v[0], v[0] = a;
  }
  // Component c at a node beside the middle, on LANES stations from `at` on.
  static Vector component(const double (&shift)[3][chunk], const double (&turn)[3][chunk], int c, double b, double cc,
                          int at) {
    if (c == 0) return load(shift[0] + at) + (load(turn[1] + at) * cc - load(turn[2] + at) * b);
    return c == 1 ? load(shift[1] + at) - load(turn[0] + at) * cc : load(shift[2] + at) + load(turn[0] + at) * b;
  }
};

// Sums and differences of both stations of one node, part by part: d_a, s_b, s_c, s_a, d_b, d_c.
template <typename Real>
inline void gather(const KernelCall& call, const Group<Real>& group, const RigidMotion<Real>& rigid, int node,
                   int slot) {
  Real* out = reinterpret_cast<Real*>(call.workspace) + slot * std::size_t{6 * chunk};
  const std::size_t lines = static_cast<std::size_t>(node) * 3 * chunk;
  const double *line = call.source + group.state + lines, *next = group.next + node * group.nextNode;
  const double besideB = call.places[2 * node] - call.places[2 * call.middle],
               besideC = call.places[2 * node + 1] - call.places[2 * call.middle + 1];
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c, line += chunk, next += group.nextLine) {
    // Backwards, so that every line is read once: the station after a vector is the first of the one before.
    Vector after = splat(*next);
    for (int p = group.parts - 1; p >= 0; --p) {
      const int from = group.part[p].offset, width = group.part[p].width;
      Real *sums = out + 6 * from + (c == 0 ? 3 : c) * width,
           *differences = out + 6 * from + (c == 0 ? 0 : c + 3) * width;
      for (int i = width - LANES; i >= 0; i -= LANES) {
        const int at = from + i;
        const Vector here = load(line + at);
        Vector left = here, right = advanced(here, after);
        if constexpr (sizeof(Real) < sizeof(double))
          left -= rigid.component(rigid.left, rigid.leftTurn, c, besideB, besideC, at),
              right -= rigid.component(rigid.right, rigid.rightTurn, c, besideB, besideC, at);
        storeAs(sums + i, right + left);
        storeAs(differences + i, right - left);
        after = here;
      }
    }
  }
}

// The processor's own prefetchers do not know the order of the nodes. Asks for one part of the lines of a node, each
// part while that part of the bundle before is computed.
inline void fetch(const double* lines, std::size_t line, int from, int width) {
  for (int c = 0; c < 3; ++c)
    for (int i = from; i < from + width; i += 8) __builtin_prefetch(lines + c * line + i, 1, 2);
}

// A value that stays in its register: without this the compiler loads it anew for each of its three products.
template <typename Packed>
inline Packed held(Packed value) {
#if LANES == 8
  asm("" : "+v"(value));
#else
  asm("" : "+x"(value));
#endif
  return value;
}

// Inner force of one row's node on the stations of one part, and the carry to the next.
template <typename Kind, int V, typename Real = typename Kind::Real>
inline void innerForce(const KernelCall& call, const Part<Real>& part, int row, Real (&force)[3][chunk]) {
  using Packed = typename Kind::Packed;
  constexpr int lanes = Kind::lanes;
  Packed s[3][V], t[3][V];
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < V; ++v) s[c][v] = Packed{}, t[c][v] = Packed{};
  const Real* workspace = reinterpret_cast<const Real*>(call.workspace) + 6 * part.offset;
  const Real* k = part.coefficients + 18 * static_cast<std::size_t>(call.rowStart[row]);
  const int *slot = call.slots + call.rowStart[row], *end = call.slots + call.rowStart[row + 1];
  for (; slot != end; ++slot, k += 18) {
    const Real* in = workspace + *slot * std::size_t{6 * chunk};
#pragma GCC unroll 3
    for (int column = 0; column < 3; ++column) {
      Packed x[V];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = held(Kind::load(in + (column * V + v) * lanes));
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) s[line][v] += k[3 * line + column] * x[v];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = held(Kind::load(in + ((column + 3) * V + v) * lanes));
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
      Kind::store(force[c] + part.offset + v * lanes, left + Kind::shifted(before, right));
      before = right;
    }
    *carry = before[lanes - 1];
  }
}

// The same with as many vectors as the part has.
template <typename Whole, typename Piece, int V = wide<Whole>, typename Real = typename Whole::Real>
inline void forceOfPart(const KernelCall& call, const Part<Real>& part, int row, Real (&force)[3][chunk]) {
  if constexpr (V * Whole::lanes > narrow<Piece> * Piece::lanes) {
    if (part.width == V * Whole::lanes)
      innerForce<Whole, V>(call, part, row, force);
    else
      forceOfPart<Whole, Piece, V / 2>(call, part, row, force);
  } else {
    innerForce<Piece, narrow<Piece>>(call, part, row, force);
  }
}

// Goes through the rows of a group: a node is gathered shortly before the first row that needs it. The forces of a
// bundle are collected, so that `rows(first, end, force)` meets whole lines: memory comes in long pieces then.
// `ahead(node, from, width)` asks for what `rows` will need of a node in the next bundle.
template <typename Whole, typename Piece, typename Ahead, typename Rows>
inline void overRows(const KernelCall& call, const Group<typename Whole::Real>& group, const Ahead& ahead,
                     const Rows& rows) {
  alignas(64) typename Whole::Real forces[mostRows][3][chunk];
  if (group.count < chunk) __builtin_memset(forces, 0, sizeof forces);
  const RigidMotion<typename Whole::Real> rigid(call, group);
  int gathered = 0, slot = 0;
  for (int bundle = 0; bundle < call.bundles; ++bundle) {
    const int first = call.bundleStart[bundle], end = call.bundleStart[bundle + 1];
    for (const int upTo = call.gatherUpTo[bundle]; gathered < upTo; ++gathered) {
      gather(call, group, rigid, call.order[gathered], slot);
      slot = slot + 1 == call.window ? 0 : slot + 1;
    }
    const auto fetchFor = [&](int i, int from, int width) {
      const int later = i + end - first, soon = gathered + (i - first);
      if (later < call.nodes) ahead(call.order[later], from, width);
      if (soon >= call.nodes) return;
      const auto node = static_cast<std::size_t>(call.order[soon]);
      fetch(call.source + group.state + node * 3 * chunk, chunk, from, width);
      if (from == 0)
        for (int c = 0; c < 3; ++c) __builtin_prefetch(group.next + node * group.nextNode + c * group.nextLine, 0, 2);
    };
    for (int p = 0; p < group.parts; ++p)
      for (int i = first; i < end; ++i) {
        fetchFor(i, group.part[p].offset, group.part[p].width);
        forceOfPart<Whole, Piece>(call, group.part[p], i, forces[i - first]);
      }
    rows(first, end, forces);
  }
}

template <typename Whole, typename Piece>
inline void applyGroup(const KernelCall& call, const Group<typename Whole::Real>& group) {
  double* out = call.force + group.state;
  overRows<Whole, Piece>(
      call, group, [](int, int, int) {},
      [&](int first, int end, const typename Whole::Real(&force)[mostRows][3][chunk]) {
        for (int row = first; row < end; ++row) {
          double* lines = out + static_cast<std::size_t>(call.order[row]) * 3 * chunk;
          for (int c = 0; c < 3; ++c)
            for (int i = 0; i < group.count; i += LANES)
              store(lines + c * chunk + i, widened(force[row - first][c] + i));
        }
      });
}

// Line triple of a node's outer forces at the group's first station, or null.
template <typename Real>
inline double* outerForce(const KernelCall& call, const Group<Real>& group, int node) {
  const int line = call.externalLine[node];
  return line < 0 ? nullptr : call.external + static_cast<std::size_t>(line) * 3 * call.stride + group.at;
}

// Inner force of a node becomes its acceleration, outer forces included; a slave's is left to its masters.
template <typename Real>
inline void accelerate(const KernelCall& call, const Group<Real>& group, int n, Real (&force)[3][chunk]) {
  const int count = group.count;
  const std::size_t stride = call.stride;
  if (call.turningMoment) {
    const double* source = call.source + group.state + static_cast<std::size_t>(n) * 3 * chunk;
    for (int i = 0; i < count; i += LANES) {
      double* moment = call.turningMoment + group.at + i;
      store(moment, load(moment) +
                        (load(source + i) * widened(force[1] + i) - load(source + chunk + i) * widened(force[0] + i)));
    }
  }
  double* outer = outerForce(call, group, n);
  if (call.slave[n]) {
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < count; i += LANES) store(outer + c * stride + i, widened(force[c] + i));
    return;
  }
  const double* inverse = call.inverseMass + placeOfMass(call, n, group.at);
  for (int c = 0; c < 3; ++c) {
    double* added = outer ? outer + c * stride : nullptr;
    for (int i = 0; i < count; i += LANES) {
      Vector total = -widened(force[c] + i);
      if (added) {
        total += load(added + i);
        store(added + i, Vector{});
      }
      storeAs(force[c] + i, total * load(inverse + i));
    }
  }
}

// One node through the central difference on all stations of the group.
template <typename Real>
inline void advanceNode(const KernelCall& call, const Group<Real>& group, int n, const Real (&own)[3][chunk]) {
  if (call.slave[n]) return;
  const int count = group.count;
  const std::size_t base = group.state + static_cast<std::size_t>(n) * 3 * chunk;
  const double* source = call.source + base;
  const double step = call.step, beta = call.beta, both = step + beta, cosine = call.cosine, sine = call.sine;
  const double spin = call.radialWeight ? call.spinAcceleration * call.radialWeight[n] : 0.0;
  const double pushed[3] = {spin, 0, 0};
  double *rates = call.velocity + base, *target = call.target + base;
  for (int c = 0; c < 3; ++c) {
    const double mask = call.fixedMask[3 * n + c], push = pushed[c];
    const double* body = call.acceleration + c * call.stride + group.at;
    for (int i = 0; i < count; i += LANES) {
      const Vector acceleration = widened(own[c] + i) + (load(body + i) + push);
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

template <typename Whole, typename Piece>
inline void advanceGroup(const KernelCall& call, const Group<typename Whole::Real>& group) {
  int cluster = 0;
  overRows<Whole, Piece>(
      call, group,
      [&](int node, int from, int width) {
        const std::size_t base = group.state + static_cast<std::size_t>(node) * 3 * chunk;
        fetch(call.velocity + base, chunk, from, width);
        if (call.target != call.source) fetch(call.target + base, chunk, from, width);
        for (int i = from; i < from + width; i += 8)
          __builtin_prefetch(call.inverseMass + placeOfMass(call, node, group.at) + i, 0, 2);
        if (const int line = call.externalLine[node]; line >= 0)
          fetch(call.external + static_cast<std::size_t>(line) * 3 * call.stride + group.at, call.stride, from, width);
      },
      [&](int first, int end, typename Whole::Real(&force)[mostRows][3][chunk]) {
        for (int row = first; row < end; ++row) accelerate(call, group, call.order[row], force[row - first]);
        if (call.clusterCount > 0) slowShortWaves<Piece>(call, group, first, end, cluster, force);
        for (int row = first; row < end; ++row) advanceNode(call, group, call.order[row], force[row - first]);
      });
}

// Cuts the stations of a group into parts, each within one run.
template <typename Whole, typename Piece>
inline void findParts(const KernelCall& call, Group<typename Whole::Real>& group) {
  constexpr int most = wide<Whole> * Whole::lanes, least = narrow<Piece> * Piece::lanes;
  const KernelRun* run = call.runs;
  for (int from = 0; from < group.count;) {
    while (run->last <= group.at + from) ++run;
    const int rest =
        run->last - group.at - from < group.count - from ? run->last - group.at - from : group.count - from;
    int width = most;
    while (width > rest || (width > least && from % Whole::lanes != 0)) width /= 2;
    static_assert(most % least == 0);
    group.part[group.parts++] = {from, width, coefficientsOf(*run, typename Whole::Real{})};
    from += width;
  }
}

// Stations of a group that share their inertia along the sweep.
template <typename Real>
inline void findAlong(const KernelCall& call, Group<Real>& group) {
  const KernelRun* run = call.runs;
  for (int at = 0; at < group.count;) {
    const int station = group.at + at;
    while (run->last <= station) ++run;
    const bool isWide = station % mostStations == 0 && station + mostStations <= run->last;
    const Real* along = alongOf(*run, Real{});
    if (along) group.along[at / stationUnit] = along + projectionPlace[isWide][station != run->first];
    group.alongStations[at / stationUnit] = isWide ? mostStations : stationUnit;
    at += isWide ? mostStations : stationUnit;
  }
}

template <typename Whole, typename Piece>
void carryOver(const KernelCall& call) {
  const FlushTiny flush;
  Group<typename Whole::Real> group;
  group.at = call.first - 8, group.count = 8;
  group.state = placeOf(call, group.at), group.next = call.source + placeOf(call, call.first);
  findParts<Whole, Piece>(call, group);
  overRows<Whole, Piece>(
      call, group, [](int, int, int) {}, [](int, int, const typename Whole::Real(&)[mostRows][3][chunk]) {});
}

// The stretch chunk by chunk.
template <typename Whole, typename Piece, typename Body>
inline void overGroups(const KernelCall& call, const Body& body) {
  const FlushTiny flush;
  const int end = call.first + call.count;
  for (int at = call.first; at < end;) {
    const int stop = (at / chunk + 1) * chunk < end ? (at / chunk + 1) * chunk : end;
    Group<typename Whole::Real> group;
    group.at = at, group.count = stop - at;
    group.state = placeOf(call, at), group.next = call.source + placeOf(call, stop);
    if (stop == end && call.after) group.next = call.after, group.nextNode = 3, group.nextLine = 1;
    findParts<Whole, Piece>(call, group);
    if (call.clusterCount > 0) findAlong(call, group);
    body(group);
    at = stop;
  }
}

template <typename Whole, typename Piece>
void applyStiffness(const KernelCall& call) {
  overGroups<Whole, Piece>(call, [&](const auto& group) { applyGroup<Whole, Piece>(call, group); });
}

template <typename Whole, typename Piece>
void advanceStep(const KernelCall& call) {
  overGroups<Whole, Piece>(call, [&](const auto& group) { advanceGroup<Whole, Piece>(call, group); });
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
            carryOver<Single, SinglePiece>,
            advanceStep<Single, SinglePiece>,
            multiplyAddPeak};
  return {
      name,           precision, applyStiffness<Double, Double>, carryOver<Double, Double>, advanceStep<Double, Double>,
      multiplyAddPeak};
}

}  // namespace
}  // namespace squat::elasticity
