#include "scenario/Irregularity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/ElementaryFunctions.h"

namespace squat::scenario {

namespace {

constexpr int harmonicsInBand = 64;
constexpr double nominal = 0.02;               // nominal wavelengths differ from exact ones by up to 1.2 %
constexpr double patch = 0.010, fade = 0.050;  // [m] half the patch with room to spare; where the heights grow

// Third octave k has its middle at 10^(k/10) m.
int bandOfWavelength(double wavelength) { return static_cast<int>(std::lround(10 * std::log10(wavelength))); }
double middleOf(int band) { return std::pow(10.0, band / 10.0); }

// Uniform in [0, 1).
double share(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

// Raw power per logarithm of wavelength; only ratios within a band count. At the table's ends level.
double densityAt(const std::vector<WavelengthLevel>& table, double wavelength) {
  const double within = std::clamp(wavelength, table.front().wavelength, table.back().wavelength);
  return std::pow(10.0, levelAt(table, within) / 10);
}

// Wavenumbers spread evenly over the logarithm, each at a random place in its share.
void addBand(const std::vector<WavelengthLevel>& table, int band, const Irregularity& options,
             std::vector<IrregularSurface::Harmonic>& harmonics) {
  const double level = levelAt(table, middleOf(band)) + options.offset;
  if (!std::isfinite(level)) return;
  std::mt19937_64 random(static_cast<std::uint64_t>(options.seed) * 1000U + static_cast<std::uint64_t>(500 + band));
  const double power = 1e-12 * std::pow(10.0, level / 10);  // [m2]
  const std::size_t first = harmonics.size();
  double sum = 0;
  for (int i = 0; i < harmonicsInBand; ++i) {
    const double exponent = 0.1 * (band + 0.5 - (i + share(random)) / harmonicsInBand);
    const double wavelength = std::pow(10.0, exponent), weight = densityAt(table, wavelength);
    harmonics.push_back({2 * std::numbers::pi / wavelength, weight, 2 * std::numbers::pi * share(random)});
    sum += weight;
  }
  for (std::size_t i = first; i < harmonics.size(); ++i)
    harmonics[i].amplitude = std::sqrt(2 * power * harmonics[i].amplitude / sum);
}

}  // namespace

const std::vector<WavelengthLevel>& iso3095Limit() {
  static const std::vector<WavelengthLevel> table{
      {0.00315, -11.0}, {0.004, -10.4}, {0.005, -9.8}, {0.0063, -9.2}, {0.008, -8.6},  {0.01, -8.0},
      {0.0125, -7.4},   {0.016, -6.8},  {0.02, -6.2},  {0.025, -5.6},  {0.0315, -5.0}, {0.04, -3.2},
      {0.05, -1.1},     {0.063, 0.9},   {0.08, 2.9},   {0.1, 4.9},     {0.125, 7.0},   {0.16, 9.0},
      {0.2, 11.0},      {0.25, 13.0},   {0.315, 15.0}, {0.4, 17.1}};
  return table;
}

std::vector<double> thirdOctaveWavelengths(double shortest, double longest) {
  std::vector<double> middles;
  if (!(shortest > 0) || !(longest >= shortest * (1 - nominal))) return middles;
  for (int band = bandOfWavelength(shortest) - 1; band <= bandOfWavelength(longest) + 1; ++band)
    if (const double middle = middleOf(band); middle >= shortest * (1 - nominal) && middle <= longest * (1 + nominal))
      middles.push_back(middle);
  return middles;
}

double levelAt(const std::vector<WavelengthLevel>& table, double wavelength) {
  const double none = -std::numeric_limits<double>::infinity();
  for (const auto& row : table)
    if (std::abs(row.wavelength / wavelength - 1) < nominal) return row.level;
  for (std::size_t i = 1; i < table.size(); ++i) {
    const auto &a = table[i - 1], &b = table[i];
    if (wavelength < a.wavelength || wavelength > b.wavelength) continue;
    const double along = std::log(wavelength / a.wavelength) / std::log(b.wavelength / a.wavelength);
    return a.level + along * (b.level - a.level);
  }
  return none;
}

IrregularSurface IrregularSurface::ofSpectrum(const std::vector<WavelengthLevel>& table, const Irregularity& options,
                                              double start) {
  IrregularSurface surface;
  if (table.empty()) return surface;
  for (const double middle : thirdOctaveWavelengths(options.shortest, options.longest))
    addBand(table, bandOfWavelength(middle), options, surface.harmonics_);
  double square = 0;
  for (const auto& h : surface.harmonics_) square += 0.5 * std::pow(h.wavenumber * h.amplitude, 2);
  surface.steepest_ = 5 * std::sqrt(square);
  surface.settle(start);
  return surface;
}

IrregularSurface IrregularSurface::ofHeights(const Irregularity& options, double start) {
  IrregularSurface surface;
  surface.curve_ = ProfileCurve(options.points, std::pow(10.0, options.offset / 20), false);
  surface.curve_.finish(options.position);
  const auto nodes = surface.curve_.points();
  // Slopes at the nodes are means of the chords beside them (MonotoneCubic.h): nowhere between is the curve more than
  // 1.5 times as steep as the steepest chord.
  for (std::size_t i = 1; i < nodes.size(); ++i)
    surface.steepest_ = std::max(surface.steepest_, 1.5 * std::abs((nodes[i].height - nodes[i - 1].height) /
                                                                   (nodes[i].position - nodes[i - 1].position)));
  surface.settle(start);
  return surface;
}

void IrregularSurface::settle(double start) {
  start_ = start;
  atStart_ = raw(start);
}

double IrregularSurface::raw(double x) const {
  if (!curve_.empty()) return curve_.at(x).height;
  double height = 0;
  for (const auto& h : harmonics_) height += h.amplitude * elementary::cos(h.wavenumber * x + h.phase);
  return height;
}

double IrregularSurface::height(double x) const {
  if (isSmooth()) return 0;
  const double grown = std::clamp((x - start_ - patch) / fade, 0.0, 1.0);
  if (grown == 0) return 0;
  return (raw(x) - atStart_) * 0.5 * (1 - elementary::cos(std::numbers::pi * grown));
}

}  // namespace squat::scenario
