#include "receptance/Receptance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/StableStep.h"
#include "receptance/TrackImpulse.h"

namespace squat::receptance {

namespace {

// Fourier integral of evenly spaced samples that begin and end near zero.
std::complex<double> transform(const std::vector<double>& values, double step, double frequency) {
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * frequency * step);
  std::complex<double> sum = 0;
  for (auto value = values.rbegin(); value != values.rend(); ++value) sum = sum * turn + *value;  // Horner
  return sum * step;
}

std::string percent(double share) {
  const auto text = std::to_string(100 * share);
  return text.substr(0, text.find('.') + 4) + " %";
}

}  // namespace

cases::CaseDescription receptanceCase(const cases::CaseDescription& description) {
  auto d = description;
  const double spacing = d.track.sleeperSpacing;
  d.defect = {};
  d.track.defectFromSleeper = 0;  // x = 0 over a sleeper
  d.motion.runUp = spacing / 2;   // the other fine zone at midspan
  d.motion.beyond = spacing / 2;
  d.mesh.contactSize = 0.010;
  d.mesh.rollingSize = 0.025;
  d.mesh.farSize = std::min(d.mesh.farSize, 0.0375);
  d.mesh.sectionSize = std::max(d.mesh.sectionSize, 0.012);
  d.mesh.bandHalfWidth = 0.010;
  d.mesh.fineBefore = d.mesh.fineStart = 0.02;
  d.mesh.wheelSectors = 24;
  d.mesh.rimDepth = 0.020;
  d.rail.plastic = false;
  return d;
}

TrackReceptance trackReceptance(const cases::CaseDescription& description, const ReceptanceOptions& options,
                                Monitor& monitor) {
  const auto own = receptanceCase(description);
  const auto model = model::buildModel(own);
  const auto kernels = elasticity::kernelsFor(options.isa);
  ThreadTeam team(threadCount(options.threads));
  const auto stable = dynamics::stableStep(model, kernels, team, monitor);

  TrackReceptance result;
  result.step = stable.step;
  result.duration = options.duration;
  result.elements = model.blocks[model.rail].elements();
  for (int i = 0; i < model.sleepers; ++i) result.elements += model.blocks[model.firstSleeper + i].elements();
  const auto count = static_cast<long>(std::floor((options.highest - options.lowest) / options.frequencyStep + 1e-9));
  for (long i = 0; i <= count; ++i)
    result.frequency.push_back(options.lowest + static_cast<double>(i) * options.frequencyStep);

  ImpulseOptions impulse;
  impulse.step = stable.step;
  impulse.beta = stable.beta;
  impulse.duration = options.duration;
  const double middle = -own.track.sleeperSpacing / 2;
  for (const auto& [name, position] : {std::pair{"over a sleeper", 0.0}, std::pair{"midspan", middle}}) {
    const auto record = strikeTrack(model, kernels, team, position, impulse, monitor);
    if (record.cancelled) return result;
    PointReceptance point{name, position, {}, record.left};
    for (const double f : result.frequency)
      point.receptance.push_back(transform(record.response, record.sampleStep, f) /
                                 transform(record.force, record.forceStep, f));
    if (record.left > 1e-3)
      result.notes.push_back(std::string(name) + ": " + percent(record.left) +
                             " of the largest response is left at the end of the record; ask for a longer duration");
    result.points.push_back(std::move(point));
  }
  if (options.wheelset) result.modes = model::wheelsetModes(description, options.highest, 3);
  result.complete = true;
  return result;
}

std::vector<double> resonances(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values) {
  std::vector<double> level, found;
  for (const auto& value : values) level.push_back(20 * std::log10(std::abs(value)));
  for (std::size_t i = 1; i + 1 < level.size(); ++i) {
    if (!(level[i] > level[i - 1] && level[i] >= level[i + 1])) continue;
    double left = level[i], right = level[i];
    for (std::size_t k = i; k-- > 0 && level[k] <= level[i];) left = std::min(left, level[k]);
    for (std::size_t k = i + 1; k < level.size() && level[k] <= level[i]; ++k) right = std::min(right, level[k]);
    if (level[i] - std::max(left, right) < 1) continue;
    const double curve = level[i - 1] - 2 * level[i] + level[i + 1];
    const double shift = curve < 0 ? 0.5 * (level[i - 1] - level[i + 1]) / curve : 0.0;
    found.push_back(frequency[i] + shift * (frequency[i + 1] - frequency[i]));
  }
  return found;
}

}  // namespace squat::receptance
