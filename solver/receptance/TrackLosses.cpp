#include "receptance/TrackLosses.h"

#include <numbers>

#include "scenario/ComplexStiffness.h"
#include "scenario/Scenario.h"
#include "text/Numbers.h"

namespace squat::receptance {

namespace {

using scenario::padStiffness;
using scenario::ViscousEquivalent;
using scenario::viscousEquivalent;
using Complex = std::complex<double>;

double hertzOf(double omega) { return omega / (2 * std::numbers::pi); }

ComplexFactor constantLoss(double lossFactor) {
  if (lossFactor == 0) return {};
  return [lossFactor](double) { return Complex(1, lossFactor); };
}

ComplexFactor horizontalLoss(const scenario::Pad& pad) {
  if (pad.dynamic.empty()) return constantLoss(pad.lossFactor);
  if (pad.dynamic.front().lateral != 0.0)
    return [&pad](double omega) {
      return scenario::tabulatedStiffness(pad.dynamic, hertzOf(omega), &scenario::DynamicStiffness::lateral) /
             pad.lateralStiffness;
    };
  // Not measured: the stiffness of the case, with the loss factor that the vertical one has at this frequency.
  return [&pad](double omega) {
    const Complex k = padStiffness(pad, hertzOf(omega));
    return Complex(1, k.imag() / k.real());
  };
}

std::string note(const char* key, const ViscousEquivalent& near, double stiffness, double damping, const char* has) {
  return std::string(key) +
         " is used in the frequency domain only. The nearest spring and dashpot from 100 to 2000 Hz: " +
         text::formatted("%.4g MN/m", near.stiffness / 1e6) + " and " +
         text::formatted("%.3g kN s/m", near.damping / 1e3) +
         text::formatted(" (root mean square deviation %.0f %%)", 100 * near.misfit) + "; a rolling run uses " + has +
         " " + text::formatted("%.4g MN/m", stiffness / 1e6) + text::formatted(" and %.3g kN s/m", damping / 1e3);
}

}  // namespace

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

std::vector<std::string> lossNotes(const scenario::Scenario& scenario) {
  constexpr double lowest = scenario::kEquivalentFrom, highest = scenario::kEquivalentTo;
  std::vector<std::string> notes;
  const auto& pad = scenario.pad;
  if (!pad.dynamic.empty() || pad.lossFactor != 0)
    notes.push_back(note(pad.dynamic.empty() ? "pad.loss_factor" : "pad.dynamic",
                         viscousEquivalent([&](double f) { return padStiffness(pad, f); }, lowest, highest),
                         pad.stiffness, pad.damping, "pad.stiffness and pad.damping:"));
  if (!pad.dynamic.empty()) {
    notes.push_back("pad.dynamic reaches from " + text::formatted("%.0f Hz", pad.dynamic.front().frequency) + " to " +
                    text::formatted("%.0f Hz", pad.dynamic.back().frequency) +
                    "; beyond, the stiffness at its nearest frequency is used");
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
    notes.emplace_back(
        "rail.loss_factor and sleeper.loss_factor are used in the frequency domain only; a rolling run damps its "
        "solids by damping.fraction or damping.beta");
  return notes;
}

}  // namespace squat::receptance
