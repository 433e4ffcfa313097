#include "receptance/ThirdOctaves.h"

#include <algorithm>
#include <cmath>

namespace squat::receptance {

const std::vector<double>& nominalThirdOctaves() {
  static const std::vector<double> nominal{50,  63,  80,   100,  125,  160,  200,  250,  315,  400, 500,
                                           630, 800, 1000, 1250, 1600, 2000, 2500, 3150, 4000, 5000};
  return nominal;
}

std::optional<double> nominalThirdOctave(double frequency) {
  constexpr double within = 0.03;
  const auto& all = nominalThirdOctaves();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](double nominal) { return std::abs(frequency - nominal) <= within * nominal; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

double middleOfThirdOctave(double nominal) { return std::pow(10, std::round(10 * std::log10(nominal)) / 10); }

ThirdOctaves thirdOctaves(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values) {
  constexpr double roundOff = 1e-9;
  ThirdOctaves bands;
  for (int n = -20; n <= 10; ++n) {
    const double middle = 1000 * std::pow(10, n / 10.0);
    const double from = middle / kThirdOctaveEdge, to = middle * kThirdOctaveEdge;
    if (from < frequency.front() * (1 - roundOff) || to > frequency.back() * (1 + roundOff)) continue;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < frequency.size(); ++i)
      if (frequency[i] >= from && frequency[i] < to) sum += std::norm(values[i]), ++count;
    if (count > 0) bands.band.push_back(middle), bands.value.push_back(std::sqrt(sum / count));
  }
  return bands;
}

}  // namespace squat::receptance
