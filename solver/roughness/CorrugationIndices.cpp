#include "roughness/CorrugationIndices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "signals/FourierTransform.h"
#include "signals/Window.h"

namespace squat::roughness {

namespace {

constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t cellsInWindow = 4;

}  // namespace

const std::array<CorrugationBand, 4>& corrugationBands() {
  static const std::array<CorrugationBand, 4> bands{{{0.010, 0.030}, {0.030, 0.100}, {0.100, 0.300}, {0.300, 1.000}}};
  return bands;
}

void CorrugationGauge::add(double height, double way) {
  open_.square += height * height * way, open_.way += way;
  square_ += height * height * way, way_ += way, at_ += way;
  if (open_.way < band_.window() / cellsInWindow) return;
  open_.end = at_;
  cells_.push_back(open_);
  open_ = {};
}

void CorrugationGauge::skip(double way) {
  open_ = {0, 0, 0, true};
  at_ += way;
}

CorrugationIndex CorrugationGauge::index() const {
  CorrugationIndex index;
  index.band = band_;
  index.rms = way_ > 0 ? std::sqrt(square_ / way_) : notKnown;
  index.typical = index.exceeded = index.largest = index.largestAt = notKnown;
  std::vector<double> moving;
  std::size_t row = 0;  // cells one behind the other
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    row = cells_[i].first ? 1 : row + 1;
    if (row < cellsInWindow) continue;
    double square = 0, way = 0;
    for (std::size_t k = i + 1 - cellsInWindow; k <= i; ++k) square += cells_[k].square, way += cells_[k].way;
    const double rms = std::sqrt(square / way);
    if (moving.empty() || rms > index.largest) index.largest = rms, index.largestAt = cells_[i].end - 0.5 * way;
    moving.push_back(rms);
  }
  index.windows = moving.size();
  if (moving.empty()) return index;
  std::sort(moving.begin(), moving.end());
  index.typical = moving[moving.size() / 2];
  index.exceeded =
      moving[std::min(moving.size() - 1, static_cast<std::size_t>(0.95 * static_cast<double>(moving.size())))];
  return index;
}

double passedByBand(const CorrugationBand& band, double wavelength) {
  // In the logarithm of the wavelength, a cosine over a sixth of an octave about each limit.
  const double width = std::log(2.0) / 6;
  const auto edge = [&](double inside) {
    return std::sin(0.5 * std::numbers::pi * std::clamp(0.5 + inside / width, 0.0, 1.0));
  };
  const double rise = edge(std::log(wavelength / band.shortest)), fall = edge(std::log(band.longest / wavelength));
  return rise * fall;
}

std::vector<CorrugationIndex> corrugationIndices(const std::vector<double>& heights, double spacing) {
  std::vector<CorrugationIndex> indices;
  const std::size_t n = heights.size();
  auto level = heights;
  signals::removeTrend(level.data(), n, signals::Detrend::linear);
  const signals::ComplexTransform forward(n, signals::Direction::forward), backward(n, signals::Direction::backward);
  std::vector<signals::Complex> spectrum(level.begin(), level.end());
  forward.inPlace(spectrum.data());
  for (const auto& band : corrugationBands()) {
    auto passed = spectrum;
    for (std::size_t k = 0; k < n; ++k) {
      const auto cycles = static_cast<double>(std::min(k, n - k));
      passed[k] *=
          k == 0 ? 0.0 : passedByBand(band, static_cast<double>(n) * spacing / cycles) / static_cast<double>(n);
    }
    backward.inPlace(passed.data());
    CorrugationGauge gauge(band);
    for (const auto& value : passed) gauge.add(value.real(), spacing);
    indices.push_back(gauge.index());
  }
  return indices;
}

}  // namespace squat::roughness
