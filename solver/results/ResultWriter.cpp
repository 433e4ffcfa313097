// RunResult -> ArrayTree.
#include <cstdio>

#include "results/ResultTree.h"

namespace squat::results {

namespace {

std::string numbered(const char* group, std::size_t index) {
  char text[64];
  std::snprintf(text, sizeof text, "/%s/%03zu", group, index);
  return text;
}

void addChannel(ArrayTree& tree, const std::string& group, const Channel& channel) {
  auto& array = tree.add(group + "/" + channel.name, channel.values, channel.unit);
  if (!channel.description.empty()) setAttribute(array.attributes, "description", channel.description);
}

void addScalars(ArrayTree& tree, const std::string& group, const std::vector<Scalar>& scalars) {
  for (const auto& scalar : scalars) {
    auto& array = tree.addScalar(group + "/" + scalar.name, scalar.value, scalar.unit);
    if (!scalar.description.empty()) setAttribute(array.attributes, "description", scalar.description);
  }
}

template <typename T>
void addRows(ArrayTree& tree, const std::string& path, const std::vector<T>& values, std::size_t width,
             const char* unit) {
  tree.add(path, values, unit, {values.size() / width, width});
}

void addRoot(ArrayTree& tree, const RunResult& result) {
  const auto set = [&](const char* name, AttributeValue value) {
    setAttribute(tree.attributes, name, std::move(value));
  };
  set("schema", std::string(kResultSchema));
  set("schema_version", std::int64_t{kResultVersion});
  set("code_version", result.codeVersion);
  if (!result.commit.empty()) set("commit", result.commit);
  set("complete", static_cast<std::uint8_t>(result.complete ? 1 : 0));
  set("stop_reason", result.stopReason);
  set("case_toml", result.caseToml);
  set("case_hash", result.caseHash);
  set("isa", result.isa);
  set("threads", std::int64_t{result.threads});
  set("stem", result.stem);
  set("title", result.title);
  set("created", result.created);
  set("speed", result.speed);
  if (!result.warnings.empty()) tree.add("/warnings", result.warnings, "1");
}

void addSignals(ArrayTree& tree, const RunResult& result) {
  tree.add("/signals/time", result.time, "s");
  tree.add("/signals/position", result.position, "m");
  for (const auto& channel : result.signals) addChannel(tree, "/signals", channel);
}

void addSpectra(ArrayTree& tree, const RunResult& result) {
  if (!result.frequency.empty()) {
    tree.add("/spectra/frequency", result.frequency, "Hz");
    tree.add("/spectra/psd", result.psd, "(m/s2)2/Hz");
    if (!result.psdWheel.empty()) tree.add("/spectra/psd_wheel", result.psdWheel, "(m/s2)2/Hz");
    auto& group = tree.addGroup("/spectra");
    setAttribute(group.attributes, "window", result.psdWindow);
    setAttribute(group.attributes, "from", result.psdFrom);
    setAttribute(group.attributes, "to", result.psdTo);
  }
  if (result.scalogramFrequency.empty()) return;
  tree.add("/scalogram/frequency", result.scalogramFrequency, "Hz");
  tree.add("/scalogram/time", result.scalogramTime, "s");
  tree.add("/scalogram/position", result.scalogramPosition, "m");
  const std::size_t rows = result.scalogramFrequency.size();
  tree.add("/scalogram/power", result.scalogramPower, "(m/s2)2 s", {rows, result.scalogramPower.size() / rows});
  tree.add("/scalogram/cone_of_influence", result.coneOfInfluence, "Hz");
}

void addModes(ArrayTree& tree, const RunResult& result) {
  if (result.modes.empty()) return;
  std::vector<double> frequency, box, wheel, contact;
  for (const auto& mode : result.modes) {
    frequency.push_back(mode.frequency);
    box.push_back(mode.boxAmplitude);
    wheel.push_back(mode.wheelAmplitude);
    contact.push_back(mode.contactAmplitude);
  }
  tree.add("/modes/frequency", frequency, "Hz");
  tree.add("/modes/box_share", box, "1/sqrt(kg)");
  tree.add("/modes/wheel_share", wheel, "1/sqrt(kg)");
  tree.add("/modes/contact_share", contact, "1/sqrt(kg)");
}

void addPermanent(ArrayTree& tree, const PermanentChange& change) {
  if (change.empty()) return;
  tree.add("/permanent/position", change.position, "m");
  tree.add("/permanent/lateral", change.lateral, "m");
  tree.add("/permanent/depth", change.depth, "m");
  addRows(tree, "/permanent/height", change.height, change.lateral.size(), "m");
  const std::size_t width = change.depth.size();
  addRows(tree, "/permanent/equivalent_strain", change.equivalentStrain, width, "1");
  addRows(tree, "/permanent/stress_along", change.stressAlong, width, "Pa");
  addRows(tree, "/permanent/stress_across", change.stressAcross, width, "Pa");
  addRows(tree, "/permanent/stress_vertical", change.stressVertical, width, "Pa");
  addRows(tree, "/permanent/von_mises", change.vonMises, width, "Pa");
}

void addSurface(ArrayTree& tree, const SurfaceMesh& surface) {
  if (surface.points.empty()) return;
  addRows(tree, "/mesh/surface/points", surface.points, 3, "m");
  addRows(tree, "/mesh/surface/quads", surface.quads, 4, "1");
  tree.add("/mesh/surface/part", surface.part, "1");
  tree.add("/mesh/surface/part_names", surface.partNames, "1");
  addRows(tree, "/mesh/surface/springs", surface.springs, 6, "m");
}

void addFields(ArrayTree& tree, const RunResult& result) {
  for (std::size_t i = 0; i < result.snapshots.size(); ++i) {
    const auto& snapshot = result.snapshots[i];
    const auto path = numbered("fields", i);
    addRows(tree, path + "/displacement", snapshot.displacement, 3, "m");
    tree.add(path + "/von_mises", snapshot.vonMises, "Pa");
    if (!snapshot.plasticStrain.empty()) tree.add(path + "/plastic_strain", snapshot.plasticStrain, "1");
    auto& group = tree.addGroup(path);
    setAttribute(group.attributes, "name", snapshot.name);
    setAttribute(group.attributes, "time", snapshot.time);
    setAttribute(group.attributes, "position", snapshot.position);
    setAttribute(group.attributes, "wheel_travel", snapshot.wheelTravel);
    setAttribute(group.attributes, "wheel_rotation", snapshot.wheelRotation);
  }
}

// One contact; the names of the right one's datasets end in `side`.
void addContact(ArrayTree& tree, const std::string& path, const PatchSnapshot& patch, const std::string& side) {
  const auto add = [&](const char* name, const auto& values, const char* unit) {
    tree.add(path + name + side, values, unit);
  };
  add("/x", patch.x, "m");
  add("/y", patch.y, "m");
  add("/pressure", patch.pressure, "Pa");
  add("/traction_x", patch.tractionX, "Pa");
  add("/traction_y", patch.tractionY, "Pa");
  add("/slipping", patch.slipping, "1");
  add("/area", patch.area, "m2");
}

void addPatches(ArrayTree& tree, const RunResult& result) {
  for (std::size_t i = 0; i < result.patches.size(); ++i) {
    const auto& patch = result.patches[i];
    const auto path = numbered("patch", i);
    addContact(tree, path, patch, "");
    if (patch.right) addContact(tree, path, *patch.right, "_right");
    auto& group = tree.addGroup(path);
    setAttribute(group.attributes, "name", patch.name);
    setAttribute(group.attributes, "time", patch.time);
    setAttribute(group.attributes, "position", patch.position);
  }
}

}  // namespace

ArrayTree toTree(const RunResult& result) {
  ArrayTree tree;
  addRoot(tree, result);
  addSignals(tree, result);
  addSpectra(tree, result);
  addScalars(tree, "/features", result.features);
  if (!result.energyTime.empty()) tree.add("/energy/time", result.energyTime, "s");
  for (const auto& channel : result.energy) addChannel(tree, "/energy", channel);
  addScalars(tree, "/equilibrium", result.equilibrium);
  addScalars(tree, "/mesh", result.meshFigures);
  addScalars(tree, "/performance", result.performance);
  addModes(tree, result);
  addScalars(tree, "/plasticity", result.plasticity);
  addPermanent(tree, result.permanent);
  if (!result.profilePosition.empty()) {
    tree.add("/profile/position", result.profilePosition, "m");
    tree.add("/profile/height", result.profileHeight, "m");
    if (!result.wheelPath.empty()) tree.add("/profile/wheel_path", result.wheelPath, "m");
  }
  addSurface(tree, result.surface);
  addFields(tree, result);
  addPatches(tree, result);
  return tree;
}

}  // namespace squat::results
