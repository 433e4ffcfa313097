// The elastic operator over the rows of a section, for the stations of one chunk; after SweptKernelVectors.inl.

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
  // Of both stations together and of their difference, which does not depend on the place along a straight line.
  alignas(64) double shiftSum[3][chunk], shiftDifference[3][chunk], turnSum[3][chunk], turnDifference[3][chunk];

  RigidMotion(const KernelCall& call, const Group<float>& group) {
    alignas(64) double lengths[chunk];
    const KernelRun* run = call.runs;
    for (int i = 0; i < group.count; ++i) {
      while (run->last <= group.at + i) ++run;
      lengths[i] = run->length;
    }
    const double* middle = call.coordinates + 2 * call.middle;
    const double acrossB = call.coordinates[2 * call.far] - middle[0],
                 acrossC = call.coordinates[2 * call.far + 1] - middle[1];
    const double size2 = acrossB * acrossB + acrossC * acrossC;
    for (int i = 0; i < group.count; i += LANES) {
      Vector hereM[3], hereF[3], m[3], f[3];
      bothEnds(call, group, call.middle, i, hereM, m), bothEnds(call, group, call.far, i, hereF, f);
      Vector cosine = splat(1), sine{}, alongA = load(lengths + i), alongB{};  // from left to right, in the left basis
      if (call.cosines) {
        const double *cosines = call.cosines + group.at + i, *sines = call.sines + group.at + i;
        const Vector c = Double::loadLoose(cosines), s = Double::loadLoose(sines);
        const Vector nextC = Double::loadLoose(cosines + 1), nextS = Double::loadLoose(sines + 1);
        cosine = nextC * c + nextS * s;
        sine = nextS * c - nextC * s;
        alongA = middle[0] * sine, alongB = middle[0] * (cosine - 1);
        back(cosine, sine, m), back(cosine, sine, f);
      }
      // W x along is how the middle moves from left to right, W x across how the far node moves beside it.
      const Vector besideB = 0.5 * (hereF[1] + f[1] - hereM[1] - m[1]),
                   besideC = 0.5 * (hereF[2] + f[2] - hereM[2] - m[2]);
      const Vector turn[3] = {(besideC * acrossB - besideB * acrossC) / size2, (hereM[2] - m[2]) / alongA,
                              (m[1] - hereM[1]) / alongA};
      const Vector moved[3] = {-turn[2] * alongB, turn[2] * alongA, turn[0] * alongB - turn[1] * alongA};
      Vector first[3], second[3], turned[3];
      for (int k = 0; k < 3; ++k) {
        const Vector mean = 0.5 * (hereM[k] + m[k]);
        first[k] = mean - 0.5 * moved[k], second[k] = mean + 0.5 * moved[k], turned[k] = turn[k];
      }
      if (call.cosines) back(cosine, -sine, second), back(cosine, -sine, turned);
      for (int k = 0; k < 3; ++k) {
        store(shiftSum[k] + i, second[k] + first[k]), store(shiftDifference[k] + i, second[k] - first[k]);
        store(turnSum[k] + i, turned[k] + turn[k]), store(turnDifference[k] + i, turned[k] - turn[k]);
      }
    }
  }

  // Displacements of a node at LANES stations from station i of the group on, and at the stations after them.
  static void bothEnds(const KernelCall& call, const Group<float>& group, int node, int i, Vector* here,
                       Vector* after) {
    const auto n = static_cast<std::size_t>(node);
    for (int c = 0; c < 3; ++c) {
      const double* line = call.source + group.state + (3 * n + c) * chunk + i;
      here[c] = load(line);
      const Vector next =
          i + LANES < group.count ? load(line + LANES) : splat(group.next[n * group.nextNode + c * group.nextLine]);
      after[c] = advanced(here[c], next);
    }
  }
  // From the basis of the right station to that of the left; the other way round with the sine's sign turned.
  static void back(Vector cosine, Vector sine, Vector* v) {
    const Vector a = cosine * v[0] + sine * v[1];
    v[1] = cosine * v[1] - sine * v[0], v[0] = a;
  }
  // Component c at a node beside the middle, on LANES stations from `at` on.
  static Vector component(const double (&shift)[3][chunk], const double (&turn)[3][chunk], int c, double b, double cc,
                          int at) {
    if (c == 0) return load(shift[0] + at) + (load(turn[1] + at) * cc - load(turn[2] + at) * b);
    return c == 1 ? load(shift[1] + at) - load(turn[0] + at) * cc : load(shift[2] + at) + load(turn[0] + at) * b;
  }
};

