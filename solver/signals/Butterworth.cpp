#include "signals/Butterworth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>

#include "signals/SignalError.h"

namespace squat::signals {
namespace {

using Pole = std::complex<double>;

void requireEdges(int order, double low, double high, double rate) {
  std::ostringstream text;
  if (order < 1 || order > 12) text << "the filter order must be 1 to 12, not " << order;
  if (!(std::isfinite(rate) && rate > 0)) text << "the sampling rate must be a positive number of Hz";
  if (text.str().empty() && !(low > 0 && high > low))
    text << "the filter band " << low << " to " << high << " Hz is not a rising pair of positive frequencies";
  if (text.str().empty() && !(high < rate / 2))
    text << "a filter edge of " << high << " Hz needs a sampling rate above " << 2 * high << " Hz; this one is " << rate
         << " Hz";
  if (!text.str().empty()) throw SignalError(text.str());
}

// Poles of the analogue prototype (cut-off 1 rad/s) in the upper half plane, the real one last where there is one.
std::vector<Pole> prototypePoles(int order) {
  std::vector<Pole> poles;
  for (int k = 0; k < (order + 1) / 2; ++k)
    poles.push_back(std::polar(1.0, std::numbers::pi * (0.5 + (2 * k + 1) / (2.0 * order))));
  if (order % 2) poles.back() = -1.0;
  return poles;
}

Pole bilinear(Pole s) { return (2.0 + s) / (2.0 - s); }  // unit sampling rate

// Angular frequency of the analogue filter that the bilinear transform maps onto `frequency`.
double prewarp(double frequency, double rate) { return 2 * std::tan(std::numbers::pi * frequency / rate); }

std::complex<double> response(const SecondOrderSection& s, std::complex<double> z) {
  const auto w = 1.0 / z;
  return (s.b0 + w * (s.b1 + w * s.b2)) / (1.0 + w * (s.a1 + w * s.a2));
}

// Scales the first section so that the cascade's gain at z is one.
void normalise(std::vector<SecondOrderSection>& sections, std::complex<double> z) {
  std::complex<double> gain = 1;
  for (const auto& section : sections) gain *= response(section, z);
  const double factor = 1 / std::abs(gain);
  sections.front().b0 *= factor;
  sections.front().b1 *= factor;
  sections.front().b2 *= factor;
}

// Transposed direct form II, in place. `level` is the constant input before the first sample, for which every section
// stands in its steady state (SciPy's sosfilt_zi).
void filterInPlace(const std::vector<SecondOrderSection>& sections, std::vector<double>& values) {
  double level = values.front();
  for (const auto& s : sections) {
    const double steady = level * (s.b0 + s.b1 + s.b2) / (1 + s.a1 + s.a2);
    double second = s.b2 * level - s.a2 * steady;
    double first = s.b1 * level - s.a1 * steady + second;
    for (double& value : values) {
      const double in = value;
      value = s.b0 * in + first;
      first = s.b1 * in - s.a1 * value + second;
      second = s.b2 * in - s.a2 * value;
    }
    level = steady;
  }
}

}  // namespace

std::vector<SecondOrderSection> butterworthLowPass(int order, double cutoff, double rate) {
  requireEdges(order, cutoff / 2, cutoff, rate);
  const double edge = prewarp(cutoff, rate);
  std::vector<SecondOrderSection> sections;
  for (const Pole prototype : prototypePoles(order)) {
    const Pole z = bilinear(edge * prototype);
    if (prototype.imag() == 0)
      sections.insert(sections.begin(), {1, 1, 0, -z.real(), 0});
    else
      sections.push_back({1, 2, 1, -2 * z.real(), std::norm(z)});
  }
  normalise(sections, 1.0);
  return sections;
}

std::vector<SecondOrderSection> butterworthBandPass(int order, double low, double high, double rate) {
  requireEdges(order, low, high, rate);
  const double from = prewarp(low, rate), to = prewarp(high, rate);
  const double middle = std::sqrt(from * to), width = to - from;
  std::vector<SecondOrderSection> sections;
  // s -> (s^2 + middle^2) / (width s) turns each prototype pole p into the two roots of s^2 - p width s + middle^2.
  for (const Pole prototype : prototypePoles(order)) {
    const Pole half = 0.5 * width * prototype;
    const Pole root = std::sqrt(half * half - middle * middle);
    const Pole one = bilinear(half + root), other = bilinear(half - root);
    if (prototype.imag() == 0) {
      // The two roots are a conjugate pair, or two real numbers where the band is wide.
      sections.push_back({1, 0, -1, -(one + other).real(), (one * other).real()});
    } else {
      sections.push_back({1, 0, -1, -2 * one.real(), std::norm(one)});
      sections.push_back({1, 0, -1, -2 * other.real(), std::norm(other)});
    }
  }
  normalise(sections, std::polar(1.0, 2 * std::atan(middle / 2)));
  return sections;
}

std::vector<double> filterForwardBack(const std::vector<SecondOrderSection>& sections,
                                      const std::vector<double>& values) {
  const auto firstOrder = std::count_if(sections.begin(), sections.end(),
                                        [](const auto& section) { return section.b2 == 0 && section.a2 == 0; });
  const std::size_t edge = 3 * (2 * sections.size() + 1 - static_cast<std::size_t>(firstOrder));
  const std::size_t n = values.size();
  if (n <= edge)
    throw SignalError("a signal of " + std::to_string(n) + " samples is too short for this filter, which needs " +
                      std::to_string(edge + 1));
  std::vector<double> extended(n + 2 * edge);
  for (std::size_t i = 0; i < edge; ++i) {
    extended[i] = 2 * values.front() - values[edge - i];
    extended[edge + n + i] = 2 * values.back() - values[n - 2 - i];
  }
  std::copy(values.begin(), values.end(), extended.begin() + static_cast<std::ptrdiff_t>(edge));
  for (int pass = 0; pass < 2; ++pass) {
    filterInPlace(sections, extended);
    std::reverse(extended.begin(), extended.end());
  }
  return {extended.begin() + static_cast<std::ptrdiff_t>(edge), extended.end() - static_cast<std::ptrdiff_t>(edge)};
}

TimeSeries lowPass(const TimeSeries& series, double cutoff, int order) {
  requireUsable(series, 1, "a low-pass filter");
  TimeSeries result{series.start, series.step, {}, series.name, series.unit};
  result.values = filterForwardBack(butterworthLowPass(order, cutoff, series.rate()), series.values);
  return result;
}

TimeSeries bandPass(const TimeSeries& series, double low, double high, int order) {
  requireUsable(series, 1, "a band-pass filter");
  TimeSeries result{series.start, series.step, {}, series.name, series.unit};
  result.values = filterForwardBack(butterworthBandPass(order, low, high, series.rate()), series.values);
  return result;
}

double gainAt(const std::vector<SecondOrderSection>& sections, double frequency, double rate) {
  double gain = 1;
  for (const auto& section : sections)
    gain *= std::abs(response(section, std::polar(1.0, 2 * std::numbers::pi * frequency / rate)));
  return gain;
}

}  // namespace squat::signals
