// What a checkpoint holds besides the state of the rolling: how the run was begun, and the pictures taken so far.
#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "results/ResultTree.h"
#include "simulation/RunParts.h"

namespace squat::simulation {

namespace {

// Figures of the start are kept in the layout of the result file below this group.
constexpr const char* kStart = "/start";
// The order of unknowns in /rolling/displaced and /rolling/velocity (elasticity/SweptBlock.h) and of /rolling/small:
// raise it with them.
constexpr const char* kLayoutName = "state_layout";
constexpr int kLayout = 5;

bool belongsToTheStart(const std::string& path) {
  return path.starts_with("/equilibrium/") || path.starts_with("/modes/") ||
         (path.starts_with("/mesh/") && !path.starts_with("/mesh/surface/"));
}

}  // namespace

void saveStart(const RunStart& start, const results::RunResult& result, results::ArrayTree& tree) {
  setAttribute(tree.attributes, kLayoutName, std::int64_t{kLayout});
  tree.add("/steps", std::vector<double>{static_cast<double>(start.stepsPerSample), start.step, start.beta}, "1");
  results::RunResult figures;
  figures.equilibrium = result.equilibrium, figures.meshFigures = result.meshFigures, figures.modes = result.modes;
  for (auto& array : results::toTree(figures).arrays)
    if (belongsToTheStart(array.path))
      tree.arrays.push_back(std::move(array)), tree.arrays.back().path.insert(0, kStart);
}

RunStart loadStart(const results::ArrayTree& tree, const std::string& file, double rate, results::RunResult& result) {
  if (numberAttribute(tree.attributes, kLayoutName) != kLayout)
    throw FileError(file, std::string("attribute ") + kLayoutName, "was written by another version of the program",
                    "Use that version, or start the run anew without --resume");
  results::ArrayTree figures;
  setAttribute(figures.attributes, "schema", std::string(results::kResultSchema));
  setAttribute(figures.attributes, "schema_version", std::int64_t{results::kResultVersion});
  for (const auto& array : tree.arrays)
    if (array.path.starts_with(kStart)) {
      figures.arrays.push_back(array);
      figures.arrays.back().path.erase(0, std::string(kStart).size());
    }
  const auto& steps = results::valuesOf<double>(tree, "/steps", file);
  if (steps.size() != 3 || !(steps[0] >= 2 && steps[0] <= mostStepsPerSample) || steps[0] != std::floor(steps[0]) ||
      !(std::abs(steps[0] * steps[1] * rate - 1) < 1e-9) || !(steps[2] >= 0))
    throw FileError(file, "/steps", "does not fit the output rate of this case", "Start anew without --resume");
  auto read = results::fromTree(std::move(figures), file);
  result.equilibrium = std::move(read.equilibrium);
  result.meshFigures = std::move(read.meshFigures);
  result.modes = std::move(read.modes);
  return RunStart{static_cast<long>(steps[0]), steps[1], steps[2]};
}

void savePictures(const results::RunResult& result, results::ArrayTree& tree) {
  for (const auto& shot : result.snapshots) {
    const std::string path = "/snapshots/" + shot.name;
    tree.add(path + "/numbers", std::vector<double>{shot.time, shot.position, shot.wheelTravel, shot.wheelRotation},
             "1");
    tree.add(path + "/displacement", shot.displacement, "m");
    tree.add(path + "/von_mises", shot.vonMises, "Pa");
    if (!shot.plasticStrain.empty()) tree.add(path + "/plastic_strain", shot.plasticStrain, "1");
  }
  for (const auto& shot : result.patches) {
    const std::string path = "/patches/" + shot.name;
    tree.add(path + "/numbers", std::vector<double>{shot.time, shot.position}, "1");
    const std::pair<const char*, const std::vector<float>*> fields[] = {{"/x", &shot.x},
                                                                        {"/y", &shot.y},
                                                                        {"/pressure", &shot.pressure},
                                                                        {"/traction_x", &shot.tractionX},
                                                                        {"/traction_y", &shot.tractionY},
                                                                        {"/area", &shot.area}};
    for (const auto& [name, values] : fields) tree.add(path + name, *values, "1");
    tree.add(path + "/slipping", shot.slipping, "1");
  }
}

void loadPictures(const results::ArrayTree& tree, const std::string& file, results::RunResult& result) {
  result.snapshots.clear(), result.patches.clear();
  const auto floats = [&](const std::string& path) { return results::valuesOf<float>(tree, path, file); };
  for (const auto& array : tree.arrays) {
    if (!array.path.ends_with("/numbers")) continue;
    const std::string path = array.path.substr(0, array.path.size() - 8), name = path.substr(path.rfind('/') + 1);
    const auto& n = results::valuesOf<double>(tree, array.path, file);
    const bool isSnapshot = path.starts_with("/snapshots/");
    if (n.size() != (isSnapshot ? 4U : 2U)) throw FileError(file, array.path, "has a wrong length");
    if (isSnapshot)
      result.snapshots.push_back(
          {name, n[0], n[1], n[2], n[3], floats(path + "/displacement"), floats(path + "/von_mises"),
           tree.find(path + "/plastic_strain") ? floats(path + "/plastic_strain") : std::vector<float>{}});
    else
      result.patches.push_back({name, n[0], n[1], floats(path + "/x"), floats(path + "/y"), floats(path + "/pressure"),
                                floats(path + "/traction_x"), floats(path + "/traction_y"),
                                results::valuesOf<std::uint8_t>(tree, path + "/slipping", file),
                                floats(path + "/area")});
  }
  std::sort(result.snapshots.begin(), result.snapshots.end(),
            [](const auto& a, const auto& b) { return a.time < b.time; });
}

}  // namespace squat::simulation
