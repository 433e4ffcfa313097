#include "detection/EventMatch.h"

#include <cmath>

namespace squat::detection {

EventMatch matchOf(const EventFeatures& event, const BandValues& expected, const Vehicle& vehicle,
                   const BandMatrix& scatter) {
  using Values = Eigen::Array<double, eigenBands, 1>;
  EventMatch match;
  const Values energy = Eigen::Map<const Values>(event.energy.data());
  const Values noise = Eigen::Map<const Values>(event.noise.data());
  const Values freedom = Eigen::Map<const Values>(event.freedom.data());
  const Values signal = event.speed * event.speed * (std::log(10.0) * (expected + vehicle.mean).array()).exp();
  const Values all = signal + noise;
  const Values variance = (2 * noise.square() + 4 * signal * noise) / (freedom * all.square());
  const auto isShown = freedom > 0 && energy > 0;
  match.share = isShown.select(signal / all, 0.0);
  match.distance = isShown.select((energy / all).log() / std::log(10.0), 0.0);
  const Values ofNoise = isShown.select(variance / (std::log(10.0) * std::log(10.0)) + 1e-4, 1.0);
  match.covariance = match.share.asDiagonal() * scatter * match.share.asDiagonal();
  match.covariance.diagonal() += ofNoise.matrix();
  return match;
}

// Cholesky's factor L of the covariance C, row by row, with the solution of L z = d: d^T C^-1 d is z^T z, and |C| the
// square of the product of L's diagonal. Of this size, plain loops take a third of the time of a general solver; tens
// of millions of them are needed for a record of 100 km.
double logDensityOf(const EventMatch& match) {
  double factor[eigenBands][eigenBands], solution[eigenBands];
  double squares = 0, determinant = 1;
  for (Eigen::Index i = 0; i < eigenBands; ++i) {
    double left = match.distance[i], diagonal = match.covariance(i, i);
    for (Eigen::Index j = 0; j < i; ++j) {
      double sum = match.covariance(i, j);
      for (Eigen::Index k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
      factor[i][j] = sum * factor[j][j];  // the diagonal is kept as its inverse
      diagonal -= factor[i][j] * factor[i][j];
      left -= factor[i][j] * solution[j];
    }
    factor[i][i] = 1 / std::sqrt(diagonal);
    solution[i] = left * factor[i][i];
    squares += solution[i] * solution[i];
    determinant *= diagonal;
  }
  return -0.5 * (squares + std::log(determinant));
}

}  // namespace squat::detection
