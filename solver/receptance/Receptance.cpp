#include "receptance/Receptance.h"

#include <algorithm>
#include <cmath>

#include "receptance/DynamicPads.h"
#include "receptance/HarmonicResponse.h"
#include "receptance/TrackSystem.h"

namespace squat::receptance {

namespace {

constexpr double loadedSquare = 0.010;  // [m]

}  // namespace

scenario::Scenario receptanceCase(const scenario::Scenario& scenario) {
  auto d = scenario;
  const double spacing = d.track.sleeperSpacing;
  d.defectSurface = {};
  d.defectModel = scenario::DefectModel::gapFunction;
  d.track.defectFromSleeper = 0;  // x = 0 over a sleeper
  d.motion.runUp = spacing / 2;   // the other fine zone at midspan
  d.motion.beyond = spacing / 2;
  d.motion.lateralOffset = 0;
  d.mesh.contactSize = 0.020;
  d.mesh.rollingSize = 0.025;
  d.mesh.farSize = std::min(d.mesh.farSize, 0.05);
  d.mesh.sectionSize = std::max(d.mesh.sectionSize, 0.012);
  d.mesh.bandHalfWidth = 0.020;
  d.mesh.fineBefore = d.mesh.fineStart = 0.02;
  d.mesh.wheelSectors = 24;
  d.mesh.rimDepth = std::min(0.020, 0.4 * (d.wheelset.radius - d.wheelset.rimInnerRadius));
  d.rail.plastic = false;
  return d;
}

TrackReceptance trackReceptance(const scenario::Scenario& scenario, const ReceptanceOptions& options,
                                Monitor& monitor) {
  const auto own = withDynamicPads(receptanceCase(scenario));
  constexpr int sleeperIntervals = 32;  // the third bending mode of the half sleepers lies near 1200 Hz
  const auto model = model::buildModel(own, sleeperIntervals);
  const auto shapes = railShapes(model, options.shapeTolerance);
  const TrackSystem track(model, shapes);

  TrackReceptance result;
  result.elements = model.blocks[model.rail].elements();
  for (int i = 0; i < model.sleepers; ++i) result.elements += model.blocks[model.firstSleeper + i].elements();
  result.unknowns = static_cast<std::size_t>(track.groups().unknowns());
  result.sectionShapes = static_cast<int>(shapes.shapes.cols());
  const auto count = static_cast<long>(std::floor((options.highest - options.lowest) / options.frequencyStep + 1e-9));
  for (long i = 0; i <= count; ++i)
    result.frequency.push_back(options.lowest + static_cast<double>(i) * options.frequencyStep);

  const double positions[2] = {0.0, -own.track.sleeperSpacing / 2};
  Eigen::MatrixXd loads(track.groups().unknowns(), 2), means = loads;
  for (int p = 0; p < 2; ++p) {
    loads.col(p) = track.load(positions[p], loadedSquare);
    means.col(p) = track.sectionMean(positions[p]);
  }
  ThreadTeam team(threadCount(options.threads));
  HarmonicOptions harmonic;
  harmonic.tolerance = options.accuracy;
  const auto response = harmonicResponse(track.terms(), loads, means, result.frequency, harmonic, team, monitor);
  if (response.cancelled) return result;
  result.points = {{"over a sleeper", positions[0], response.values[0]}, {"midspan", positions[1], response.values[1]}};
  result.solutions = response.solutions;
  result.difference = response.largestDifference;
  if (response.largestDifference > options.accuracy)
    result.notes.push_back("between directly solved frequencies the receptance may err by " +
                           std::to_string(100 * response.largestDifference) + " %");
  if (response.largestResidual > 1e-6)
    result.notes.push_back("a direct solution left a residual of " + std::to_string(response.largestResidual));
  if (options.wheelset) result.modes = model::wheelsetModes(scenario, options.highest, 3);
  result.complete = true;
  return result;
}

std::vector<double> resonances(const std::vector<double>& frequency, const std::vector<std::complex<double>>& values,
                               double minimum) {
  std::vector<double> level, found;
  for (const auto& value : values) level.push_back(20 * std::log10(std::abs(value)));
  for (std::size_t i = 1; i + 1 < level.size(); ++i) {
    if (!(level[i] > level[i - 1] && level[i] >= level[i + 1])) continue;
    double left = level[i], right = level[i];
    for (std::size_t k = i; k-- > 0 && level[k] <= level[i];) left = std::min(left, level[k]);
    for (std::size_t k = i + 1; k < level.size() && level[k] <= level[i]; ++k) right = std::min(right, level[k]);
    if (level[i] - std::max(left, right) < minimum) continue;
    const double curve = level[i - 1] - 2 * level[i] + level[i + 1];
    const double shift = curve < 0 ? 0.5 * (level[i - 1] - level[i + 1]) / curve : 0.0;
    found.push_back(frequency[i] + shift * (frequency[i + 1] - frequency[i]));
  }
  return found;
}

}  // namespace squat::receptance
