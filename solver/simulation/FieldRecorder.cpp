#include "simulation/FieldRecorder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/Errors.h"

namespace squat::simulation {

namespace {

constexpr double frameFrom = -0.06, frameTo = 0.12;  // [m] stretch about the defect of which frames are kept
constexpr int frames = 12;

}  // namespace

long FieldRecorder::nextStep(long done) const {
  const long offset = done % perSample_;
  return done + std::min(perSample_ - offset, grid_ - offset % grid_);
}

void FieldRecorder::onStep(const dynamics::Rolling& rolling) {
  if (rolling.state().step % perSample_ % grid_ != 0) return;
  const auto& model = rolling.model();
  const double x = model.startX + model.scenario.motion.speed * rolling.state().time;
  if (x >= 0 && !has("impact")) take("impact", rolling);
  const int frame = static_cast<int>(std::floor((x - frameFrom) / (frameTo - frameFrom) * frames));
  if (x < frameFrom || frame >= frames) return;
  char name[24];
  std::snprintf(name, sizeof name, "frame %02d", frame);
  if (!has(name)) take(name, rolling);
}

bool FieldRecorder::has(const std::string& name) const {
  return std::any_of(result_.snapshots.begin(), result_.snapshots.end(), [&](const auto& s) { return s.name == name; });
}

void FieldRecorder::take(const std::string& name, const dynamics::Rolling& rolling) {
  result_.snapshots.push_back(fields_.snapshot(name, rolling));
  auto patch = patchSnapshot(name, rolling);
  if (rolling.sides().size() > 1) {
    auto right = patchSnapshot(name, *rolling.sides()[1]);
    right.time = patch.time, right.position = patch.position;  // of the wheelset
    patch.right = std::make_shared<const results::PatchSnapshot>(std::move(right));
  }
  result_.patches.push_back(std::move(patch));
}

results::PatchSnapshot patchSnapshot(const std::string& name, const dynamics::Rolling& rolling) {
  results::PatchSnapshot shot;
  shot.name = name, shot.time = rolling.state().time;
  shot.position = rolling.view().position;
  for (const auto& p : rolling.patchPoints()) {
    shot.x.push_back(static_cast<float>(p.x)), shot.y.push_back(static_cast<float>(p.y));
    shot.pressure.push_back(static_cast<float>(p.pressure));
    shot.tractionX.push_back(static_cast<float>(p.tractionX)),
        shot.tractionY.push_back(static_cast<float>(p.tractionY));
    shot.slipping.push_back(p.slips), shot.area.push_back(static_cast<float>(p.area));
  }
  return shot;
}

namespace {

void saveContact(const results::PatchSnapshot& shot, const std::string& path, const std::string& side,
                 results::ArrayTree& tree) {
  const std::pair<const char*, const std::vector<float>*> fields[] = {{"/x", &shot.x},
                                                                      {"/y", &shot.y},
                                                                      {"/pressure", &shot.pressure},
                                                                      {"/traction_x", &shot.tractionX},
                                                                      {"/traction_y", &shot.tractionY},
                                                                      {"/area", &shot.area}};
  for (const auto& [name, values] : fields) tree.add(path + name + side, *values, "1");
  tree.add(path + "/slipping" + side, shot.slipping, "1");
}

results::PatchSnapshot loadContact(const results::ArrayTree& tree, const std::string& path, const std::string& side,
                                   const std::string& file) {
  const auto floats = [&](const char* name) { return results::valuesOf<float>(tree, path + name + side, file); };
  results::PatchSnapshot shot;
  shot.x = floats("/x"), shot.y = floats("/y"), shot.pressure = floats("/pressure");
  shot.tractionX = floats("/traction_x"), shot.tractionY = floats("/traction_y");
  shot.slipping = results::valuesOf<std::uint8_t>(tree, path + "/slipping" + side, file);
  shot.area = floats("/area");
  return shot;
}

// With the right contact where the checkpoint has one.
results::PatchSnapshot loadPatch(const results::ArrayTree& tree, const std::string& path, const std::string& file) {
  const auto& numbers = results::valuesOf<double>(tree, path + "/numbers", file);
  const auto named = [&](results::PatchSnapshot shot) {
    shot.name = path.substr(path.rfind('/') + 1), shot.time = numbers[0], shot.position = numbers[1];
    return shot;
  };
  auto patch = named(loadContact(tree, path, "", file));
  if (tree.find(path + "/x_right"))
    patch.right = std::make_shared<const results::PatchSnapshot>(named(loadContact(tree, path, "_right", file)));
  return patch;
}

}  // namespace

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
    saveContact(shot, path, "", tree);
    if (shot.right) saveContact(*shot.right, path, "_right", tree);
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
      result.patches.push_back(loadPatch(tree, path, file));
  }
  std::sort(result.snapshots.begin(), result.snapshots.end(),
            [](const auto& a, const auto& b) { return a.time < b.time; });
}

}  // namespace squat::simulation
