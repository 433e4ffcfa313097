#include "growth/GrowthState.h"

#include <array>
#include <cstddef>

namespace squat::growth {

namespace {

// Every number of a stage, in the order in which it is kept.
constexpr std::array<double Stage::*, 18> numbers = {
    &Stage::tonnage,      &Stage::passages,      &Stage::block,           &Stage::depth,       &Stage::deepest,
    &Stage::length,       &Stage::waveLength,    &Stage::waveHeight,      &Stage::wear,        &Stage::flow,
    &Stage::wearAround,   &Stage::flowAround,    &Stage::largestStrain,   &Stage::strainDepth, &Stage::strainedDepth,
    &Stage::largestForce, &Stage::smallestForce, &Stage::peakAcceleration};

std::vector<double> plain(const AlignedVector& values) { return {values.begin(), values.end()}; }

std::vector<double> stageTable(const std::vector<Stage>& stages) {
  std::vector<double> table;
  for (const auto& stage : stages) {
    for (const auto number : numbers) table.push_back(stage.*number);
    table.push_back(stage.ground ? 1 : 0);
  }
  return table;
}

std::vector<Stage> stagesFrom(const std::vector<double>& table) {
  constexpr std::size_t width = numbers.size() + 1;
  std::vector<Stage> stages(table.size() / width);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    for (std::size_t k = 0; k < numbers.size(); ++k) stages[i].*numbers[k] = table[i * width + k];
    stages[i].ground = table[i * width + numbers.size()] != 0;
  }
  return stages;
}

}  // namespace

results::ArrayTree treeOf(const GrowthState& s) {
  results::ArrayTree tree;
  tree.add("/growth/wear", s.wear, "m");
  tree.add("/growth/flow", s.flow, "m");
  tree.add("/growth/cut", s.cut, "m");
  tree.add("/growth/relaxation", s.relaxation, "1");
  tree.add("/growth/layer", plain(s.layer.values), "1");
  tree.add("/growth/layer_before", plain(s.layerBefore.values), "1");
  tree.add("/growth/displacement", plain(s.displacement), "m");
  tree.add("/growth/rates/wear", s.rates.wear, "m");
  tree.add("/growth/rates/flow", s.rates.flow, "m");
  tree.add("/growth/so_far", std::vector<double>{s.tonnage, s.passages, s.block, static_cast<double>(s.grindings)},
           "1");
  tree.add("/growth/stages", stageTable(s.stages), "1");
  std::vector<double> shapes;
  for (const auto& shape : s.shapes) shapes.insert(shapes.end(), shape.begin(), shape.end());
  tree.add("/growth/shapes", std::move(shapes), "m");
  return tree;
}

GrowthState stateFrom(const results::ArrayTree& tree, const std::string& file) {
  const auto values = [&](const char* path) -> const std::vector<double>& {
    return results::valuesOf<double>(tree, path, file);
  };
  GrowthState s;
  s.wear = values("/growth/wear"), s.flow = values("/growth/flow"), s.cut = values("/growth/cut");
  s.relaxation = values("/growth/relaxation");
  const auto &layer = values("/growth/layer"), &before = values("/growth/layer_before"),
             &displacement = values("/growth/displacement");
  s.layer.values.assign(layer.begin(), layer.end());
  s.layerBefore.values.assign(before.begin(), before.end());
  s.displacement.assign(displacement.begin(), displacement.end());
  s.rates = {values("/growth/rates/wear"), values("/growth/rates/flow")};
  const auto& soFar = values("/growth/so_far");
  if (soFar.size() != 4) throw FileError(file, "/growth/so_far", "has a wrong size");
  s.tonnage = soFar[0], s.passages = soFar[1], s.block = soFar[2];
  s.grindings = static_cast<std::size_t>(soFar[3]);
  s.stages = stagesFrom(values("/growth/stages"));
  const auto& shapes = values("/growth/shapes");
  if (shapes.size() != s.stages.size() * s.wear.size()) throw FileError(file, "/growth/shapes", "has a wrong size");
  for (std::size_t i = 0; i < s.stages.size(); ++i)
    s.shapes.emplace_back(shapes.begin() + static_cast<std::ptrdiff_t>(i * s.wear.size()),
                          shapes.begin() + static_cast<std::ptrdiff_t>((i + 1) * s.wear.size()));
  return s;
}

}  // namespace squat::growth
