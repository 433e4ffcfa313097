#include "model/BuildBlocks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "contact/ContactSurfaces.h"
#include "core/ElementaryFunctions.h"
#include "core/Errors.h"
#include "elasticity/SectionClusters.h"
#include "geometry/RailSection.h"
#include "geometry/WheelSection.h"
#include "scenario/DefectZone.h"
#include "scenario/SleeperHeight.h"
#include "scenario/TrackCentre.h"

namespace squat::model {

namespace {

constexpr int vectorMultiple = 8;      // every run of stations fills whole vectors of any instruction set
constexpr double runGrowth = 2.0;      // neighbouring runs differ by at most this factor
constexpr double patchMargin = 0.020;  // [m] rolled mesh before the first and behind the last wheel position
constexpr double patchEnd = 0.030;     // [m] behind the last one, as requested

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) values.push_back(from + (to - from) * i / count);
  return values;
}

geometry::SectionMesh rectangleMesh(const std::vector<double>& b, const std::vector<double>& c) {
  geometry::SectionMesh mesh;
  const int n = static_cast<int>(b.size());
  for (const double atC : c)
    for (const double atB : b) mesh.nodes.push_back({atB, atC});
  for (int j = 0; j + 1 < static_cast<int>(c.size()); ++j)
    for (int i = 0; i + 1 < n; ++i)
      mesh.quads.push_back({j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
  return mesh;
}

// Short waves of rail and rim get more inertia, but those of tied nodes, which have none of their own.
void scaleMassesOfShortWaves(const scenario::Scenario& d, elasticity::SweptBlock& block, double shortLength,
                             const std::function<bool(int)>& mayJoin) {
  if (!d.mesh.selectiveMassScaling) return;
  elasticity::prepareBlock(block);
  block.clusters = elasticity::sectionClusters(block, mayJoin);
  block.shortLength = shortLength;
}

}  // namespace

// The kernels go through memory from front to back: section nodes stand in the order in which they are visited.
void append(Model& model, elasticity::SweptBlock block) {
  elasticity::numberAsVisited(block.section, block.clusters);
  elasticity::prepareBlock(block);
  block.offset = model.stateSize;
  model.stateSize += block.size();
  model.blocks.push_back(std::move(block));
}

namespace {

// Where the fine zone of the defect begins, at or behind that of the start [m].
double fineStart(const scenario::Scenario& d) {
  const double before = scenario::defectZone(d.defectSurface, d.tread, d.mesh).before;
  return std::max(-d.motion.runUp - d.mesh.fineStart, -before - d.mesh.fineBefore);
}

// The rim rolls with the stations of the rail; the rest of the circumference is coarser.
geometry::Stations rimStations(const scenario::Scenario& d, const RollingStretch& stretch, double startX) {
  const double radius = d.wheelset.radius, circumference = 2 * std::numbers::pi * radius;
  const double rolled = stretch.to - stretch.from, rest = circumference - rolled;
  const double coarse = std::max(4 * d.mesh.sectionSize, 2 * d.mesh.rollingSize);
  if (rest < 0.1 * circumference)
    throw CaseError(
        {{"motion.beyond", std::to_string(d.motion.beyond) + " m",
          "run-up and distance beyond the defect together up to " +
              std::to_string(0.9 * circumference - (rolled - d.motion.runUp - d.motion.beyond)) + " m for this wheel",
          "Shorten motion.run_up, motion.beyond or mesh.fine_start: the wheel is meshed for less than one "
          "turn"}});
  geometry::Stations stations;
  stations.closed = true;
  stations.start = (stretch.from - startX) / radius;
  auto runs = stretch.rolled;
  const auto filling =
      geometry::fillGap(rest, coarse, runs.back().length, runs.front().length, runGrowth, vectorMultiple);
  runs.insert(runs.end(), filling.begin(), filling.end());
  for (auto& run : runs) run.length /= radius;
  stations.runs = runs;
  return stations;
}

}  // namespace

void addSleepers(Model& model, int intervals) {
  const auto& d = model.scenario;
  const bool tiny = d.mesh.preset == scenario::MeshPreset::tiny;
  model.firstSleeper = static_cast<int>(model.blocks.size());
  model.sleepers = static_cast<int>(model.sleeperPositions.size());
  const int lengthwise = intervals > 0 ? intervals : tiny ? 8 : 16;
  const auto extent = scenario::sleeperHeightShares(d, evenly(0, d.sleeper.halfLength, lengthwise));
  for (int i = 0; i < model.sleepers; ++i) {
    elasticity::SweptBlock sleeper;
    sleeper.name = "sleeper " + std::to_string(i + 1);
    sleeper.kind = elasticity::SweepKind::alongY;
    sleeper.section =
        rectangleMesh(evenly(-d.sleeper.height, 0, 2), evenly(-d.sleeper.width / 2, d.sleeper.width / 2, tiny ? 2 : 3));
    sleeper.stations = {-d.wheelset.trackCentre, false, {{lengthwise, d.sleeper.halfLength / lengthwise}}};
    sleeper.material = d.sleeper.material;
    sleeper.extent = extent;
    sleeper.origin = {model.sleeperPositions[i], 0,
                      -geometry::railProfile(d.rail.section).height * elementary::cos(model.blocks[model.rail].lean)};
    append(model, std::move(sleeper));
  }
}

elasticity::SweptBlock railBlock(const scenario::Scenario& d) {
  elasticity::SweptBlock rail;
  rail.name = "rail";
  rail.section = geometry::railSectionMesh(
      d.rail.section,
      {d.mesh.contactSize, d.mesh.bandHalfWidth, d.mesh.sectionSize, d.mesh.sectionGrowth, d.mesh.coarseWeb});
  rail.material = d.rail.material;
  rail.lean = contact::seatOf(d).lean;
  return rail;
}

namespace {

// Stations of the rail with a fine zone that ends at `fineTo`, in groups of `whole`.
RollingStretch laidStretch(const scenario::Scenario& d, double railStart, double railEnd, double fineTo, int whole) {
  const double start = -d.motion.runUp, end = d.motion.beyond + patchEnd;
  const double fineFrom = fineStart(d), startTo = start + d.mesh.fineStart;
  const double h = d.mesh.contactSize, rolling = d.mesh.rollingSize, far = d.mesh.farSize;
  std::vector<geometry::Zone> zones;
  const auto layPathOfSecond = [&] {
    zones.push_back({start + d.bogie.offset() - secondPathMargin, far, whole});
    zones.push_back({d.motion.beyond + d.bogie.offset() + secondPathMargin, std::min(far, secondPathSize), whole});
  };
  if (d.bogie.offset() < 0) layPathOfSecond();
  zones.push_back({start - std::max(d.mesh.fineStart, patchMargin), far, whole});
  if (startTo + 8 * rolling < fineFrom) {
    zones.push_back({startTo, h, whole});
    zones.push_back({fineFrom, rolling, whole});
  }
  zones.push_back({std::min(fineTo, end), h, whole});
  if (fineTo + 4 * rolling < end) zones.push_back({end, rolling, whole});
  if (d.bogie.offset() > 0) layPathOfSecond();
  zones.push_back({railEnd, far});
  RollingStretch stretch;
  stretch.rail = geometry::stationsOver(railStart, zones, runGrowth, vectorMultiple);
  // The rolled runs: all of at most the rolling length around the wheel's path.
  double at = railStart;
  bool first = true;
  for (const auto& run : stretch.rail.runs) {
    const double next = at + run.count * run.length;
    if (next > start - 1e-9 - patchMargin / 2 && at < end - patchMargin / 2 &&
        run.length < 1.01 * std::max(rolling, h)) {
      if (first) stretch.from = at, first = false;
      stretch.to = next;
      stretch.rolled.push_back(run);
    }
    at = next;
  }
  return stretch;
}

}  // namespace

RollingStretch rollingStretch(const scenario::Scenario& d, double railStart, double railEnd) {
  const double end = d.motion.beyond + patchEnd;
  const double behind = scenario::defectZone(d.defectSurface, d.tread, d.mesh).behind;
  const double fineTo = std::max(behind + d.mesh.fineBefore, fineStart(d) + d.mesh.contactSize);
  // Fine stations share their inertia in whole groups, which begin at whole groups from the rail's end: the time step
  // is as long as the smallest group of the finest allows. The tiny mesh has no elements to spare for that.
  const bool tiny = d.mesh.preset == scenario::MeshPreset::tiny;
  for (int whole = tiny ? vectorMultiple : elasticity::maximumStations; whole >= vectorMultiple; whole /= 2) {
    RollingStretch stretch = laidStretch(d, railStart, railEnd, fineTo, whole);
    // Where nothing is laid between fine zone and far rail, the fine zone reaches as far as the wheel rolls.
    if (stretch.to < d.motion.beyond + patchMargin / 2 && fineTo < end)
      stretch = laidStretch(d, railStart, railEnd, end, whole);
    // Zones grow by rounding; on a short rail they can push each other over its end.
    const double reached = stretch.rail.positions().back();
    if (std::abs(reached - railEnd) < 1e-6 && !stretch.rolled.empty()) return stretch;
  }
  throw CaseError({{"track.length", std::to_string(d.track.length) + " m",
                    "such that fine, rolled and far elements find room beside each other",
                    "Lengthen track.length, or lower mesh.fine_start, mesh.rolling_size or mesh.far_size"}});
}

RollingStretch addBlocks(Model& model, int sleeperIntervals) {
  const auto& d = model.scenario;
  model.startX = -d.motion.runUp;
  // The rail is centred on the sleeper nearest to the middle of the rolled stretch.
  const double centre = scenario::trackCentre(d.track, d.motion), spacing = d.track.sleeperSpacing;
  const double railStart = centre - d.track.length / 2, railEnd = centre + d.track.length / 2;
  const auto sleepers = scenario::sleepersOf(d.track, d.pad, d.motion);
  const int each = (sleepers.last - sleepers.first) / 2;
  for (int i = -each; i <= each; ++i) model.sleeperPositions.push_back(centre + i * spacing);

  RollingStretch stretch = rollingStretch(d, railStart, railEnd);
  elasticity::SweptBlock rail = railBlock(d);
  rail.stations = stretch.rail;
  const contact::WheelSeat seat = contact::seatOf(d);
  model.rail = 0;
  const double rolled = 1.02 * std::max(d.mesh.rollingSize, 2 * d.mesh.contactSize);  // rolled over, or next to it
  scaleMassesOfShortWaves(d, rail, rolled, [](int) { return true; });
  append(model, std::move(rail));

  const geometry::WheelSectionSizes sizes{d.mesh.contactSize,   d.mesh.bandHalfWidth, d.mesh.sectionSize,
                                          d.mesh.sectionGrowth, d.mesh.rimDepth,      seat.treadSlope};
  elasticity::SweptBlock rim;
  rim.name = "wheel rim";
  rim.kind = elasticity::SweepKind::aroundAxis;
  rim.section = geometry::rimSectionMesh(d.wheelset, sizes);
  rim.stations = rimStations(d, stretch, model.startX);
  rim.material = d.wheelset.material;
  rim.origin = {model.startX, seat.wheelY, seat.centreHeight};
  model.rim = 1;
  const double tied = d.wheelset.radius - d.mesh.rimDepth + 1e-9;
  scaleMassesOfShortWaves(d, rim, rolled / d.wheelset.radius,
                          [&](int node) { return rim.section.nodes[node][0] > tied; });
  append(model, std::move(rim));

  elasticity::SweptBlock body;
  body.name = "wheel body and axle";
  body.kind = elasticity::SweepKind::aroundAxis;
  body.section = geometry::wheelBodySectionMesh(d.wheelset, sizes);
  const int sectors = (d.mesh.wheelSectors + 7) / 8 * 8;
  body.stations = {0, true, {{sectors, 2 * std::numbers::pi / sectors}}};
  body.material = d.wheelset.material;
  body.origin = {model.startX, seat.wheelY, seat.centreHeight};
  model.body = 2;
  append(model, std::move(body));
  addSleepers(model, sleeperIntervals);
  return stretch;
}

}  // namespace squat::model
