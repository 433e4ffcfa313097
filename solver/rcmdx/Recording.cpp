#include "rcmdx/Recording.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "core/Errors.h"
#include "rcmdx/UnitWords.h"
#include "results/Hdf5.h"
#include "text/Text.h"

namespace squat::rcmdx {
namespace {

using results::Array;
using results::ArrayTree;
using results::Attribute;

// Of the group that is the file's root: "/RCMDX", as SBB's files have it, or the root of the HDF5 file itself; the
// specification can be read either way.
const std::vector<Attribute>* rootAttributes(const ArrayTree& tree) {
  const auto states = [](const std::vector<Attribute>& list, std::string_view name) {
    return std::any_of(list.begin(), list.end(), [&](const Attribute& one) { return one.name == name; });
  };
  const auto* named = tree.findGroup("/RCMDX");
  if (named && states(named->attributes, "Major") && states(named->attributes, "Minor")) return &named->attributes;
  if (states(tree.attributes, "Major") && states(tree.attributes, "Minor")) return &tree.attributes;
  return nullptr;
}

std::vector<Attribute> attributesOf(const ArrayTree& tree, const std::string& path) {
  const auto* group = tree.findGroup(path);
  return group ? group->attributes : std::vector<Attribute>{};
}

std::string elementOf(const ArrayTree& tree, const std::string& path) {
  return text::lowerCase(results::textAttribute(attributesOf(tree, path), "Element"));
}

// "20190212_231255.592"
bool isSessionName(const std::string& name) {
  constexpr std::string_view pattern = "dddddddd_dddddd.ddd";
  if (name.size() != pattern.size()) return false;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (pattern[i] == 'd' ? name[i] < '0' || name[i] > '9' : name[i] != pattern[i]) return false;
  return true;
}

std::set<std::string> groupsOf(const ArrayTree& tree) {
  std::set<std::string> groups;
  const auto addWithParents = [&groups](std::string path) {
    while (!path.empty() && groups.insert(path).second) path = groupOf(path);
  };
  for (const auto& group : tree.groups) addWithParents(group.path);
  for (const auto& array : tree.arrays) addWithParents(groupOf(array.path));
  return groups;
}

bool isNumberArray(const Array& array) { return !std::holds_alternative<std::vector<std::string>>(array.values); }

// Values of an array of one dimension, or of one that counts in one dimension only.
std::size_t samplesIn(const Array& array) {
  std::size_t count = 1, longest = 1;
  for (const std::size_t extent : array.shape) {
    count *= extent;
    longest = std::max(longest, extent);
  }
  return count == longest ? count : 0;
}

bool isWithin(const std::string& path, const std::string& group) {
  return path.size() > group.size() && path.compare(0, group.size(), group) == 0 && path[group.size()] == '/';
}

std::int64_t wholeAttribute(const std::vector<Attribute>& attributes, const std::string& name) {
  for (const auto& attribute : attributes)
    if (attribute.name == name)
      if (const auto* whole = std::get_if<std::int64_t>(&attribute.value)) return *whole;
  return 0;
}

// SBB names groups with all that is above: "DFZ00.TSIMS.FAST.ABA" in "DFZ00.TSIMS.FAST".
std::string shortName(const std::string& path) {
  const auto name = nameIn(path), above = nameIn(groupOf(path));
  return name.size() > above.size() + 1 && name.compare(0, above.size() + 1, above + ".") == 0
             ? name.substr(above.size() + 1)
             : name;
}

// A number that is stated and finite; 0 otherwise.
double positiveAttribute(const std::vector<Attribute>& attributes, const char* name) {
  const double value = results::numberAttribute(attributes, name);
  return std::isfinite(value) && value > 0 ? value : 0;
}

int versionAttribute(const std::vector<Attribute>& attributes, const char* name) {
  return static_cast<int>(std::min(positiveAttribute(attributes, name), 1e6));
}

class RecordingBuilder {
 public:
  RecordingBuilder(const std::string& path, const ArrayTree& tree)
      : path_(path), tree_(tree), groups_(groupsOf(tree)) {}

  Recording build() const {
    Recording recording;
    recording.path = path_;
    if (const auto* root = rootAttributes(tree_)) {
      recording.major = versionAttribute(*root, "Major");
      recording.minor = versionAttribute(*root, "Minor");
      recording.feature = versionAttribute(*root, "Feature");
    }
    for (const auto& group : groups_)
      if (elementOf(tree_, group) == "session" || isSessionName(nameIn(group)))
        recording.sessions.push_back(session(group));
    if (recording.sessions.empty())
      throw FileError(path_, "/RCMDX", "holds no session",
                      "An RCM-DX file has one below its platform; export it again");
    return recording;
  }

