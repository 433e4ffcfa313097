#include "detection/EventMatch.h"

#include <cmath>

namespace squat::detection {

EventMatch matchOf(const EventFeatures& event, const BandValues& expected, const Vehicle& vehicle,
                   const BandMatrix& scatter) {
  EventMatch match;
  BandValues ofNoise = BandValues::Ones();
  for (Eigen::Index b = 0; b < expected.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (!(event.freedom[i] > 0) || !(event.energy[i] > 0)) continue;
    const double signal = event.speed * event.speed * std::pow(10.0, expected[b] + vehicle.mean[b]);
    const double noise = event.noise[i], all = signal + noise;
    match.share[b] = signal / all;
    match.distance[b] = std::log10(event.energy[i] / all);
    const double variance = (2 * noise * noise + 4 * signal * noise) / event.freedom[i];
    const double deviation = std::sqrt(variance) / all / std::log(10.0);
    ofNoise[b] = deviation * deviation + 1e-4;
  }
  BandMatrix covariance = match.share.asDiagonal() * scatter * match.share.asDiagonal();
  covariance.diagonal() += ofNoise;
  match.covariance.compute(covariance);
  const double logs = match.covariance.matrixLLT().diagonal().array().log().sum();  // half of that of the determinant
  match.logDensity = -0.5 * match.distance.dot(match.covariance.solve(match.distance)) - logs;
  return match;
}

}  // namespace squat::detection
