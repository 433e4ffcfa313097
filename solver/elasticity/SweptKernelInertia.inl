// More inertia for short waves, as the kernels apply it (SelectiveMassScaling.h); after SweptKernelVectors.inl.
namespace squat::elasticity {
namespace {

// A cluster's amplitudes of three fields, at V vectors of stations.
template <typename Kind, int V, typename Real = typename Kind::Real>
inline void amplitudes(const Real (*rows)[3][chunk], int count, const Real* weights, int c, int at,
                       Real (&sums)[3][chunk]) {
  using Packed = typename Kind::Packed;
  Packed sum[3][V];
  for (int k = 0; k < 3; ++k)
    for (int v = 0; v < V; ++v) sum[k][v] = Packed{};
  for (int i = 0; i < count; ++i, weights += 6)
#pragma GCC unroll 4
    for (int v = 0; v < V; ++v) {
      const Packed x = Kind::load(rows[i][c] + at + v * Kind::lanes);
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) sum[k][v] += weights[k] * x;
    }
  for (int k = 0; k < 3; ++k)
    for (int v = 0; v < V; ++v) Kind::store(sums[k] + at + v * Kind::lanes, sum[k][v]);
}

// The sum of all lanes, in each of them: halves change places, then halves of these.
template <typename Kind>
inline typename Kind::Packed sumOfLanes(typename Kind::Packed x) {
  if constexpr (Kind::lanes == 8) {
    x += __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3);
    x += __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5);
    x += __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6);
  } else if constexpr (Kind::lanes == 4) {
    x += __builtin_shufflevector(x, x, 2, 3, 0, 1);
    x += __builtin_shufflevector(x, x, 1, 0, 3, 2);
  } else {
    static_assert(Kind::lanes == 2);
    x += __builtin_shufflevector(x, x, 1, 0);
  }
  return x;
}

// What of STATIONS of the amplitudes is kept along the sweep (projectionLocation).
template <typename Kind, int STATIONS, typename Real = typename Kind::Real>
inline void projectAlong(Real (&sums)[3][chunk], const Real* kept, int at) {
  using Packed = typename Kind::Packed;
  constexpr int lanes = Kind::lanes, vectors = STATIONS / lanes;
  const auto line = [&](int k, int v) { return Kind::loadLoose(kept + STATIONS * k + v * lanes); };
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    Packed amplitude[keptAlong];
#pragma GCC unroll 2
    for (int field = 0; field < keptAlong; ++field) {
      Packed weighed = line(field, 0) * Kind::load(sums[k] + at);
#pragma GCC unroll 8
      for (int v = 1; v < vectors; ++v) weighed += line(field, v) * Kind::load(sums[k] + at + v * lanes);
      amplitude[field] = sumOfLanes<Kind>(weighed);
    }
#pragma GCC unroll 8
    for (int v = 0; v < vectors; ++v)
      Kind::store(sums[k] + at + v * lanes, amplitude[0] * line(keptAlong, v) + amplitude[1] * line(keptAlong + 1, v));
  }
}

// What is kept in full, the rest by its share, at V vectors of stations.
template <typename Kind, int V, typename Real = typename Kind::Real>
inline void keepFields(Real (*rows)[3][chunk], int count, const Real* weights, Real share, int c, int at,
                       const Real (&sums)[3][chunk]) {
  using Packed = typename Kind::Packed;
  Packed sum[3][V];
  for (int k = 0; k < 3; ++k)
    for (int v = 0; v < V; ++v) sum[k][v] = Kind::load(sums[k] + at + v * Kind::lanes);
  weights += 3;
  for (int i = 0; i < count; ++i, weights += 6)
#pragma GCC unroll 4
    for (int v = 0; v < V; ++v) {
      Real* x = rows[i][c] + at + v * Kind::lanes;
      Kind::store(x, share * Kind::load(x) + weights[0] * sum[0][v] + weights[1] * sum[1][v] + weights[2] * sum[2][v]);
    }
}

