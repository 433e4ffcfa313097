#include "calibration/DecayResiduals.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"

namespace squat::calibration {

namespace {

bool isWanted(const DecayTarget& target, double band) { return band >= target.lowest && band <= target.highest; }

// Whether a third octave gives a residual.
bool counts(const receptance::MeasuredDecay& at) { return at.count > 0 && at.mean > 0; }

}  // namespace

MeasuredDecays readMeasuredDecays(const DecayTarget& target) {
  MeasuredDecays measured{target, receptance::readMeasuredDecayRates(target.file)};
  const auto& rates = measured.rates;
  bool any = false;
  for (std::size_t b = 0; b < rates.band.size(); ++b)
    any = any || (isWanted(target, rates.band[b]) && (counts(rates.vertical[b]) || counts(rates.lateral[b])));
  if (!any)
    throw FileError(target.file, "", "has no decay rate above 0 within the limits of the target",
                    "Change \"lowest\" and \"highest\" [Hz]");
  return measured;
}

TargetValue decayValue(const MeasuredDecays& measured, const receptance::DecayRates& computed) {
  TargetValue value;
  double sum = 0;
  for (std::size_t b = 0; b < computed.band.size(); ++b) {
    if (!isWanted(measured.target, computed.band[b])) continue;
    for (const auto direction : {receptance::RailDirection::vertical, receptance::RailDirection::lateral}) {
      const auto at = measured.rates.at(computed.band[b], direction);
      if (!counts(at)) continue;
      const double rate = direction == receptance::RailDirection::vertical ? computed.vertical[b] : computed.lateral[b];
      const double spread = at.lowest > 0 ? 5 * std::log10(at.highest / at.lowest) : 0;
      value.residuals.push_back(10 * std::log10(rate / at.mean) / std::max(measured.target.tolerance, spread));
    }
  }
  for (const double residual : value.residuals) sum += residual * residual;
  value.misfit = value.residuals.empty() ? 0 : sum / static_cast<double>(value.residuals.size());
  value.value = std::sqrt(value.misfit);
  value.isMet = *value.value <= 1.5;
  return value;
}

}  // namespace squat::calibration
