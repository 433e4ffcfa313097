#include "roughness/HeightSpectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenario/Irregularity.h"
#include "signals/FourierTransform.h"

namespace squat::roughness {

std::vector<WavelengthBand> wavelengthBands(double shortest, double longest) {
  const double half = std::pow(10.0, 0.05);
  std::vector<WavelengthBand> bands;
  for (const double middle : scenario::thirdOctaveWavelengths(shortest, longest))
    bands.push_back({middle, middle / half, middle * half});
  return bands;
}

signals::PowerSpectrum stretchSpectrumOf(const std::vector<double>& values, double rate) {
  signals::PowerSpectrumOptions options;
  options.detrend = signals::Detrend::linear;
  options.transformLength = signals::fastLength(4 * values.size());
  return signals::powerSpectrum({0, 1 / rate, values, {}, {}}, options);
}

signals::PowerSpectrum quietSpectrumOf(const std::vector<double>& values, double rate) {
  signals::PowerSpectrumOptions options;
  options.window = signals::Window::boxcar;
  options.detrend = signals::Detrend::none;
  options.transformLength = signals::fastLength(4 * values.size());
  return signals::powerSpectrum({0, 1 / rate, values, {}, {}}, options);
}

std::vector<double> bandSquares(const signals::PowerSpectrum& spectrum, const std::vector<WavelengthBand>& bands,
                                double speed) {
  std::vector<double> squares;
  for (const auto& band : bands) {
    const double high = speed / band.shortest;
    squares.push_back(high <= spectrum.frequency.back() ? signals::bandPower(spectrum, speed / band.longest, high)
                                                        : std::numeric_limits<double>::quiet_NaN());
  }
  return squares;
}

std::vector<double> heightLevels(const std::vector<double>& heights, double spacing,
                                 const std::vector<WavelengthBand>& bands) {
  auto levels = bandSquares(stretchSpectrumOf(heights, 1 / spacing), bands);
  for (auto& level : levels) level = levelOfSquare(level);
  return levels;
}

double levelOfSquare(double square) { return 10 * std::log10(square / 1e-12); }

double degreesOfFreedom(const WavelengthBand& band, double length, bool once) {
  const double width = 1 / band.shortest - 1 / band.longest;  // [1/m]
  return std::max(1.0, (once ? 1.0 : 2.0) * width * length);
}

CountSpread countSpread(double degrees) {
  constexpr double normal = 1.959964;  // 97.5 % of the normal distribution
  const double a = 2 / (9 * degrees);
  const auto ratio = [&](double z) { return std::pow(std::max(1 - a + z * std::sqrt(a), 0.02), 3); };
  return {10 * std::log10(ratio(normal)), -10 * std::log10(ratio(-normal))};
}

}  // namespace squat::roughness