// Stations of a cluster by a filter of their own (KernelFilter), from accelerations to those times station masses.
template <typename Kind, typename Real = typename Kind::Real>
inline void filterBlock(Real (*rows)[3][chunk], int count, const Real* values, Real share, int c, int at, int stations,
                        const Real (&before)[maximumRows][chunk], const double* stationMass) {
  using Packed = typename Kind::Packed;
  static_assert(stationUnit % Kind::lanes == 0);
  const std::size_t size = static_cast<std::size_t>(count) * stations;
  Packed sum[keptInBlock];
#pragma GCC unroll 6
  for (int k = 0; k < keptInBlock; ++k) sum[k] = Packed{};
  const auto overStations = [&](const Real* from, const auto& body) {
    for (int i = 0; i < count; ++i)
      for (int s = 0; s < stations; s += Kind::lanes, from += Kind::lanes) body(i, at + s, from);
  };
  overStations(values, [&](int i, int s, const Real* from) {
    const Packed x = Kind::load(before[i] + s);
#pragma GCC unroll 6
    for (int k = 0; k < keptInBlock; ++k) sum[k] += Kind::loadLoose(from + k * size) * x;
  });
#pragma GCC unroll 6
  for (int k = 0; k < keptInBlock; ++k) sum[k] = sumOfLanes<Kind>(sum[k]);
  overStations(values + keptInBlock * size, [&](int i, int s, const Real* from) {
    Packed value = share * Kind::load(before[i] + s);
#pragma GCC unroll 6
    for (int k = 0; k < keptInBlock; ++k) value += Kind::loadLoose(from + k * size) * sum[k];
    Kind::store(rows[i][c] + s, value);
    for (int k = s; k < s + Kind::lanes; ++k) rows[i][c][k] *= static_cast<Real>(stationMass[k]);
  });
}

// Accelerations of a cluster's nodes, times station mass, short waves slowed (SelectiveMassScaling.h).
template <typename Whole, typename Piece, typename Real = typename Piece::Real>
inline void slowCluster(const KernelCall& call, const Group<Real>& group, int index, Real (*rows)[3][chunk]) {
  // As many of the widest vectors as leave the sums of three fields in registers.
  constexpr int vectors = chunk / Whole::lanes < 4 ? chunk / Whole::lanes : 4, maximum = vectors * Whole::lanes;
  const auto& own = call.clusters[index];
  const int count = own.end - own.first;
  const Real* weights = clusterWeightsOf(call, Real{}) + 6 * static_cast<std::size_t>(own.first);
  const Real share = static_cast<Real>(call.shortShare);
  const int* ownFilter = call.ownFilter ? call.ownFilter + index * call.stationUnits + group.at / stationUnit : nullptr;
  alignas(64) Real sums[3][chunk];
  alignas(64) Real before[maximumRows][chunk];
  const double* stationMass = call.stationMass + group.at;
  bool hasOwn = false;
  for (int at = 0; ownFilter && at < group.count; at += stationUnit) hasOwn |= ownFilter[at / stationUnit] >= 0;
  for (int c = 0; c < 3; ++c) {
    if (hasOwn)
      for (int i = 0; i < count; ++i)
        for (int s = 0; s < group.count; ++s) before[i][s] = rows[i][c][s] / static_cast<Real>(stationMass[s]);
    int at = 0;
    for (; at + maximum <= group.count; at += maximum) amplitudes<Whole, vectors>(rows, count, weights, c, at, sums);
    for (; at < group.count; at += Piece::lanes) amplitudes<Piece, 1>(rows, count, weights, c, at, sums);
    for (at = 0; at < group.count; at += stationUnit) {
      const Real* projection = group.along[at / stationUnit];
      if (!projection) continue;
      if (group.alongStations[at / stationUnit] == maximumStations)
        projectAlong<Piece, maximumStations>(sums, projection, at);
      else
        projectAlong<Piece, stationUnit>(sums, projection, at);
    }
    for (at = 0; at + maximum <= group.count; at += maximum)
      keepFields<Whole, vectors>(rows, count, weights, share, c, at, sums);
    for (; at < group.count; at += Piece::lanes) keepFields<Piece, 1>(rows, count, weights, share, c, at, sums);
    if (hasOwn)
      for (at = 0; at < group.count; at += stationUnit)
        if (const int filter = ownFilter[at / stationUnit]; filter >= 0)
          filterBlock<Piece>(rows, count, filterOf(call.filters[filter], Real{}), share, c, at,
                             group.alongStations[at / stationUnit], before, stationMass);
  }
}

// Accelerations of the clusters that are ready. `cluster` is the first that was not.
template <typename Whole, typename Piece, typename Real = typename Piece::Real>
inline void slowShortWaves(const KernelCall& call, const Group<Real>& group, int ready, int& cluster) {
  for (; cluster < call.clusterCount && call.clusters[cluster].end <= ready; ++cluster)
    slowCluster<Whole, Piece>(call, group, cluster, waiting<Real>(call, call.memberSlot[call.clusters[cluster].first]));
}

}  // namespace
}  // namespace squat::elasticity
