#include "growth/StageFigures.h"

#include <algorithm>
#include <cmath>

#include "case/Resolve.h"
#include "growth/LayerChange.h"
#include "growth/Shape.h"

namespace squat::growth {

namespace {

void describeShape(const RollingTraffic& traffic, const GrowthState& rail, Stage& stage) {
  const auto& grid = traffic.grid();
  const double y = traffic.line();
  const auto heights = lineAt(grid, traffic.heightsOf(rail), y), change = lineAt(grid, traffic.changeOf(rail), y);
  const Dip dip = dipOf(grid.x, heights);
  stage.depth = dip.depth, stage.deepest = dip.place, stage.length = dip.length;
  const double end = traffic.model().scenario.defectSurface.last();
  const Wave wave = strongestWave(waveSpectrum(grid.x, change, end, grid.x.back() - grid.taper));
  stage.waveLength = wave.length, stage.waveHeight = wave.height;
  const auto at = static_cast<std::size_t>(std::lower_bound(grid.x.begin(), grid.x.end(), dip.place) - grid.x.begin());
  stage.wear = -lineAt(grid, rail.wear, y)[at], stage.flow = -lineAt(grid, rail.flow, y)[at];
  stage.wearAround = -referenceHeight(grid, rail.wear, y), stage.flowAround = -referenceHeight(grid, rail.flow, y);
}

void describeStrain(const model::Model& model, const GrowthState& rail, Stage& stage) {
  const auto& layer = model.layer;
  if (layer.empty()) return;
  const auto strain = elementStrain(layer, rail.layer);
  const auto depth = elementDepth(layer, model.blocks[model.rail], model.scenario.rail.section);
  for (std::size_t i = 0; i < strain.size(); ++i) {
    if (strain[i] > stage.largestStrain) stage.largestStrain = strain[i], stage.strainDepth = depth[i];
    if (strain[i] > strainedFrom)
      stage.strainedDepth = std::max(stage.strainedDepth, depth[i] + 0.5 * model.scenario.mesh.contactSize);
  }
}

}  // namespace

Stage stageOf(const RollingTraffic& traffic, const GrowthState& rail, const Passage& passage) {
  Stage stage;
  stage.tonnage = rail.tonnage, stage.passages = rail.passages;
  stage.block = rail.stages.empty() ? 0 : rail.passages - rail.stages.back().passages;
  describeShape(traffic, rail, stage);
  describeStrain(traffic.model(), rail, stage);
  stage.largestForce = passage.largestForce, stage.smallestForce = passage.smallestForce;
  for (std::size_t i = 0; i < passage.position.size(); ++i)
    if (passage.position[i] > traffic.grid().x.front())
      stage.peakAcceleration = std::max(stage.peakAcceleration, std::abs(passage.acceleration[i]));
  return stage;
}

DefectExtent extentOf(const cases::CaseDescription& description) {
  const auto scenario = cases::resolve(description);
  return {scenario.defectSurface.first(), scenario.defectSurface.last(), contact::seatOf(scenario).touchY};
}

}  // namespace squat::growth
