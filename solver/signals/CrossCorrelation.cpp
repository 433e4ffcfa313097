#include <algorithm>
#include <cmath>
#include <numeric>

#include "signals/Alignment.h"
#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

std::vector<Complex> spectrumOf(const std::vector<double>& values, std::size_t n) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  std::vector<Complex> result(n, Complex(0, 0));
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = values[i] - mean;
  ComplexTransform(n, Direction::forward).inPlace(result.data());
  return result;
}

}  // namespace

double shiftBetween(const TimeSeries& a, const TimeSeries& b, double largestShift) {
  requireUsable(a, 3, "a cross-correlation");
  requireUsable(b, 3, "a cross-correlation");
  if (std::abs(a.step - b.step) > 1e-9 * a.step)
    throw SignalError("signals '" + a.name + "' and '" + b.name + "' have different sampling rates; resample one");
  const std::size_t n = fastLength(a.values.size() + b.values.size());
  const auto first = spectrumOf(a.values, n);
  auto product = spectrumOf(b.values, n);
  for (std::size_t k = 0; k < n; ++k) product[k] *= std::conj(first[k]);
  ComplexTransform(n, Direction::backward).inPlace(product.data());

  // Entry m holds sum_i a[i] b[i + m]; entries beyond the end stand for negative m.
  const auto at = [&](long m) {
    return product[static_cast<std::size_t>(m < 0 ? m + static_cast<long>(n) : m)].real();
  };
  const double offset = (b.start - a.start) / a.step;  // of equal indices
  long from = -static_cast<long>(a.values.size()) + 1, to = static_cast<long>(b.values.size()) - 1;
  if (largestShift > 0) {
    from = std::max(from, static_cast<long>(std::ceil(-largestShift / a.step - offset)));
    to = std::min(to, static_cast<long>(std::floor(largestShift / a.step - offset)));
  }
  if (from > to)
    throw SignalError("signals '" + a.name + "' and '" + b.name + "' do not overlap within the largest shift allowed");
  long best = from;
  for (long m = from; m <= to; ++m)
    if (at(m) > at(best)) best = m;
  double part = 0;
  if (best > from && best < to) {
    const double before = at(best - 1), after = at(best + 1), bend = before - 2 * at(best) + after;
    if (bend < 0) part = 0.5 * (before - after) / bend;
  }
  return (static_cast<double>(best) + part + offset) * a.step;
}

double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.empty()) throw SignalError("a correlation needs two rows of the same length");
  const auto n = static_cast<double>(a.size());
  const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - meanA) * (b[i] - meanB);
    aa += (a[i] - meanA) * (a[i] - meanA);
    bb += (b[i] - meanB) * (b[i] - meanB);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace squat::signals
