// ArrayTree -> RunResult, with every length checked: what comes out can be indexed without further care.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/Errors.h"
#include "results/ResultTree.h"

namespace squat::results {

namespace {

constexpr const char* kResultAdvice = "Use a result file that this program has written";

class Mapper {
 public:
  Mapper(ArrayTree& tree, const std::string& path) : tree_(tree), path_(path) {}

  [[noreturn]] void refuse(const std::string& object, const std::string& what) const {
    throw FileError(path_, object, what, kResultAdvice);
  }

  bool has(const std::string& object) const { return tree_.find(object) != nullptr; }

  // The values of a dataset, empty where there is none; the dataset is used up.
  template <typename T>
  std::vector<T> take(const std::string& object) const {
    used_.insert(object);
    auto* array = tree_.find(object);
    if (!array) return {};
    auto* values = std::get_if<std::vector<T>>(&array->values);
    if (!values) refuse(object, "has a wrong type");
    return std::move(*values);
  }

  // The same, but it must have `length` values if it is there at all, or must be there if `needed`.
  template <typename T>
  std::vector<T> take(const std::string& object, std::size_t length, bool needed = true) const {
    if (!needed && !has(object)) return {};
    auto values = take<T>(object);
    if (values.size() != length)
      refuse(object, "has " + std::to_string(values.size()) + " values where " + std::to_string(length) + " belong");
    return values;
  }

  std::vector<Channel> channels(const std::string& group, std::size_t length,
                                const std::vector<std::string>& others) const {
    std::vector<Channel> list;
    for (const auto& array : tree_.arrays) {
      const auto name = nameIn(group, array.path);
      if (name.empty() || std::find(others.begin(), others.end(), name) != others.end()) continue;
      Channel channel{
          name, textAttribute(array.attributes, "unit"), textAttribute(array.attributes, "description"), {}};
      channel.values = take<double>(array.path, length);
      list.push_back(std::move(channel));
    }
    return list;
  }

  std::vector<Scalar> scalars(const std::string& group) const {
    std::vector<Scalar> list;
    for (const auto& array : tree_.arrays) {
      const auto name = nameIn(group, array.path);
      if (name.empty()) continue;
      used_.insert(array.path);
      const auto* values = std::get_if<std::vector<double>>(&array.values);
      if (!values || values->size() != 1) refuse(array.path, "is not one number");
      list.push_back({name, textAttribute(array.attributes, "unit"), textAttribute(array.attributes, "description"),
                      (*values)[0]});
    }
    return list;
  }

  // Numbered groups below `group`: the paths of those there are.
  std::vector<std::string> members(const std::string& group) const {
    std::vector<std::string> list;
    for (const auto& entry : tree_.groups)
      if (!nameIn(group, entry.path).empty()) list.push_back(entry.path);
    std::sort(list.begin(), list.end());
    return list;
  }

  // Datasets that nothing has asked for, the first few by name; empty where there are none.
  std::string notAskedFor() const {
    constexpr int named = 4;
    std::string names;
    int count = 0;
    for (const auto& array : tree_.arrays)
      if (!used_.contains(array.path) && ++count <= named) names += (names.empty() ? "" : ", ") + array.path;
    return count > named ? names + " and " + std::to_string(count - named) + " more" : names;
  }

  std::string text(const std::string& group, const char* name) const {
    const auto* found = tree_.findGroup(group);
    return found ? textAttribute(found->attributes, name) : std::string();
  }
  double number(const std::string& group, const char* name) const {
    const auto* found = tree_.findGroup(group);
    return found ? numberAttribute(found->attributes, name) : 0;
  }

 private:
  // Of what lies in the group, "NAME" for ("/signals", "/signals/NAME"); empty for others and for what lies deeper.
  static std::string nameIn(const std::string& group, const std::string& path) {
    if (path.size() <= group.size() + 1 || path.compare(0, group.size(), group) != 0 || path[group.size()] != '/')
      return {};
    const auto name = path.substr(group.size() + 1);
    return name.find('/') == std::string::npos ? name : std::string();
  }

