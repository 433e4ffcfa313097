#include "receptance/Receptance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "receptance/DecayRate.h"
#include "receptance/HarmonicResponse.h"
#include "receptance/TrackLosses.h"
#include "receptance/TrackSystem.h"

namespace squat::receptance {

scenario::Scenario receptanceCase(const scenario::Scenario& scenario) {
  auto d = scenario;
  const double spacing = d.track.sleeperSpacing;
  d.defectSurface = {};
  d.tread = {}, d.irregularity = {}, d.irregularityUnderSecond = {};
  d.bogie = {};
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

namespace {

std::vector<ReceptancePlace> placesOf(const ReceptanceOptions& options, const scenario::Scenario& scenario) {
  const double midspan = -scenario.track.sleeperSpacing / 2;
  auto places = options.places;
  if (places.empty()) places = {{"over a sleeper", 0, 0}, {"midspan", midspan, midspan}};
  const double reach = options.endless ? 100 : 0.5 * scenario.track.length;
  for (const auto& place : places)
    for (const double at : {place.struck, place.read})
      if (!(std::abs(at) <= reach))
        throw CaseError({{"track.length", std::to_string(scenario.track.length) + " m",
                          "such that the rail reaches to " + std::to_string(at) + " m from the sleeper in its middle",
                          "Lengthen the track, or take an endless one, which knows 100 m each way"}});
  return places;
}

// Equal steps, or on an endless track equal ratios, 24 to a third octave.
std::vector<double> frequenciesOf(const ReceptanceOptions& options) {
  std::vector<double> frequency;
  if (options.endless) {
    constexpr double perDecade = 240;
    const auto count = static_cast<int>(std::floor(perDecade * std::log10(options.highest / options.lowest) + 1e-9));
    for (int i = 0; i <= count; ++i) frequency.push_back(options.lowest * std::pow(10, i / perDecade));
    return frequency;
  }
  const auto count = static_cast<long>(std::floor((options.highest - options.lowest) / options.frequencyStep + 1e-9));
  for (long i = 0; i <= count; ++i)
    frequency.push_back(options.lowest + static_cast<double>(i) * options.frequencyStep);
  return frequency;
}

// Fills points, sizes and notes; false where it was cancelled.
bool solveEndless(const scenario::Scenario& scenario, const ReceptanceOptions& options, TrackReceptance& result,
                  Monitor& monitor) {
  EndlessTrackOptions endless;
  endless.rails = options.rails, endless.wholeSection = true, endless.threads = options.threads;
  endless.shapeTolerance = options.shapeTolerance;
  std::vector<PlaceResponse> wanted;
  for (const auto& point : result.points)
    wanted.push_back({{point.struck, point.direction}, {{point.read, point.direction}}});
  const auto response = endlessTrackResponse(scenario, result.frequency, wanted, endless, monitor);
  if (!response.complete) return false;
  for (std::size_t i = 0; i < wanted.size(); ++i) result.points[i].receptance = response.values[i].front();
  result.unknowns = response.unknowns, result.sectionShapes = response.sectionShapes;
  result.solutions = static_cast<int>(result.frequency.size());
  return true;
}

bool solveWholeTrack(const scenario::Scenario& own, const ReceptanceOptions& options, TrackReceptance& result,
                     Monitor& monitor) {
  constexpr int sleeperIntervals = 32;  // the third bending mode of the half sleepers lies near 1200 Hz
  const auto model = model::buildModel(own, sleeperIntervals);
  const auto shapes = railShapes(model, options.shapeTolerance);
  result.elements = model.blocks[model.rail].elements();
  for (int i = 0; i < model.sleepers; ++i) result.elements += model.blocks[model.firstSleeper + i].elements();
  result.sectionShapes = static_cast<int>(shapes.shapes.cols());
  ThreadTeam team(threadCount(options.threads));
  HarmonicOptions harmonic;
  harmonic.tolerance = options.accuracy;
  const auto ways = symmetriesOf(options.rails);
  for (auto& point : result.points) point.receptance.assign(result.frequency.size(), 0);
  for (const auto way : ways) {
    const TrackSystem track(model, shapes, way);
    result.unknowns = static_cast<std::size_t>(track.groups().unknowns());
    Eigen::MatrixXd loads(track.groups().unknowns(), static_cast<Eigen::Index>(result.points.size())), means = loads;
    for (Eigen::Index p = 0; p < loads.cols(); ++p) {
      const auto& place = result.points[static_cast<std::size_t>(p)];
      const bool vertical = place.direction == RailDirection::vertical;
      loads.col(p) = vertical ? track.load(place.struck) : track.headMean(place.struck, place.direction);
      means.col(p) = vertical ? track.sectionMean(place.read) : track.headMean(place.read, place.direction);
    }
    const auto response = harmonicResponse(track.terms(), loads, means, result.frequency, harmonic, team, monitor);
    if (response.cancelled) return false;
    for (std::size_t p = 0; p < result.points.size(); ++p)
      for (std::size_t f = 0; f < result.frequency.size(); ++f)
        result.points[p].receptance[f] += response.values[p][f] / static_cast<double>(ways.size());
    result.solutions += response.solutions;
    result.difference = std::max(result.difference, response.largestDifference);
    if (response.largestResidual > 1e-6)
      result.notes.push_back("a direct solution left a residual of " + std::to_string(response.largestResidual));
  }
  if (result.difference > options.accuracy)
    result.notes.push_back("between directly solved frequencies the receptance may err by " +
                           std::to_string(100 * result.difference) + " %");
  return true;
}

}  // namespace

namespace {

std::string howOf(const ReceptanceOptions& options) {
  const auto& places = options.places;
  const bool lateral = !places.empty() && places.front().direction == RailDirection::lateral;
  return std::string("track without wheelset, ") +
         (options.endless ? "endless, solved at every frequency; "
                          : "of the case's length, direct harmonic solution; ") +
         (options.rails == StruckRails::one ? "one rail struck; " : "both rails struck alike; ") +
         (lateral ? "force and displacement sideways, over the section of the rail's head"
                  : "force spread over 10 x 10 mm of the running surface, mean displacement of the section");
}

}  // namespace

TrackReceptance trackReceptance(const scenario::Scenario& scenario, const ReceptanceOptions& options,
                                Monitor& monitor) {
  const auto own = receptanceCase(scenario);
  TrackReceptance result;
  result.frequency = frequenciesOf(options);
  for (const auto& place : placesOf(options, own)) result.points.push_back({place, {}});
  result.notes = lossNotes(own);
  result.how = howOf(options);
  if (!(options.endless ? solveEndless : solveWholeTrack)(own, options, result, monitor)) return {};
  if (options.wheelset) result.modes = model::allWheelsetModes(scenario, options.highest, 3);
  result.complete = true;
  return result;
}

TrackReceptance sleeperByItself(const scenario::Scenario& scenario, const ReceptanceOptions& options,
                                Monitor& monitor) {
  TrackReceptance result;
  auto grid = options;
  grid.endless = true;
  result.frequency = frequenciesOf(grid);
  result.notes = lossNotes(scenario);
  result.how = std::string("sleeper on its ballast without pads, ") +
               (options.rails == StruckRails::one ? "one rail seat struck" : "both rail seats struck alike") +
               "; force and mean displacement over the footprint of a pad";
  PointReceptance seat;
  seat.name = "rail seat of a sleeper";
  seat.receptance = sleeperReceptance(scenario, result.frequency, options.rails, options.threads, monitor);
  if (seat.receptance.empty()) return {};
  result.points.push_back(std::move(seat));
  result.solutions = static_cast<int>(result.frequency.size());
  result.complete = true;
  return result;
}

const char* unitOf(ReceptanceQuantity quantity) {
  switch (quantity) {
    case ReceptanceQuantity::mobility:
      return "m/s/N";
    case ReceptanceQuantity::accelerance:
      return "m/s2/N";
    default:
      return "m/N";
  }
}

std::vector<std::complex<double>> asQuantity(const std::vector<double>& frequency,
                                             const std::vector<std::complex<double>>& receptance,
                                             ReceptanceQuantity quantity) {
  auto values = receptance;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int n = 0; n < static_cast<int>(quantity); ++n)
      values[i] *= std::complex<double>(0, 2 * std::numbers::pi * frequency[i]);
  return values;
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
