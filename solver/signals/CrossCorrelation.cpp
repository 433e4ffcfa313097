#include <algorithm>
#include <cmath>
#include <numeric>

#include "signals/Alignment.h"
#include "signals/FourierTransform.h"
#include "signals/Resample.h"
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

// The part of a sample by which b, at index i + lag, is late against a: least squares of a - g b(i + lag + part) with
// the gain g, by Gauss and Newton. A signal and its copy have residuals of exactly zero, and so a part of zero, which
// the vertex of a parabola through correlations has not where one signal is a piece of the other.
double partOfASample(const TimeSeries& a, const TimeSeries& b, long lag) {
  constexpr long margin = 2;
  const auto sizeA = static_cast<long>(a.values.size()), sizeB = static_cast<long>(b.values.size());
  const long from = std::max(0L, margin - lag), to = std::min(sizeA, sizeB - margin - lag);
  if (to - from < 3) return 0;
  const TimeSeries steps{0, 1, b.values, b.name, b.unit};
  const Interpolator between(steps);
  double part = 0;
  for (int round = 0; round < 6; ++round) {
    const auto value = [&](long i) {
      return part == 0 ? b.values[static_cast<std::size_t>(i + lag)] : between(static_cast<double>(i + lag) + part);
    };
    double meanA = 0, meanB = 0;
    std::vector<double> rowB;
    for (long i = from; i < to; ++i)
      rowB.push_back(value(i)), meanA += a.values[static_cast<std::size_t>(i)], meanB += rowB.back();
    meanA /= static_cast<double>(to - from), meanB /= static_cast<double>(to - from);
    double ab = 0, bb = 0;
    for (long i = from; i < to; ++i) {
      const double own = rowB[static_cast<std::size_t>(i - from)] - meanB;
      ab += (a.values[static_cast<std::size_t>(i)] - meanA) * own, bb += own * own;
    }
    if (!(ab > 0)) return 0;
    const double gain = ab / bb;
    double rs = 0, ss = 0;
    for (long i = from + 1; i + 1 < to; ++i) {
      const auto k = static_cast<std::size_t>(i - from);
      const double slope = 0.5 * gain * (rowB[k + 1] - rowB[k - 1]);
      rs += (a.values[static_cast<std::size_t>(i)] - meanA - gain * (rowB[k] - meanB)) * slope, ss += slope * slope;
    }
    const double change = ss > 0 ? rs / ss : 0;
    part += change;
    if (!(std::abs(part) <= 1)) return 0;
    if (std::abs(change) < 1e-9) break;
  }
  return part;
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
  double offset = (b.start - a.start) / a.step;  // of equal indices
  if (std::abs(offset - std::round(offset)) < 1e-6) offset = std::round(offset);
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
  const double part = best > from && best < to ? partOfASample(a, b, best) : 0;
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
