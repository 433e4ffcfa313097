// Body of the kernels; included once per instruction set with LANES (doubles a vector) and WIDEST (vectors a group)
// set, behind what its processors have of their own (SweptKernelX86.inl, SweptKernelArm64.inl): FlushTiny, ask(),
// fixed().
#include <chrono>

// Each needs those before it.
// clang-format off
#include "elasticity/SweptKernelVectors.inl"
#include "elasticity/SweptKernelOperator.inl"
#include "elasticity/SweptKernelInertia.inl"
#include "elasticity/SweptKernelStep.inl"
// clang-format on

namespace squat::elasticity {
namespace {

// Whether `count` stations from `first` on, which `run` holds, change their run in the middle alone.
inline bool halvesAreEven(const KernelRun* run, int first, int count) {
  if (run->last < first + count / 2) return false;
  while (run->last <= first + count / 2) ++run;
  return run->last >= first + count;
}

// Cuts the stations of a group into parts: the widest there are, mixed where runs end within them but for their middle;
// at the end of a stretch narrower ones, each within one run.
template <typename Whole, typename Piece>
inline void findParts(const KernelCall& call, Group<typename Whole::Real>& group) {
  constexpr int maximum = wide<Whole> * Whole::lanes, minimum = narrow<Piece> * Piece::lanes;
  static_assert(maximum % minimum == 0 && chunk % maximum == 0);
  const KernelRun* run = call.runs;
  for (int from = 0; from < group.count;) {
    auto& part = group.part[group.parts++];
    int width = maximum;
    while (run->last <= group.at + from) ++run;
    const int inRun = run->last - group.at - from;
    while (width > group.count - from || (width > minimum && from % Whole::lanes != 0)) width /= 2;
    part.isMixed = width == maximum && inRun < maximum && !halvesAreEven(run, group.at + from, maximum);
    while (!part.isMixed && width > inRun) width /= 2;
    part.offset = from, part.width = width;
    const KernelRun* here = run;
    for (int i = 0; i < width; i += 8) {
      while (here->last <= group.at + from + i) ++here;
      part.coefficients[i / 8] = coefficientsOf(*here, typename Whole::Real{});
    }
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
    const bool isWide = station % maximumStations == 0 && station + maximumStations <= run->last;
    const Real* along = alongOf(*run, Real{});
    if (along) group.along[at / stationUnit] = along + projectionLocation[isWide][station != run->first];
    group.alongStations[at / stationUnit] = isWide ? maximumStations : stationUnit;
    at += isWide ? maximumStations : stationUnit;
  }
}

template <typename Whole, typename Piece>
void carryOver(const KernelCall& call) {
  const FlushTiny flush;
  Group<typename Whole::Real> group;
  group.at = call.first - 8, group.count = 8;
  group.state = stateIndex(call, group.at), group.next = call.source + stateIndex(call, call.first);
  findParts<Whole, Piece>(call, group);
  overRows<Whole, Piece>(
      call, group, [&](int) { return (*waiting<typename Whole::Real>(call, 0))[0]; }, [](int) { return Unscaled{}; },
      [](int) {});
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
    group.state = stateIndex(call, at), group.next = call.source + stateIndex(call, stop);
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
  overGroups<Whole, Piece>(call, [&](auto& group) {
    for (int i = 0; i < group.count; ++i) group.stepOver[i] = call.step / call.stationMass[group.at + i];
    advanceGroup<Whole, Piece>(call, group);
  });
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
