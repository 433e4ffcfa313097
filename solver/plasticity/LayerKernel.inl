// Body of the kernels; included once per instruction set with LANES (doubles a vector) set.
//
// Return (J. C. Simo, T. J. R. Hughes, Computational Inelasticity, 1998, box 3.2), strains in place of stresses (over
// 2 mu): eta = dev eps - (1 + kinematicShare) eps_p, yield where |eta| > r(p), then
//   dgamma = (|eta| - r) / (1 + share),  eps_p += dgamma eta / |eta|,  p += sqrt(2/3) dgamma.
// The incompatible modes give way to the plastic strain: their amplitudes a solve a = sum_q amplitude_q eps_p,q(a).
// That is the gradient of a convex energy whose curvature, measured by the elastic one, lies between share / (1 +
// share) and 1: Chebyshev's iteration between these bounds (G. H. Golub, C. F. Van Loan, 10.1.5) converges in few steps
// from the amplitudes of the step before.
//
// Back-stresses that recover (S. Kobayashi, N. Ohno, Int. J. Numerical Methods in Eng. 53, 2002, for the implicit
// step), with dgamma the norm of the step of eps_p along n and dp = sqrt(2/3) dgamma:
//   X_i = (X_i,before + c_i dgamma n) / (1 + recovery_i dp),  growth = (before + rate saturation dp) / (1 + rate dp),
//   dev eps - eps_p,before - sum X_i,before / (1 + recovery_i dp) = (r + growth + dgamma (1 + sum c_i / (1 + ...))) n:
// one equation for dgamma, by Newton's method. Where an exponent makes recovery depend on X, X before the step and the
// direction of its trial do: a step of a run flows by some 1e-6.
#include <cmath>
#include <type_traits>

#include "plasticity/LayerKernel.h"