  ArrayTree& tree_;
  const std::string& path_;
  mutable std::set<std::string> used_;
};

void checkSchema(const ArrayTree& tree, const std::string& path) {
  if (textAttribute(tree.attributes, "schema") != kResultSchema)
    throw FileError(path, "/@schema", "is not a result of this program", kResultAdvice);
  const double version = numberAttribute(tree.attributes, "schema_version", -1);
  if (!(version >= 1)) throw FileError(path, "/@schema_version", "is missing or wrong", kResultAdvice);
  if (version > kResultVersion)
    throw FileError(path, "/@schema_version",
                    "is " + std::to_string(static_cast<long>(std::min(version, 1e9))) + ", newer than the " +
                        std::to_string(kResultVersion) + " that this program reads",
                    "Install the newer program, or run the case again with this one");
}

void readRoot(const Mapper& from, const ArrayTree& tree, RunResult& result) {
  const auto text = [&](const char* name) { return textAttribute(tree.attributes, name); };
  const auto number = [&](const char* name) { return numberAttribute(tree.attributes, name); };
  result.codeVersion = text("code_version");
  result.commit = text("commit");
  result.complete = number("complete") == 1;
  result.stopReason = text("stop_reason");
  result.caseToml = text("case_toml");
  readCaseOf(result);
  result.caseHash = text("case_hash");
  result.isa = text("isa");
  const double threads = number("threads");
  result.threads = threads > 0 && threads < 1e6 ? static_cast<int>(threads) : 0;
  // Names files later on: an untrusted path must not lead them elsewhere.
  result.stem = std::filesystem::path(text("stem")).filename().string();
  result.title = text("title");
  result.created = text("created");
  result.speed = number("speed");
  if (!std::isfinite(result.speed)) from.refuse("/@speed", "is not a number");
  result.warnings = from.take<std::string>("/warnings");
}

// Spectra of a signal sampled much faster than any that this program writes (10 MHz) outgrow the memory.
void requireRising(const Mapper& from, const std::vector<double>& time) {
  constexpr double shortestStep = 1e-7;  // [s]
  for (std::size_t i = 0; i < time.size(); ++i)
    if (!std::isfinite(time[i]) || (i > 0 && !(time[i] - time[i - 1] >= shortestStep)))
      from.refuse("/signals/time", "does not rise by 1e-7 s or more at each sample");
}

void readSpectra(const Mapper& from, RunResult& result) {
  result.frequency = from.take<double>("/spectra/frequency");
  result.psd = from.take<double>("/spectra/psd", result.frequency.size());
  result.psdWheel = from.take<double>("/spectra/psd_wheel", result.frequency.size(), false);
  result.psdWindow = from.text("/spectra", "window");
  result.psdFrom = from.number("/spectra", "from");
  result.psdTo = from.number("/spectra", "to");

  result.scalogramFrequency = from.take<double>("/scalogram/frequency");
  result.scalogramTime = from.take<double>("/scalogram/time");
  const auto columns = result.scalogramTime.size();
  if (result.scalogramFrequency.empty() != (columns == 0))
    from.refuse("/scalogram/frequency", "and /scalogram/time do not belong together");
  result.scalogramPosition = from.take<double>("/scalogram/position", columns);
  result.scalogramPower = from.take<double>("/scalogram/power", result.scalogramFrequency.size() * columns);
  result.coneOfInfluence = from.take<double>("/scalogram/cone_of_influence", columns);
}

void readModes(const Mapper& from, RunResult& result) {
  const auto frequency = from.take<double>("/modes/frequency");
  const auto box = from.take<double>("/modes/box_share", frequency.size());
  const auto wheel = from.take<double>("/modes/wheel_share", frequency.size());
  const auto contact = from.take<double>("/modes/contact_share", frequency.size());
  for (std::size_t i = 0; i < frequency.size(); ++i)
    result.modes.push_back({frequency[i], box[i], wheel[i], contact[i]});
}

void readPermanent(const Mapper& from, PermanentChange& change) {
  change.position = from.take<double>("/permanent/position");
  if (change.empty()) return;
  change.lateral = from.take<double>("/permanent/lateral");
  change.depth = from.take<double>("/permanent/depth");
  const std::size_t across = change.position.size() * change.lateral.size();
  const std::size_t down = change.position.size() * change.depth.size();
  change.height = from.take<double>("/permanent/height", across);
  change.equivalentStrain = from.take<double>("/permanent/equivalent_strain", down);
  change.stressAlong = from.take<double>("/permanent/stress_along", down);
  change.stressAcross = from.take<double>("/permanent/stress_across", down);
  change.stressVertical = from.take<double>("/permanent/stress_vertical", down);
  change.vonMises = from.take<double>("/permanent/von_mises", down);
}

void readSurface(const Mapper& from, SurfaceMesh& surface) {
  surface.points = from.take<float>("/mesh/surface/points");
  surface.quads = from.take<std::int32_t>("/mesh/surface/quads");
  surface.partNames = from.take<std::string>("/mesh/surface/part_names");
  surface.springs = from.take<float>("/mesh/surface/springs");
  if (surface.points.size() % 3 != 0) from.refuse("/mesh/surface/points", "is not a list of x, y, z");
  if (surface.quads.size() % 4 != 0) from.refuse("/mesh/surface/quads", "is not a list of four indices each");
  if (surface.springs.size() % 6 != 0) from.refuse("/mesh/surface/springs", "is not a list of two ends each");
  surface.part = from.take<std::uint8_t>("/mesh/surface/part", surface.quads.size() / 4);
  const auto points = static_cast<std::int64_t>(surface.points.size() / 3);
  for (const auto index : surface.quads)
    if (index < 0 || index >= points) from.refuse("/mesh/surface/quads", "names a point that is not there");
  for (const auto part : surface.part)
    if (part >= surface.partNames.size()) from.refuse("/mesh/surface/part", "names a part that is not there");
}

void readFields(const Mapper& from, RunResult& result) {
  const std::size_t points = result.surface.points.size() / 3;
  for (const auto& group : from.members("/fields")) {
    SurfaceSnapshot snapshot;
    snapshot.name = from.text(group, "name");
    snapshot.time = from.number(group, "time");
    snapshot.position = from.number(group, "position");
    snapshot.wheelTravel = from.number(group, "wheel_travel");
    snapshot.wheelRotation = from.number(group, "wheel_rotation");
    snapshot.displacement = from.take<float>(group + "/displacement", 3 * points);
    snapshot.vonMises = from.take<float>(group + "/von_mises", points);
    snapshot.plasticStrain = from.take<float>(group + "/plastic_strain", points, false);
    result.snapshots.push_back(std::move(snapshot));
  }
}

PatchSnapshot readContact(const Mapper& from, const std::string& group, const std::string& side) {
  PatchSnapshot patch;
  patch.name = from.text(group, "name");
  patch.time = from.number(group, "time");
  patch.position = from.number(group, "position");
  patch.x = from.take<float>(group + "/x" + side);
  const auto count = patch.x.size();
  patch.y = from.take<float>(group + "/y" + side, count);
  patch.pressure = from.take<float>(group + "/pressure" + side, count);
  patch.tractionX = from.take<float>(group + "/traction_x" + side, count);
  patch.tractionY = from.take<float>(group + "/traction_y" + side, count);
  patch.slipping = from.take<std::uint8_t>(group + "/slipping" + side, count);
  patch.area = from.take<float>(group + "/area" + side, count);
  return patch;
}

void readPatches(const Mapper& from, RunResult& result) {
  for (const auto& group : from.members("/patch")) {
    auto patch = readContact(from, group, "");
    if (from.has(group + "/x_right"))
      patch.right = std::make_shared<const PatchSnapshot>(readContact(from, group, "_right"));
    result.patches.push_back(std::move(patch));
  }
}

}  // namespace

RunResult fromTree(ArrayTree tree, const std::string& path) {
  checkSchema(tree, path);
  const Mapper from(tree, path);
  RunResult result;
  readRoot(from, tree, result);
  result.time = from.take<double>("/signals/time");
  const auto samples = result.time.size();
  requireRising(from, result.time);
  result.position = from.take<double>("/signals/position", samples);
  result.signals = from.channels("/signals", samples, {"time", "position"});
  readSpectra(from, result);
  result.features = from.scalars("/features");
  result.energyTime = from.take<double>("/energy/time");
  result.energy = from.channels("/energy", result.energyTime.size(), {"time"});
  result.equilibrium = from.scalars("/equilibrium");
  result.meshFigures = from.scalars("/mesh");
  result.performance = from.scalars("/performance");
  readModes(from, result);
  result.plasticity = from.scalars("/plasticity");
  readPermanent(from, result.permanent);
  result.profilePosition = from.take<double>("/profile/position");
  result.profileHeight = from.take<double>("/profile/height", result.profilePosition.size());
  result.wheelPath = from.take<double>("/profile/wheel_path", result.profilePosition.size(), false);
  readSurface(from, result.surface);
  readFields(from, result);
  readPatches(from, result);
  if (const auto names = from.notAskedFor(); !names.empty())
    result.notRead = names + ", written by version " + result.codeVersion;
  return result;
}

}  // namespace squat::results