// Sums and differences of both stations of one node in one part of N vectors: d_a, s_b, s_c, s_a, d_b, d_c. Every value
// is read once: the station after a vector is the first of the next.
template <int N, bool STRAIGHT, typename Real>
inline void gatherPart(const double* lines, const double* next, std::size_t nextLine, const RigidMotion<Real>& rigid,
                       double besideB, double besideC, int from, Real* out) {
  constexpr int width = N * LANES;
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c, lines += chunk, next += nextLine) {
    Real *sums = out + (c == 0 ? 3 : c) * width, *differences = out + (c == 0 ? 0 : c + 3) * width;
    Vector here = load(lines);
#pragma GCC unroll 16
    for (int i = 0; i < width; i += LANES) {
      const Vector after = i + LANES < width ? load(lines + i + LANES) : splat(*next);
      const Vector right = advanced(here, after);
      Vector sum = right + here, difference = right - here;
      if constexpr (sizeof(Real) < sizeof(double)) {
        sum -= rigid.component(rigid.shiftSum, rigid.turnSum, c, besideB, besideC, from + i);
        difference -= STRAIGHT
                          ? load(rigid.shiftDifference[c] + from + i)
                          : rigid.component(rigid.shiftDifference, rigid.turnDifference, c, besideB, besideC, from + i);
      }
      storeAs(sums + i, sum);
      storeAs(differences + i, difference);
      here = after;
    }
  }
}

// The same with as many vectors as the part has.
template <int N, bool STRAIGHT, typename Real>
inline void gatherOfWidth(int width, const double* lines, const double* next, std::size_t nextLine,
                          const RigidMotion<Real>& rigid, double besideB, double besideC, int from, Real* out) {
  if constexpr (N > 1)
    if (width < N * LANES)
      return gatherOfWidth<N / 2, STRAIGHT>(width, lines, next, nextLine, rigid, besideB, besideC, from, out);
  gatherPart<N, STRAIGHT>(lines, next, nextLine, rigid, besideB, besideC, from, out);
}

// Of all parts, into one place of the window.
template <bool STRAIGHT, typename Real>
inline void gatherParts(const KernelCall& call, const Group<Real>& group, const RigidMotion<Real>& rigid, int node,
                        int slot) {
  Real* out = reinterpret_cast<Real*>(call.workspace) + slot * std::size_t{6 * chunk};
  const double *lines = call.source + group.state + static_cast<std::size_t>(node) * 3 * chunk,
               *beyond = group.next + node * group.nextNode;
  const double besideB = call.coordinates[2 * node] - call.coordinates[2 * call.middle],
               besideC = call.coordinates[2 * node + 1] - call.coordinates[2 * call.middle + 1];
  for (int p = 0; p < group.parts; ++p) {
    const int from = group.part[p].offset, width = group.part[p].width;
    const bool isLast = p + 1 == group.parts;
    gatherOfWidth<chunk / LANES, STRAIGHT>(width, lines + from, isLast ? beyond : lines + from + width,
                                           isLast ? group.nextLine : chunk, rigid, besideB, besideC, from,
                                           out + 6 * from);
  }
}
template <typename Real>
inline void gather(const KernelCall& call, const Group<Real>& group, const RigidMotion<Real>& rigid, int node,
                   int slot) {
  if (sizeof(Real) == sizeof(double) || !call.cosines)  // doubles are as they are along any line
    gatherParts<true>(call, group, rigid, node, slot);
  else
    gatherParts<false>(call, group, rigid, node, slot);
}

// Memory is asked for so many nodes ahead, about a microsecond: the processor's own prefetchers come too late where
// rows change from one array to the next.
constexpr int sourceAhead = 3, stepAhead = 2;

// Three lines of a node.
inline void askLines(const double* lines, std::size_t line, int stations) {
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < stations; i += 8) ask(lines + c * line + i);
}
template <typename Real>
inline void askSource(const KernelCall& call, const Group<Real>& group, int node) {
  const auto n = static_cast<std::size_t>(node);
  askLines(call.source + group.state + n * 3 * chunk, chunk, group.count);
  for (int c = 0; c < 3; ++c) ask(group.next + n * group.nextNode + c * group.nextLine);
}

// Coefficients of a part's vectors: the same for all, or their own.
template <typename Kind, int V, bool MIXED>
struct Coefficients {
  using Real = typename Kind::Real;
  const Real* of[MIXED ? V : 1];
  Coefficients(const Part<Real>& part, std::size_t from) {
    for (int v = 0; v < (MIXED ? V : 1); ++v) of[v] = part.coefficients[v * Kind::lanes / 8] + from;
  }
  Real at(int v, std::size_t i) const { return of[MIXED ? v : 0][i]; }
};

// Forces as they are.
struct Unscaled {};
template <typename Packed>
inline Packed scaled(Packed force, Unscaled) {
  return force;
}
template <typename Packed, typename Real>
inline Packed scaled(Packed force, Real factor) {
  return force * factor;
}

