#include "signals/Stft.h"

#include <algorithm>
#include <numeric>

#include "signals/FourierTransform.h"
#include "signals/SignalError.h"

namespace squat::signals {

Stft shortTimeTransform(const TimeSeries& series, const StftOptions& options) {
  if (options.segment < 2 || options.hop == 0)
    throw SignalError("a short-time transform needs a window of at least 2 samples and a hop of at least 1");
  const std::size_t length = options.transformLength ? options.transformLength : options.segment;
  if (length < options.segment) throw SignalError("the transform length must not be below the window's length");
  requireUsable(series, options.segment, "a short-time transform with this window");

  const auto weights = windowWeights(options.window, options.segment);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  const RealTransform transform(length);
  const std::size_t rows = length / 2 + 1;
  const std::size_t columns = (series.values.size() - options.segment) / options.hop + 1;

  Stft result;
  for (std::size_t row = 0; row < rows; ++row)
    result.frequency.push_back(series.rate() * static_cast<double>(row) / static_cast<double>(length));
  result.coefficients.resize(rows * columns);
  result.density.resize(rows * columns);
  std::vector<double> piece(length, 0.0);
  std::vector<Complex> bins(rows);
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t first = column * options.hop;
    for (std::size_t i = 0; i < options.segment; ++i) piece[i] = weights[i] * series.values[first + i];
    transform.forward(piece.data(), bins.data());
    result.time.push_back(series.start +
                          series.step * (static_cast<double>(first) + 0.5 * static_cast<double>(options.segment)));
    for (std::size_t row = 0; row < rows; ++row) {
      const bool unpaired = row == 0 || 2 * row == length;
      result.coefficients[row * columns + column] = bins[row] / sum;
      result.density[row * columns + column] =
          (unpaired ? 1.0 : 2.0) * std::norm(bins[row]) / (series.rate() * squares);
    }
  }
  result.segment = options.segment;
  result.window =
      toText(options.window) + ", " + std::to_string(options.segment) + " samples, hop " + std::to_string(options.hop);
  return result;
}

}  // namespace squat::signals
