#include "detection/EvidenceTail.h"

#include <algorithm>
#include <cmath>

namespace squat::detection {
namespace {

constexpr double metres = 1000;  // in a kilometre

// W(y) of white noise, a parabola through the largest evidences of 40 000 m (5 kHz, 30 m/s).
constexpr double whiteOffset = 1.221, whiteSlope = 0.762, whiteBend = 0.0151;
double whiteEvidence(double y) { return std::max(0.05, whiteOffset + y * (whiteSlope + y * whiteBend)); }
double whiteOrdinate(double evidence) {
  const double square = whiteSlope * whiteSlope + 4 * whiteBend * (evidence - whiteOffset);
  return (std::sqrt(std::max(0.0, square)) - whiteSlope) / (2 * whiteBend);
}
double ordinateOf(double share) { return -std::log(-std::log(share)); }

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

EvidenceTail::EvidenceTail(const std::vector<double>& maxima) {
  constexpr double low = 0.3, high = 0.6, whiteMetres = 50, least = 0.05, largestExponent = 3;
  if (maxima.empty()) return;
  const double lower = std::log(whiteEvidence(ordinateOf(low))), upper = std::log(whiteEvidence(ordinateOf(high)));
  const double seenLow = std::log(std::max(least, quantile(maxima, low)));
  const double seenHigh = std::log(std::max(least, quantile(maxima, high)));
  const double weight = static_cast<double>(maxima.size()) / (static_cast<double>(maxima.size()) + whiteMetres);
  const double exponent = 1 + weight * ((seenHigh - seenLow) / (upper - lower) - 1);
  exponent_ = std::clamp(exponent, 1.0, largestExponent);
  factor_ = std::exp(weight * (seenHigh - exponent_ * upper) + (1 - weight) * (1 - exponent_) * upper);
}

double EvidenceTail::alarmsPerKilometre(double evidence) const {
  if (!(evidence > 0)) return metres;
  const double white = std::pow(evidence / factor_, 1 / exponent_);
  return -metres * std::expm1(-std::exp(-whiteOrdinate(white)));
}

double EvidenceTail::evidenceOf(double alarms) const {
  const double share = std::min(0.999, alarms / metres);
  return factor_ * std::pow(whiteEvidence(-std::log(-std::log1p(-share))), exponent_);
}

}  // namespace squat::detection