 private:
  Session session(const std::string& group) const {
    Session session;
    session.path = group;
    session.name = nameIn(group);
    session.platform = nameIn(groupOf(group));
    session.vehicleNumber = results::textAttribute(attributesOf(tree_, groupOf(group)), "VehicleNumber");
    const auto attributes = attributesOf(tree_, group);
    session.start = wholeAttribute(attributes, "StartTime");
    session.end = wholeAttribute(attributes, "EndTime");
    if (groups_.count(group + "/CONFIGURATION/TOPOLOGY")) session.topology = group + "/CONFIGURATION/TOPOLOGY";
    for (const auto& array : tree_.arrays) {
      if (nameIn(array.path) != "timestamp" || !isWithin(array.path, group)) continue;
      if (isWithin(array.path, group + "/POSITION")) {
        if (auto found = position(array); !session.position && found) session.position = std::move(found);
      } else if (auto found = source(array); !found.channels.empty()) {
        session.sources.push_back(std::move(found));
      }
    }
    return session;
  }

  // The channels beside a dataset of times; none where it is that of limits, events or settings.
  DataSource source(const Array& timestamps) const {
    DataSource source;
    source.path = groupOf(timestamps.path);
    source.system = shortName(groupOf(source.path));
    source.name = shortName(source.path);
    source.timestamps = timestamps.path;
    source.samples = samplesIn(timestamps);
    for (const auto& array : tree_.arrays) {
      if (nameIn(array.path) != "data" || groupOf(groupOf(array.path)) != source.path || !isNumberArray(array))
        continue;
      if (samplesIn(array) == 0 && source.samples != 0) continue;  // more than a number each time: no signal
      source.channels.push_back(channel(array));
    }
    return source;
  }

  Channel channel(const Array& data) const {
    Channel channel;
    channel.path = groupOf(data.path);
    channel.data = data.path;
    channel.name = shortName(channel.path);
    channel.samples = samplesIn(data);
    const auto attributes = attributesOf(tree_, channel.path);
    // The specification puts the unit on the dataset in one place and on the channel in another.
    const auto unit = results::textAttribute(data.attributes, "Unit", results::textAttribute(attributes, "Unit"));
    channel.unit = symbolOf(unit);
    channel.basis = results::textAttribute(attributes, "ChannelBasis");
    channel.triggerMode = results::textAttribute(attributes, "TriggerMode");
    channel.neighbour = results::textAttribute(attributes, "Neighbor");
    channel.frequency = positiveAttribute(attributes, "CommonTriggerFrequency");
    channel.distance = positiveAttribute(attributes, "CommonTriggerDistance");
    const double offset = results::numberAttribute(attributes, "PositionOffset");  // [mm]
    channel.positionOffset = std::isfinite(offset) ? 1e-3 * offset : 0;
    return channel;
  }

  // The datasets of positions stand in a group beside their times, named as the specification has them or, as in SBB's
  // files, with "data." in front.
  std::optional<PositionSource> position(const Array& timestamps) const {
    PositionSource source;
    source.path = groupOf(timestamps.path);
    source.timestamps = timestamps.path;
    source.samples = samplesIn(timestamps);
    const auto find = [&](const std::string& name) -> std::string {
      for (const auto& array : tree_.arrays) {
        if (!isWithin(array.path, source.path) || samplesIn(array) != source.samples) continue;
        if (const auto own = text::lowerCase(nameIn(array.path)); own == name || own == "data." + name)
          return array.path;
      }
      return {};
    };
    source.coveredDistance = find("covereddistance");
    source.trackOffset = find("trackoffset");
    source.lineOffset = find("lineoffset");
    source.trackId = find("track_id");
    source.lineId = find("line_id");
    source.direction = find("direction");
    source.kilometrage = find("kilometrage");
    source.accuracy = find("positionaccuracy");
    source.quality = find("positionquality");
    if (source.samples == 0 || (source.coveredDistance.empty() && source.lineOffset.empty())) return std::nullopt;
    return source;
  }

  const std::string& path_;
  const ArrayTree& tree_;
  std::set<std::string> groups_;
};

}  // namespace

std::string nameIn(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string groupOf(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

bool isRcmDx(const ArrayTree& tree) {
  if (!rootAttributes(tree)) return false;
  return std::any_of(tree.groups.begin(), tree.groups.end(), [&](const results::Group& group) {
    const auto element = elementOf(tree, group.path);
    return element == "session" || element == "platform" || element == "file";
  });
}

bool isRcmDx(const std::string& path) {
  try {
    return isRcmDx(listRcmDx(path));
  } catch (const FileError&) {
    return false;
  }
}

Recording recordingOf(const std::string& path, const ArrayTree& tree) { return RecordingBuilder(path, tree).build(); }

Recording readRcmDx(const std::string& path) {
  const auto tree = listRcmDx(path);
  if (!isRcmDx(tree))
    throw FileError(path, "/RCMDX", "states no version of RCM-DX", "Name a file with the ending .rcmdx");
  return recordingOf(path, tree);
}

ArrayTree listRcmDx(const std::string& path) {
  results::Hdf5Limits limits;
  limits.skipForeign = true;
  limits.valuesUpTo = 4096;
  limits.objects = 200000;
  return results::readHdf5(path, limits);
}

}  // namespace squat::rcmdx
