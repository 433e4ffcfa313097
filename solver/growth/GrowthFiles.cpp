#include "growth/GrowthFiles.h"
#include "growth/SurfaceSeries.h"

#include <algorithm>
#include <cstddef>

#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/ProgramVersion.h"
#include "results/Hdf5.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::growth {

namespace {

constexpr double million = 1 / kilogramsInMegatonne, millimetre = 1e3, kilonewton = 1e-3;

}  // namespace

const std::vector<StageColumn>& stageColumns() {
  static const std::vector<StageColumn> columns{
      {"tonnage [Mt]", "tonnage", "kg", &Stage::tonnage, million},
      {"wheelsets", "wheelsets", "1", &Stage::passages, 1},
      {"depth [mm]", "depth", "m", &Stage::depth, millimetre},
      {"deepest at [mm]", "deepest_at", "m", &Stage::deepest, millimetre},
      {"length [mm]", "length", "m", &Stage::length, millimetre},
      {"wave length [mm]", "wave_length", "m", &Stage::waveLength, millimetre},
      {"wave height [mm]", "wave_height", "m", &Stage::waveHeight, millimetre},
      {"wear [mm]", "wear", "m", &Stage::wear, millimetre},
      {"flow [mm]", "flow", "m", &Stage::flow, millimetre},
      {"wear around [mm]", "wear_around", "m", &Stage::wearAround, millimetre},
      {"flow around [mm]", "flow_around", "m", &Stage::flowAround, millimetre},
      {"largest strain", "largest_strain", "1", &Stage::largestStrain, 1},
      {"at depth [mm]", "strain_depth", "m", &Stage::strainDepth, millimetre},
      {"strained to [mm]", "strained_depth", "m", &Stage::strainedDepth, millimetre},
      {"largest force [kN]", "largest_force", "N", &Stage::largestForce, kilonewton},
      {"smallest force [kN]", "smallest_force", "N", &Stage::smallestForce, kilonewton},
      {"peak acceleration [m/s2]", "peak_acceleration", "m/s2", &Stage::peakAcceleration, 1},
      {"wheelsets in block", "block", "1", &Stage::block, 1}};
  return columns;
}

std::string growthTable(const Growth& growth) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  for (const auto& column : stageColumns()) {
    names.push_back(column.name);
    auto& own = values.emplace_back();
    for (const auto& stage : growth.stages) own.push_back(column.scale * stage.*column.value);
  }
  names.push_back("ground");
  auto& ground = values.emplace_back();
  for (const auto& stage : growth.stages) ground.push_back(stage.ground ? 1 : 0);
  std::vector<const std::vector<double>*> columns;
  for (const auto& own : values) columns.push_back(&own);
  return text::csvColumns(names, columns);
}

results::ArrayTree growthTree(const Growth& growth) {
  results::ArrayTree tree;
  results::setAttribute(tree.attributes, "schema", std::string(growthSchema));
  results::setAttribute(tree.attributes, "schema_version", std::int64_t{1});
  results::setAttribute(tree.attributes, "code_version", programVersion());
  results::setAttribute(tree.attributes, "complete", static_cast<std::uint8_t>(growth.complete ? 1 : 0));
  results::setAttribute(tree.attributes, "case_toml", cases::writeCase(growth.description));
  for (const auto& column : stageColumns()) {
    std::vector<double> values;
    for (const auto& stage : growth.stages) values.push_back(stage.*column.value);
    tree.add(std::string("/stages/") + column.path, std::move(values), column.unit);
  }
  std::vector<std::uint8_t> ground;
  for (const auto& stage : growth.stages) ground.push_back(stage.ground ? 1 : 0);
  tree.add("/stages/ground", std::move(ground), "1");
  tree.add("/surface/x", growth.x, "m");
  tree.add("/surface/y", growth.y, "m");
  std::vector<float> heights;
  for (const auto& shape : growth.shapes) heights.insert(heights.end(), shape.begin(), shape.end());
  tree.add("/surface/height", std::move(heights), "m", {growth.shapes.size(), growth.x.size(), growth.y.size()});
  tree.add("/surface/wear", growth.wear, "m", {growth.x.size(), growth.y.size()});
  tree.add("/surface/flow", growth.flow, "m", {growth.x.size(), growth.y.size()});
  tree.add("/traffic/speed", growth.speeds, "m/s");
  tree.add("/traffic/wheel_load", growth.wheelLoads, "N");
  std::vector<double> lateral, traction;
  for (const auto& draw : growth.traffic) lateral.push_back(draw.lateral), traction.push_back(draw.traction);
  tree.add("/traffic/lateral", std::move(lateral), "m");
  tree.add("/traffic/traction", std::move(traction), "1");
  return tree;
}

cases::CaseDescription grownCase(const Growth& growth) {
  auto grown = growth.description;
  const auto& shape = growth.shapes.back();
  auto& defect = grown.defect;
  defect.shape = scenario::DefectShape::profile;
  defect.file.clear(), defect.points.clear(), defect.lines.clear();
  defect.from = defect.to = defect.lateralCentre = 0;
  defect.filter = scenario::ProfileFilter::none, defect.lateral = scenario::LateralShape::uniform;
  defect.heightScale = 1, defect.level = false;
  for (std::size_t line = 0; line < growth.y.size(); ++line) {
    scenario::ProfileLine along{growth.y[line], {}};
    for (std::size_t s = 0; s < growth.x.size(); ++s)
      along.points.push_back({growth.x[s], shape[s * growth.y.size() + line]});
    defect.lines.push_back(std::move(along));
  }
  const double tonnage = million * growth.stages.back().tonnage;
  grown.title = growth.description.title + " after " + text::fixedText(tonnage, 2) + " Mt";
  // Its defect reaches over the whole stretch: the mesh follows it by itself.
  grown.mesh.zoneBefore = grown.mesh.zoneBehind = 0;
  grown.mesh.bandHalfWidth = growth.bandHalfWidth;
  grown.rail.plasticFrom = grown.rail.plasticTo = grown.rail.plasticMiddle = 0;
  return grown;
}

std::string growthCheckpoint(const std::string& folder, const std::string& stem) {
  return folder + "/" + stem + "-growth.checkpoint";
}

ForecastFiles forecastFiles(const std::string& folder, const std::string& stem) {
  return {folder + "/" + stem + "-forecast.csv", folder + "/" + stem + "-forecast"};
}

std::vector<std::string> growthFiles(const std::string& folder, const std::string& stem) {
  const auto base = folder + "/" + stem;
  return {base + "-growth.csv",
          base + "-growth.h5",
          base + "-grown.toml",
          forecastFiles(folder, stem).table,
          forecastFiles(folder, stem).folder + "/study.csv",
          forecastFiles(folder, stem).folder + "/study.json",
          growthCheckpoint(folder, stem)};
}

std::vector<std::string> writeGrowthFiles(const Growth& growth, const std::string& folder, const std::string& stem) {
  auto files = growthFiles(folder, stem);
  files.resize(3);
  if (growth.stages.empty()) return {};
  writeDurably(files[0], growthTable(growth));
  writeDurably(files[1], results::encodeHdf5(growthTree(growth), files[1]),
               [](const std::string& path) { results::readOwnHdf5(path); });
  cases::saveCase(grownCase(growth), files[2]);
  return files;
}

}  // namespace squat::growth
