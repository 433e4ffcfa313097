#include "signals/PowerSpectrum.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {
namespace {

struct SegmentLayout {
  std::size_t segment, hop, segments, transform;
};

SegmentLayout segmentLayout(const TimeSeries& series, const PowerSpectrumOptions& options) {
  const std::size_t n = series.values.size();
  SegmentLayout layout{options.segment ? options.segment : n, 0, 0, 0};
  if (layout.segment < 2) throw SignalError("a segment of a power spectrum needs at least 2 samples");
  if (layout.segment > n)
    throw SignalError("a segment of " + std::to_string(layout.segment) + " samples does not fit into the " +
                      std::to_string(n) + " samples of the signal");
  if (!(options.overlap >= 0 && options.overlap < 1))
    throw SignalError("the overlap of segments must be a share from 0 up to, not including, 1");
  const auto shared =
      static_cast<std::size_t>(std::floor(options.overlap * static_cast<double>(layout.segment) + 1e-9));
  layout.hop = std::max<std::size_t>(1, layout.segment - shared);
  layout.segments = (n - layout.segment) / layout.hop + 1;
  layout.transform = options.transformLength ? options.transformLength : layout.segment;
  if (layout.transform < layout.segment)
    throw SignalError("the transform length must not be below the segment's " + std::to_string(layout.segment) +
                      " samples");
  return layout;
}

std::string describe(const PowerSpectrumOptions& options, const SegmentLayout& layout) {
  std::ostringstream text;
  text << toText(options.window) << ", " << layout.segment << " samples";
  if (layout.segments > 1) text << ", " << layout.segments << " segments, overlap " << options.overlap;
  text << ", detrend " << toText(options.detrend);
  if (layout.transform != layout.segment) text << ", padded to " << layout.transform;
  return text.str();
}

}  // namespace

PowerSpectrum powerSpectrum(const TimeSeries& series, const PowerSpectrumOptions& options) {
  requireUsable(series, 2, "a power spectrum");
  requireVarying(series, "a power spectrum");
  const SegmentLayout layout = segmentLayout(series, options);
  const auto weights = windowWeights(options.window, layout.segment);
  const double weightSquares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);

  const RealTransform transform(layout.transform);
  const std::size_t bins = layout.transform / 2 + 1;
  std::vector<double> piece(layout.transform, 0.0);
  std::vector<Complex> bin(bins);

  PowerSpectrum result;
  result.density.assign(bins, 0.0);
  for (std::size_t segment = 0; segment < layout.segments; ++segment) {
    std::copy_n(series.values.begin() + static_cast<std::ptrdiff_t>(segment * layout.hop), layout.segment,
                piece.begin());
    removeTrend(piece.data(), layout.segment, options.detrend);
    for (std::size_t i = 0; i < layout.segment; ++i) {
      result.meanSquare += piece[i] * piece[i];
      piece[i] *= weights[i];
    }
    transform.forward(piece.data(), bin.data());
    for (std::size_t k = 0; k < bins; ++k) result.density[k] += std::norm(bin[k]);
  }
  result.meanSquare /= static_cast<double>(layout.segments * layout.segment);

  const double rate = series.rate();
  const double scale = 1 / (rate * weightSquares * static_cast<double>(layout.segments));
  const double step = rate / static_cast<double>(layout.transform);
  result.frequency.resize(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    const bool unpaired = k == 0 || 2 * k == layout.transform;
    result.density[k] *= unpaired ? scale : 2 * scale;
    result.frequency[k] = static_cast<double>(k) * step;
    result.integral += result.density[k] * step;
  }
  result.unit = series.unit;
  result.window = describe(options, layout);
  result.segmentLength = layout.segment;
  result.segments = layout.segments;
  return result;
}

double bandPower(const PowerSpectrum& spectrum, double low, double high) {
  if (!(low >= 0 && high > low)) throw SignalError("a band needs a rising pair of frequencies");
  if (spectrum.frequency.size() < 2 || high > spectrum.frequency.back() * (1 + 1e-12)) {
    std::ostringstream text;
    text << "the band " << low << " to " << high << " Hz reaches above "
         << (spectrum.frequency.empty() ? 0.0 : spectrum.frequency.back()) << " Hz, half the sampling rate";
    throw SignalError(text.str());
  }
  const auto& f = spectrum.frequency;
  const auto& g = spectrum.density;
  double power = 0;
  for (std::size_t k = 0; k + 1 < f.size(); ++k) {
    const double from = std::max(low, f[k]), to = std::min(high, f[k + 1]);
    if (to <= from) continue;
    const auto at = [&](double x) { return g[k] + (g[k + 1] - g[k]) * (x - f[k]) / (f[k + 1] - f[k]); };
    power += 0.5 * (at(from) + at(to)) * (to - from);
  }
  return power;
}

TimeSeries cutOut(const TimeSeries& series, double from, double to) {
  const auto n = static_cast<double>(series.values.size());
  // A limit that is a sample's own time but for rounding takes the sample.
  const double first = std::clamp(std::ceil((from - series.start) / series.step - 1e-6), 0.0, n);
  const double last = std::clamp(std::floor((to - series.start) / series.step + 1e-6) + 1, 0.0, n);
  if (!(last > first)) {
    std::ostringstream text;
    text << "no sample of the signal lies between " << from << " and " << to << " s";
    throw SignalError(text.str());
  }
  const auto offset = static_cast<std::size_t>(first);
  TimeSeries result{series.timeAt(offset), series.step, {}, series.name, series.unit};
  result.values.assign(series.values.begin() + static_cast<std::ptrdiff_t>(offset),
                       series.values.begin() + static_cast<std::ptrdiff_t>(last));
  return result;
}

}  // namespace squat::signals