// Inner force of one row's node on the stations of one part, times a factor, and the carry to the next.
template <typename Kind, int V, bool MIXED = false, typename Factor, typename Real = typename Kind::Real>
inline void innerForce(const KernelCall& call, const Part<Real>& part, int row, Real* force, Factor factor) {
  using Packed = typename Kind::Packed;
  constexpr int lanes = Kind::lanes;
  Packed s[3][V], t[3][V];
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < V; ++v) s[c][v] = Packed{}, t[c][v] = Packed{};
  const Real* workspace = reinterpret_cast<const Real*>(call.workspace) + 6 * part.offset;
  const Coefficients<Kind, V, MIXED> k(part, 18 * static_cast<std::size_t>(call.rowStart[row]));
  const int *slots = call.slots + call.rowStart[row], pairs = call.rowStart[row + 1] - call.rowStart[row];
  for (std::size_t pair = 0, at = 0; pair < static_cast<std::size_t>(pairs); ++pair, at += 18) {
    const Real* in = workspace + slots[pair] * std::size_t{6 * chunk};
#pragma GCC unroll 3
    for (int column = 0; column < 3; ++column) {
      Packed x[V];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = fixed(Kind::load(in + (column * V + v) * lanes));
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) s[line][v] += k.at(v, at + 3 * line + column) * x[v];
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v) x[v] = fixed(Kind::load(in + ((column + 3) * V + v) * lanes));
#pragma GCC unroll 3
      for (int line = 0; line < 3; ++line)
#pragma GCC unroll 4
        for (int v = 0; v < V; ++v) t[line][v] += k.at(v, at + 9 + 3 * line + column) * x[v];
    }
  }
  for (int c = 0; c < 3; ++c) {
    double* carry = call.carry + 3 * call.order[row] + c;
    Packed before = Kind::splat(*carry);
    for (int v = 0; v < V; ++v) {
      const Packed right = s[c][v] + t[c][v];
      const Packed left = c == 0 ? t[c][v] - s[c][v] : s[c][v] - t[c][v];
      Kind::store(force + c * chunk + part.offset + v * lanes, scaled(left + Kind::shifted(before, right), factor));
      before = right;
    }
    *carry = before[lanes - 1];
  }
}

// The same with as many vectors as the part has.
template <typename Whole, typename Piece, int V = wide<Whole>, typename Factor, typename Real = typename Whole::Real>
inline void forceOfPart(const KernelCall& call, const Part<Real>& part, int row, Real* force, Factor factor) {
  if constexpr (V * Whole::lanes > narrow<Piece> * Piece::lanes) {
    if (part.width < V * Whole::lanes) return forceOfPart<Whole, Piece, V / 2>(call, part, row, force, factor);
    constexpr int pieces = wide<Whole> * Whole::lanes / Piece::lanes;
    if constexpr (V == wide<Whole>)
      if (part.isMixed) return innerForce<Piece, pieces, true>(call, part, row, force, factor);
    innerForce<Whole, V>(call, part, row, force, factor);
  } else {
    innerForce<Piece, narrow<Piece>>(call, part, row, force, factor);
  }
}

// Goes through the rows of a group: a node is gathered shortly before the first row that needs it. The forces of a row
// go to forceOf(row), three lines of a chunk, times factorOf(row); whole(row) follows when they stand there on all
// stations: what it asks of memory hides behind the multiply-adds of the next.
template <typename Whole, typename Piece, typename ForceOf, typename FactorOf, typename Then>
inline void overRows(const KernelCall& call, const Group<typename Whole::Real>& group, const ForceOf& forceOf,
                     const FactorOf& factorOf, const Then& whole) {
  const RigidMotion<typename Whole::Real> rigid(call, group);
  int gathered = 0, slot = 0;
  for (int bundle = 0; bundle < call.bundles; ++bundle) {
    const int first = call.bundleStart[bundle], end = call.bundleStart[bundle + 1];
    for (int p = 0; p < group.parts; ++p)
      for (int row = first; row < end; ++row) {
        for (const int upTo = call.gatherUpTo[row]; gathered < upTo; ++gathered) {
          gather(call, group, rigid, call.order[gathered], slot);
          slot = slot + 1 == call.window ? 0 : slot + 1;
        }
        if (p == 0 && gathered + sourceAhead < call.nodes) askSource(call, group, call.order[gathered + sourceAhead]);
        forceOfPart<Whole, Piece>(call, group.part[p], row, forceOf(row), factorOf(row));
        if (p + 1 == group.parts) whole(row);
      }
  }
}

template <typename Whole, typename Piece>
inline void applyGroup(const KernelCall& call, const Group<typename Whole::Real>& group) {
  using Real = typename Whole::Real;
  double* out = call.force + group.state;
  const auto asTheyAre = [](int) { return Unscaled{}; };
  const auto linesOf = [&](int row) { return out + static_cast<std::size_t>(call.order[row]) * 3 * chunk; };
  if constexpr (sizeof(Real) == sizeof(double)) {
    overRows<Whole, Piece>(call, group, linesOf, asTheyAre, [](int) {});
  } else {
    alignas(64) Real forces[rowBundle][3][chunk];
    overRows<Whole, Piece>(
        call, group, [&](int row) { return forces[row % rowBundle][0]; }, asTheyAre,
        [&](int row) {
          for (int c = 0; c < 3; ++c)
            for (int i = 0; i < group.count; i += LANES)
              store(linesOf(row) + c * chunk + i, widened(forces[row % rowBundle][c] + i));
        });
  }
}

}  // namespace
}  // namespace squat::elasticity
