#include "simulation/RunStart.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "results/ResultTree.h"
#include "results/StateFile.h"

namespace squat::simulation {

namespace {

// Figures of the start are kept in the layout of the result file below this group.
constexpr const char* kStart = "/start";
// The order of unknowns in /rolling/displaced and /rolling/velocity (elasticity/SweptBlock.h), of /rolling/scalars and
// of /energy_balance: raise it with them.
constexpr const char* kLayoutName = "state_layout";
constexpr int kLayout = 7;

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

RunStart loadStart(const StoredState& stored, double rate, results::RunResult& result) {
  const auto& [tree, file, instead] = stored;
  if (numberAttribute(tree.attributes, kLayoutName) != kLayout)
    throw FileError(file, std::string("attribute ") + kLayoutName, "was written by another version of the program",
                    "Use that version, or " + instead);
  results::ArrayTree figures;
  setAttribute(figures.attributes, "schema", std::string(results::kResultSchema));
  setAttribute(figures.attributes, "schema_version", std::int64_t{results::kResultVersion});
  for (const auto& array : tree.arrays)
    if (array.path.starts_with(kStart)) {
      figures.arrays.push_back(array);
      figures.arrays.back().path.erase(0, std::string(kStart).size());
    }
  const auto& steps = results::valuesOf<double>(tree, "/steps", file);
  if (steps.size() != 3 || !(steps[0] >= 2 && steps[0] <= maximumStepsPerSample) || steps[0] != std::floor(steps[0]) ||
      !(std::abs(steps[0] * steps[1] * rate - 1) < 1e-9) || !(steps[2] >= 0))
    throw FileError(file, "/steps", "does not fit the output rate of this case", results::asSentence(instead));
  auto read = results::fromTree(std::move(figures), file);
  result.equilibrium = std::move(read.equilibrium);
  result.meshFigures = std::move(read.meshFigures);
  result.modes = std::move(read.modes);
  return RunStart{static_cast<long>(steps[0]), steps[1], steps[2]};
}

}  // namespace squat::simulation
