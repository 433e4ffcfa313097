#include "simulation/FieldRecorder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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
  result_.patches.push_back(patchSnapshot(name, rolling));
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
