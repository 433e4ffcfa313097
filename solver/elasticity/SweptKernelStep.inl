// One step of the central difference, between the rows of the operator; after SweptKernelOperator.inl and
// SweptKernelInertia.inl.

namespace squat::elasticity {
namespace {

// Line triple of a node's outer forces at the group's first station, or null.
template <typename Real>
inline double* outerForce(const KernelCall& call, const Group<Real>& group, int node) {
  const int line = call.externalLine[node];
  return line < 0 ? nullptr : call.external + static_cast<std::size_t>(line) * 3 * call.stride + group.at;
}

inline double evenInverse(const KernelCall& call, int node) { return call.evenInverse ? call.evenInverse[node] : 0.0; }
// Nodes whose forces are scaled when they are found: where nothing else is to be done with them.
inline bool isScaled(const KernelCall& call, int node) { return !call.turningMoment && evenInverse(call, node) != 0; }

// Inner force of a node becomes its acceleration times station mass, outer forces included; a slave's is left to its
// masters. STATIONS: of the group where they are a whole chunk (loops without an end to look for), else 0.
template <int STATIONS, typename Real>
inline void accelerateStations(const KernelCall& call, const Group<Real>& group, int n, Real (&force)[3][chunk]) {
  const int count = STATIONS ? STATIONS : group.count;
  const std::size_t stride = call.stride;
  if (call.turningMoment) {
    const double* source = call.source + group.state + static_cast<std::size_t>(n) * 3 * chunk;
#pragma GCC unroll 4
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
  if (const double even = evenInverse(call, n); even != 0) {
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 4
      for (int i = 0; i < count; i += LANES) storeAs(force[c] + i, -even * widened(force[c] + i));
    return;
  }
  const double *inverse = call.inverseMass + massIndex(call, n, group.at), *mass = call.stationMass + group.at;
  for (int c = 0; c < 3; ++c) {
    double* added = outer ? outer + c * stride : nullptr;
#pragma GCC unroll 4
    for (int i = 0; i < count; i += LANES) {
      Vector total = -widened(force[c] + i);
      if (added) {
        total += load(added + i);
        store(added + i, Vector{});
      }
      storeAs(force[c] + i, total * load(inverse + i) * load(mass + i));
    }
  }
}

template <typename Real>
inline void accelerate(const KernelCall& call, const Group<Real>& group, int n, Real (&force)[3][chunk]) {
  if (group.count == chunk)
    accelerateStations<chunk>(call, group, n, force);
  else
    accelerateStations<0>(call, group, n, force);
}

// One node through the central difference on all stations of the group. EVEN: with the same body acceleration.
template <int STATIONS, bool EVEN, typename Real>
inline void advanceStations(const KernelCall& call, const Group<Real>& group, int n, const Real (&own)[3][chunk]) {
  if (call.slave[n]) return;
  const int count = STATIONS ? STATIONS : group.count;
  const std::size_t base = group.state + static_cast<std::size_t>(n) * 3 * chunk;
  const double* source = call.source + base;
  const double step = call.step, beta = call.beta, both = step + beta, cosine = call.cosine, sine = call.sine;
  const double tangential = call.radialWeight ? call.angularAcceleration * call.radialWeight[n] : 0.0;
  const double pushed[3] = {tangential, 0, 0};
  double *rates = call.velocity + base, *target = call.target + base;
  for (int c = 0; c < 3; ++c) {
    const double mask = EVEN ? 1 : call.fixedMask[3 * n + c], push = EVEN ? call.evenAcceleration[c] : pushed[c];
    const double* body = EVEN ? nullptr : call.acceleration + c * call.stride + group.at;
    const Vector evenly = splat(step * push);
#pragma GCC unroll 4
    for (int i = 0; i < count; i += LANES) {
      const Vector gained =
          widened(own[c] + i) * load(group.stepOver + i) + (EVEN ? evenly : Vector(step * (load(body + i) + push)));
      // Read before anything is written: lines of both vectors end in the same bits of their address, and a read that
      // seems to follow a write to its own place waits for it.
      const Vector old = load(rates + c * chunk + i), here = load(source + c * chunk + i);
      const Vector velocity = EVEN ? Vector(old + gained) : Vector((old + gained) * mask);
      store(rates + c * chunk + i, velocity);
      store(target + c * chunk + i, here - beta * old + both * velocity);
    }
  }
  if (sine == 0) return;
  for (double* lines : {rates, target})
#pragma GCC unroll 4
    for (int i = 0; i < count; i += LANES) {
      const Vector a = load(lines + i), b = load(lines + chunk + i);
      store(lines + i, cosine * a + sine * b);
      store(lines + chunk + i, cosine * b - sine * a);
    }
}

template <typename Real>
inline void advanceNode(const KernelCall& call, const Group<Real>& group, int n, const Real (&own)[3][chunk]) {
  const bool isEven = !call.acceleration;
  if (group.count == chunk)
    isEven ? advanceStations<chunk, true>(call, group, n, own) : advanceStations<chunk, false>(call, group, n, own);
  else
    isEven ? advanceStations<0, true>(call, group, n, own) : advanceStations<0, false>(call, group, n, own);
}

// Asks for what a node will need: to be advanced, and before that, for its force to become its acceleration.
template <typename Real>
inline void prefetchStep(const KernelCall& call, const Group<Real>& group, int node) {
  const std::size_t base = group.state + static_cast<std::size_t>(node) * 3 * chunk;
  askLines(call.velocity + base, chunk, group.count);
  if (call.target != call.source) askLines(call.target + base, chunk, group.count);
}
template <typename Real>
inline void askForce(const KernelCall& call, const Group<Real>& group, int node) {
  if (evenInverse(call, node) != 0) return;
  for (int i = 0; i < group.count; i += 8) ask(call.inverseMass + massIndex(call, node, group.at) + i);
  if (const int line = call.externalLine[node]; line >= 0)
    askLines(call.external + static_cast<std::size_t>(line) * 3 * call.stride + group.at, call.stride, group.count);
}

// Nodes are advanced between the rows, some after each, when they and those that they share their inertia with are
// ready.
template <typename Whole, typename Piece>
inline void advanceGroup(const KernelCall& call, const Group<typename Whole::Real>& group) {
  using Real = typename Whole::Real;
  int cluster = 0, advanced = 0;
  const auto advanceUpTo = [&](int end) {
    for (; advanced < end; ++advanced) {
      if (advanced + stepAhead < call.nodes) prefetchStep(call, group, call.members[advanced + stepAhead]);
      advanceNode(call, group, call.members[advanced], *waiting<Real>(call, call.memberSlot[advanced]));
    }
  };
  overRows<Whole, Piece>(
      call, group, [&](int row) { return (*waiting<Real>(call, call.rowSlot[row]))[0]; },
      [&](int row) {
        return isScaled(call, call.order[row]) ? static_cast<Real>(-evenInverse(call, call.order[row])) : Real{1};
      },
      [&](int row) {
        if (row + stepAhead < call.nodes) askForce(call, group, call.order[row + stepAhead]);
        if (!isScaled(call, call.order[row]))
          accelerate(call, group, call.order[row], *waiting<Real>(call, call.rowSlot[row]));
        const int ready = call.readyAfter[row];
        slowShortWaves<Whole, Piece>(call, group, ready, cluster);
        advanceUpTo(advanced + advancedPerRow < ready ? advanced + advancedPerRow : ready);
      });
  advanceUpTo(call.nodes);
}

}  // namespace
}  // namespace squat::elasticity
