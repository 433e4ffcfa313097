#include "receptance/TrackLosses.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "scenario/Scenario.h"
#include "text/Numbers.h"

namespace squat::receptance {

namespace {

using Complex = std::complex<double>;

double hertzOf(double omega) { return omega / (2 * std::numbers::pi); }

ComplexFactor constantLoss(double lossFactor) {
  if (lossFactor == 0) return {};
  return [lossFactor](double) { return Complex(1, lossFactor); };
}

// Linear in the logarithm of the frequency; as at its ends beyond them.
template <typename Member>
Complex tabulated(const std::vector<scenario::DynamicStiffness>& table, double frequency, Member member) {
  const auto next = std::lower_bound(table.begin(), table.end(), frequency,
                                     [](const auto& row, double f) { return row.frequency < f; });
  if (next == table.begin()) return table.front().*member;
  if (next == table.end()) return table.back().*member;
  const auto before = next - 1;
  const double share = std::log(frequency / before->frequency) / std::log(next->frequency / before->frequency);
  return (1 - share) * ((*before).*member) + share * ((*next).*member);
}

ComplexFactor horizontalLoss(const scenario::Pad& pad) {
  if (pad.dynamic.empty()) return constantLoss(pad.lossFactor);
  if (pad.dynamic.front().lateral != 0.0)
    return [&pad](double omega) {
      return tabulated(pad.dynamic, hertzOf(omega), &scenario::DynamicStiffness::lateral) / pad.lateralStiffness;
    };
  // Not measured: the stiffness of the case, with the loss factor that the vertical one has at this frequency.
  return [&pad](double omega) {
    const Complex k = padStiffness(pad, hertzOf(omega));
    return Complex(1, k.imag() / k.real());
  };
}

std::string note(const char* key, const ViscousEquivalent& near, double stiffness, double damping, const char* has) {
  return std::string(key) + " acts in the frequency domain alone. Nearest to it from 100 to 2000 Hz: " +
         text::formatted("%.4g MN/m", near.stiffness / 1e6) + " with " +
         text::formatted("%.3g kN s/m", near.damping / 1e3) +
         text::formatted(", %.0f %% off in the mean", 100 * near.misfit) + "; a rolling run has " + has + " " +
         text::formatted("%.4g MN/m", stiffness / 1e6) + text::formatted(" with %.3g kN s/m", damping / 1e3);
}

}  // namespace

Complex padStiffness(const scenario::Pad& pad, double frequency) {
  if (pad.dynamic.empty()) return pad.stiffness * Complex(1, pad.lossFactor);
  return tabulated(pad.dynamic, frequency, &scenario::DynamicStiffness::vertical);
}

std::array<ComplexFactor, trackParts> trackLosses(const scenario::Scenario& scenario) {
  std::array<ComplexFactor, trackParts> losses;
  const auto of = [&](TrackPart part) -> ComplexFactor& { return losses[static_cast<std::size_t>(part)]; };
  of(TrackPart::rail) = constantLoss(scenario.rail.lossFactor);
  of(TrackPart::sleepers) = constantLoss(scenario.sleeper.lossFactor);
  of(TrackPart::ballast) = constantLoss(scenario.ballast.lossFactor);
  const auto& pad = scenario.pad;
  of(TrackPart::padsVertical) = constantLoss(pad.lossFactor);
  if (!pad.dynamic.empty())
    of(TrackPart::padsVertical) = [&pad](double omega) { return padStiffness(pad, hertzOf(omega)) / pad.stiffness; };
  of(TrackPart::padsHorizontal) = horizontalLoss(pad);
  return losses;
}

// Minimises the sum of |k + i w c - K|^2 / |K|^2: real and imaginary part fall apart.
ViscousEquivalent viscousEquivalent(const std::function<Complex(double frequency)>& stiffness, double lowest,
                                    double highest) {
  constexpr int steps = 60;
  double one = 0, real = 0, square = 0, imaginary = 0;
  const auto frequencyAt = [&](int i) { return lowest * std::pow(highest / lowest, static_cast<double>(i) / steps); };
  for (int i = 0; i <= steps; ++i) {
    const double omega = 2 * std::numbers::pi * frequencyAt(i);
    const Complex k = stiffness(frequencyAt(i));
    const double weight = 1 / std::norm(k);
    one += weight, real += weight * k.real();
    square += weight * omega * omega, imaginary += weight * omega * k.imag();
  }
  ViscousEquivalent found{real / one, imaginary / square, 0};
  for (int i = 0; i <= steps; ++i) {
    const Complex k = stiffness(frequencyAt(i));
    const Complex near(found.stiffness, 2 * std::numbers::pi * frequencyAt(i) * found.damping);
    found.misfit += std::norm(near - k) / std::norm(k) / (steps + 1);
  }
  found.misfit = std::sqrt(found.misfit);
  return found;
}

std::vector<std::string> lossNotes(const scenario::Scenario& scenario) {
  constexpr double lowest = 100, highest = 2000;  // [Hz]
  std::vector<std::string> notes;
  const auto& pad = scenario.pad;
  if (!pad.dynamic.empty() || pad.lossFactor != 0)
    notes.push_back(note(pad.dynamic.empty() ? "pad.loss_factor" : "pad.dynamic",
                         viscousEquivalent([&](double f) { return padStiffness(pad, f); }, lowest, highest),
                         pad.stiffness, pad.damping, "pad.stiffness and pad.damping:"));
  if (!pad.dynamic.empty()) {
    notes.push_back("pad.dynamic reaches from " + text::formatted("%.0f Hz", pad.dynamic.front().frequency) + " to " +
                    text::formatted("%.0f Hz", pad.dynamic.back().frequency) +
                    "; beyond, the stiffness of its nearest frequency is taken");
    if (pad.dynamic.front().lateral == 0.0)
      notes.push_back(
          "pad.dynamic has no lateral stiffness: pad.lateral_stiffness and pad.longitudinal_stiffness are "
          "taken, with the loss factor of the vertical one");
  }
  const auto& ballast = scenario.ballast;
  if (ballast.lossFactor != 0)
    notes.push_back(note(
        "ballast.loss_factor",
        viscousEquivalent([&](double) { return ballast.stiffness * Complex(1, ballast.lossFactor); }, lowest, highest),
        ballast.stiffness, ballast.damping, "ballast.stiffness and ballast.damping:"));
  if (scenario.rail.lossFactor != 0 || scenario.sleeper.lossFactor != 0)
    notes.push_back(
        "rail.loss_factor and sleeper.loss_factor act in the frequency domain alone; a rolling run damps its "
        "solids by damping.fraction or damping.beta");
  return notes;
}

}  // namespace squat::receptance