namespace squat::plasticity {
namespace {

using Vector = double __attribute__((vector_size(LANES * sizeof(double)), may_alias));
using Loose = double __attribute__((vector_size(LANES * sizeof(double)), aligned(8), may_alias));

constexpr int groupLanes = 8;
constexpr double tolerance = 1e-5;     // of the yield radius, what is left of the amplitudes' change in strain
constexpr int maximumIterations = 40;  // reached only without hardening
constexpr double minimumShare = 0.02;  // bound of the curvature without hardening

inline Vector loadLoose(const double* p) { return *reinterpret_cast<const Loose*>(p); }
inline Vector load(const double* p) { return *reinterpret_cast<const Vector*>(p); }
inline void store(double* p, Vector v) { *reinterpret_cast<Vector*>(p) = v; }
inline Vector splat(double value) { return value - Vector{}; }
inline Vector root(Vector v) {
  for (int i = 0; i < LANES; ++i) v[i] = std::sqrt(v[i]);
  return v;
}
inline Vector positive(Vector v) { return v > 0 ? v : Vector{}; }
inline bool anyPositive(Vector v) {
  for (int i = 0; i < LANES; ++i)
    if (v[i] > 0) return true;
  return false;
}
inline double largest(Vector v) {
  double maximum = 0;
  for (int i = 0; i < LANES; ++i) maximum = std::max(maximum, v[i]);
  return maximum;
}

// Coefficient i of the lanes at `at`: shared by all, or of each lane its own.
template <bool Own>
inline Vector coefficientAt(const LayerCall& call, int i, int at) {
  if constexpr (Own)
    return load(call.coefficients + static_cast<std::size_t>(i) * groupLanes + at);
  else
    return splat(call.coefficients[i]);
}

inline Vector squaredNorm(const Vector (&e)[5]) {
  const Vector zz = e[0] + e[1];
  return e[0] * e[0] + e[1] * e[1] + zz * zz + 0.5 * (e[2] * e[2] + e[3] * e[3] + e[4] * e[4]);
}

// Weights of a traceless strain in the work of 2 mu eps with a deviatoric strain in the same rows.
inline void workRows(const Vector (&e)[5], Vector (&m)[5]) {
  m[0] = 2 * e[0] + e[1], m[1] = e[0] + 2 * e[1];
  for (int r = 2; r < 5; ++r) m[r] = 0.5 * e[r];
}

struct Point {
  Vector strain[5];  // of the corners' displacements
  Vector base[5];    // plastic strain before the step
  Vector flow[5];    // and now
  Vector before, equivalent;
};

// What a point of steel whose back-stresses recover has besides, before the step and now.
struct Recovering {
  Vector stressBefore[backstressCount][5], stress[backstressCount][5];
  Vector recovery[backstressCount];   // of the step, per sqrt(3/2) of its size
  Vector growthBefore, growth, work;  // work: of the step
};
struct None {};
template <bool Recovers>
using Backstresses = std::conditional_t<Recovers, Recovering, None>;

template <bool Recovers>
constexpr int stateRows = Recovers ? 23 : 6;

template <bool Own>
inline void addAmplitudes(const LayerCall& call, int at, const Point* points, Vector (&a)[9]) {
  for (auto& value : a) value = Vector{};
  for (int p = 0; p < 8; ++p) {
    Vector m[5];
    workRows(points[p].flow, m);
    const int first = coefficient::amplitude + p * 45;
    for (int r = 0; r < 5; ++r)
#pragma GCC unroll 9
      for (int i = 0; i < 9; ++i) a[i] += coefficientAt<Own>(call, first + 9 * r + i, at) * m[r];
  }
}

template <bool Own>
inline void totalStrain(const LayerCall& call, int at, int p, const Point& point, const Vector (&a)[9],
                        Vector (&strain)[5]) {
  for (int r = 0; r < 5; ++r) strain[r] = point.strain[r];
  const int first = coefficient::inner + p * 45;
  for (int i = 0; i < 9; ++i)
#pragma GCC unroll 5
    for (int r = 0; r < 5; ++r) strain[r] += coefficientAt<Own>(call, first + 5 * i + r, at) * a[i];
}

// How far the trial lies beyond the yield surface, squared norms.
inline Vector beyond(const LayerCall& call, const Point& point, const Vector (&strain)[5]) {
  Vector eta[5];
  for (int r = 0; r < 5; ++r) eta[r] = strain[r] - (1 + call.kinematicShare) * point.base[r];
  const Vector radius = call.radius + call.growth * point.before;
  return squaredNorm(eta) - radius * radius;
}

inline void returnPoint(const LayerCall& call, const Vector (&strain)[5], Point& point) {
  Vector eta[5];
  for (int r = 0; r < 5; ++r) eta[r] = strain[r] - (1 + call.kinematicShare) * point.base[r];
  const Vector size = root(squaredNorm(eta)), radius = call.radius + call.growth * point.before;
  const double give = 1 / (1 + call.kinematicShare + call.isotropicShare);
  const Vector amount = positive(size - radius) * give;
  const Vector along = amount / (size + 1e-300);
  for (int r = 0; r < 5; ++r) point.flow[r] = point.base[r] + along * eta[r];
  point.equivalent = point.before + std::sqrt(2.0 / 3) * amount;
}

// What is left of the equation for the size x of the step, and its slope.
struct Residual {
  Vector along[5], size, value, slope;
};
inline Residual residualOf(const LayerCall& call, const Vector (&elastic)[5], const Recovering& own, Vector x) {
  const double perGamma = std::sqrt(2.0 / 3);
  Residual out;
  for (int r = 0; r < 5; ++r) out.along[r] = elastic[r];
  Vector turned[5] = {}, stiffness = 1 - Vector{}, slope = stiffness;
  for (int i = 0; i < backstressCount; ++i) {
    const Vector kept = 1 / (1 + own.recovery[i] * x);
    const Vector loss = own.recovery[i] * kept * kept;
    for (int r = 0; r < 5; ++r) {
      out.along[r] -= kept * own.stressBefore[i][r];
      turned[r] += loss * own.stressBefore[i][r];
    }
    stiffness += call.stiffness[i] * kept, slope += call.stiffness[i] * kept * kept;
  }
  const Vector soft = 1 / (1 + call.rate * perGamma * x);
  const Vector growth = (own.growthBefore + call.rate * perGamma * call.saturation * x) * soft;
  out.size = root(squaredNorm(out.along));
  Vector work[5];
  workRows(turned, work);
  Vector climb{};
  for (int r = 0; r < 5; ++r) climb += work[r] * out.along[r];
  out.value = out.size - call.radius - growth - x * stiffness;
  out.slope = climb / (out.size + 1e-300) - call.rate * perGamma * (call.saturation - growth) * soft - slope;
  return out;
}

inline Vector beyond(const LayerCall& call, const Point& point, const Vector (&strain)[5], const Recovering& own) {
  Vector eta[5];
  for (int r = 0; r < 5; ++r) {
    eta[r] = strain[r] - point.base[r];
    for (int i = 0; i < backstressCount; ++i) eta[r] -= own.stressBefore[i][r];
  }
  const Vector radius = call.radius + own.growthBefore;
  return squaredNorm(eta) - radius * radius;
}

// Of Ohno and Wang, for a step along `trial`.
inline void setRecovery(const LayerCall& call, const Vector (&trial)[5], Recovering& own) {
  const double perGamma = std::sqrt(2.0 / 3);
  Vector work[5];
  workRows(trial, work);
  const Vector size = root(squaredNorm(trial)) + 1e-300;
  for (int i = 0; i < backstressCount; ++i) {
    own.recovery[i] = call.recovery[i] * perGamma - Vector{};
    if (call.exponent == 0 || call.largest[i] == 0) continue;
    Vector along{};
    for (int r = 0; r < 5; ++r) along += work[r] * own.stressBefore[i][r];
    const Vector norm = root(squaredNorm(own.stressBefore[i])) + 1e-300;
    Vector share = norm / call.largest[i];
    for (int lane = 0; lane < LANES; ++lane) share[lane] = std::pow(share[lane], call.exponent);
    own.recovery[i] *= share * positive(along / (norm * size));
  }
}

// `first`: of the step; the recovery stands from then on.
inline void returnPoint(const LayerCall& call, const Vector (&strain)[5], Point& point, Recovering& own, bool first) {
  const double perGamma = std::sqrt(2.0 / 3);
  Vector elastic[5], trial[5], x{};
  for (int r = 0; r < 5; ++r) {
    trial[r] = elastic[r] = strain[r] - point.base[r];
    for (int i = 0; i < backstressCount; ++i) trial[r] -= own.stressBefore[i][r];
  }
  if (first) setRecovery(call, trial, own);
  Residual left = residualOf(call, elastic, own, x);
  const Vector yields = positive(left.value) > 0 ? 1 - Vector{} : Vector{};
  for (int k = 0; k < maximumIterations &&
                  largest(yields * (left.value > 0 ? left.value : -left.value)) > 1e-3 * tolerance * call.radius;
       ++k) {
    x = positive(x - yields * left.value / left.slope);
    left = residualOf(call, elastic, own, x);
  }
  const Vector grow = x / (left.size + 1e-300), soft = 1 / (1 + call.rate * perGamma * x);
  own.growth = (own.growthBefore + call.rate * perGamma * call.saturation * x) * soft;
  Vector stress[5];  // deviatoric, over 2 mu, along the step: radius n + X
  const Vector radius = (call.radius + own.growth) / (left.size + 1e-300);
  for (int r = 0; r < 5; ++r) {
    const Vector step = grow * left.along[r];
    point.flow[r] = point.base[r] + step;
    stress[r] = radius * left.along[r];
    for (int i = 0; i < backstressCount; ++i) {
      own.stress[i][r] = (own.stressBefore[i][r] + call.stiffness[i] * step) / (1 + own.recovery[i] * x);
      stress[r] += own.stress[i][r];
    }
  }
  point.equivalent = point.before + perGamma * x;
  Vector work[5];
  workRows(stress, work);
  own.work = Vector{};
  for (int r = 0; r < 5; ++r) own.work += work[r] * grow * left.along[r];
}

inline Vector beyond(const LayerCall& call, const Point& point, const Vector (&strain)[5], const None&) {
  return beyond(call, point, strain);
}
inline void returnPoint(const LayerCall& call, const Vector (&strain)[5], Point& point, None&, bool) {
  returnPoint(call, strain, point);
}

template <bool Own, bool Recovers>
inline void returnAll(const LayerCall& call, int at, Point* points, Backstresses<Recovers>* stresses,
                      const Vector (&a)[9], bool first) {
  for (int p = 0; p < 8; ++p) {
    Vector strain[5];
    totalStrain<Own>(call, at, p, points[p], a, strain);
    returnPoint(call, strain, points[p], stresses[p], first);
  }
}

template <bool Own, bool Recovers>
void settle(const LayerCall& call, int at, Point* points, Backstresses<Recovers>* stresses, Vector (&a)[9]) {
  const double share = call.kinematicShare + call.isotropicShare;
  const double low = std::max(share / (1 + share), minimumShare);
  const double middle = 0.5 * (1 + low), half = 0.5 * (1 - low), sigma = middle / half;
  double rho = 1 / sigma;
  const Vector steepest = coefficientAt<Own>(call, coefficient::steepest, at);
  Vector step[9] = {};
  for (int k = 0; k < maximumIterations; ++k) {
    returnAll<Own, Recovers>(call, at, points, stresses, a, k == 0);
    Vector wanted[9], maximum{};
    addAmplitudes<Own>(call, at, points, wanted);
    for (int i = 0; i < 9; ++i) {
      wanted[i] -= a[i];
      const Vector size = wanted[i] > 0 ? wanted[i] : -wanted[i];
      maximum = size > maximum ? size : maximum;
    }
    if (largest(maximum * steepest) < tolerance * call.radius) return;
    const double next = k == 0 ? rho : 1 / (2 * sigma - rho);
    for (int i = 0; i < 9; ++i) {
      step[i] = k == 0 ? wanted[i] / middle : next * rho * step[i] + (2 * next / half) * wanted[i];
      a[i] += step[i];
    }
    rho = next;
  }
  returnAll<Own, Recovers>(call, at, points, stresses, a, false);
}

template <bool Own>
void gatherStrain(const LayerCall& call, int at, Point* points) {
  Vector u[24];
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) {
      const double* line = call.corner[i] + c * call.stride + at;
      u[3 * i + c] = load(line), u[12 + 3 * i + c] = loadLoose(line + 1);
    }
  for (int p = 0; p < 8; ++p) {
    Vector e[5] = {};
    const int first = coefficient::strain + p * 120;
#pragma GCC unroll 24
    for (int j = 0; j < 24; ++j)
#pragma GCC unroll 5
      for (int r = 0; r < 5; ++r) e[r] += coefficientAt<Own>(call, first + 5 * j + r, at) * u[j];
    for (int r = 0; r < 5; ++r) points[p].strain[r] = e[r];
  }
}

template <bool Recovers>
inline void loadState(const LayerCall& call, int at, Point* points) {
  for (int p = 0; p < 8; ++p) {
    const double* state = call.state + p * stateRows<Recovers> * groupLanes + at;
    for (int r = 0; r < 5; ++r) points[p].base[r] = points[p].flow[r] = load(state + r * groupLanes);
    points[p].before = points[p].equivalent = load(state + 5 * groupLanes);
  }
}

inline void loadStresses(const LayerCall&, int, None*) {}
inline void loadStresses(const LayerCall& call, int at, Recovering* stresses) {
  for (int p = 0; p < 8; ++p) {
    const double* state = call.state + p * stateRows<true> * groupLanes + at;
    auto& own = stresses[p];
    for (int i = 0; i < backstressCount; ++i)
      for (int r = 0; r < 5; ++r) own.stressBefore[i][r] = load(state + (6 + 5 * i + r) * groupLanes);
    own.growthBefore = load(state + 21 * groupLanes);
  }
}

inline void storeStresses(const LayerCall&, int, const None*) {}
inline void storeStresses(const LayerCall& call, int at, const Recovering* stresses) {
  for (int p = 0; p < 8; ++p) {
    double* state = call.state + p * stateRows<true> * groupLanes + at;
    const auto& own = stresses[p];
    for (int i = 0; i < backstressCount; ++i)
      for (int r = 0; r < 5; ++r) store(state + (6 + 5 * i + r) * groupLanes, own.stress[i][r]);
    store(state + 21 * groupLanes, own.growth);
    double* work = state + 22 * groupLanes;
    store(work, load(work) + own.work);
  }
}

template <bool Own, bool Recovers>
[[gnu::noinline]] void forceOf(const LayerCall& call, int at) {
  Point points[8];
  loadState<Recovers>(call, at, points);
  Vector force[24] = {};
  for (int p = 0; p < 8; ++p) {
    Vector m[5];
    workRows(points[p].base, m);
    const Vector weight = coefficientAt<Own>(call, coefficient::weight + p, at);
    for (int r = 0; r < 5; ++r) m[r] = m[r] * weight;
    const int first = coefficient::strain + p * 120;
    for (int j = 0; j < 24; ++j)
#pragma GCC unroll 5
      for (int r = 0; r < 5; ++r) force[j] += coefficientAt<Own>(call, first + 5 * j + r, at) * m[r];
  }
  for (int j = 0; j < 24; ++j) store(call.force + j * groupLanes + at, force[j]);
}

template <bool Own, bool Recovers>
bool returnLanes(const LayerCall& call, int at) {
  Point points[8];
  Backstresses<Recovers> stresses[8];
  gatherStrain<Own>(call, at, points);
  loadState<Recovers>(call, at, points);
  loadStresses(call, at, stresses);
  Vector a[9] = {};
  if (call.flowed) addAmplitudes<Own>(call, at, points, a);
  bool yields = false;
  for (int p = 0; p < 8 && !yields; ++p) {
    Vector strain[5];
    if (call.flowed) {
      totalStrain<Own>(call, at, p, points[p], a, strain);
      yields = anyPositive(beyond(call, points[p], strain, stresses[p]));
    } else {
      yields = anyPositive(beyond(call, points[p], points[p].strain, stresses[p]));
    }
  }
  if (!yields) return false;
  settle<Own, Recovers>(call, at, points, stresses, a);
  for (int p = 0; p < 8; ++p) {
    double* state = call.state + p * stateRows<Recovers> * groupLanes + at;
    for (int r = 0; r < 5; ++r) store(state + r * groupLanes, points[p].flow[r]);
    store(state + 5 * groupLanes, points[p].equivalent);
  }
  storeStresses(call, at, stresses);
  forceOf<Own, Recovers>(call, at);
  return true;
}

template <bool Own, bool Recovers>
bool returnGroup(const LayerCall& call) {
  bool changed = false;
  for (int at = 0; at < groupLanes; at += LANES) changed = returnLanes<Own, Recovers>(call, at) || changed;
  return changed;
}

template <bool Own, bool Recovers>
void forceOfGroup(const LayerCall& call) {
  for (int at = 0; at < groupLanes; at += LANES) forceOf<Own, Recovers>(call, at);
}

bool returnToYield(const LayerCall& call) {
  if (call.recovers) return call.own ? returnGroup<true, true>(call) : returnGroup<false, true>(call);
  return call.own ? returnGroup<true, false>(call) : returnGroup<false, false>(call);
}

void plasticForce(const LayerCall& call) {
  if (call.recovers)
    call.own ? forceOfGroup<true, true>(call) : forceOfGroup<false, true>(call);
  else
    call.own ? forceOfGroup<true, false>(call) : forceOfGroup<false, false>(call);
}

}  // namespace
}  // namespace squat::plasticity
