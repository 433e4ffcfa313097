#include "analysis/RunFeatures.h"

#include <algorithm>
#include <cmath>

#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"

namespace squat::analysis {

signals::Features runFeatures(const signals::Record& record, const signals::FeatureOptions& options,
                              const std::string& channel) {
  return signals::features(signals::passageOf(record, channel), options);
}

RunDigest runDigest(const signals::Record& record) {
  RunDigest digest;
  const auto* values = record.signal(signals::names::axleBoxFiltered);
  if (!values) return digest;
  for (const double value : *values)
    if (std::isfinite(value)) digest.peak = std::max(digest.peak, std::abs(value));
  try {
    const signals::FeatureOptions usual;
    const auto spectrum = signals::stretchSpectrum(signals::passageOf(record, signals::names::axleBoxFiltered),
                                                   -usual.before, usual.after);
    for (const auto& line : signals::namedLines(spectrum)) digest.lines.push_back(line.frequency);
  } catch (const signals::SignalError&) {
    // Too short, or it ends before the defect: no lines.
  }
  return digest;
}

}  // namespace squat::analysis
