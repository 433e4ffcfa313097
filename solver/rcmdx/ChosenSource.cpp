#include "rcmdx/ChosenSource.h"

#include <algorithm>
#include <string_view>

#include "core/Errors.h"
#include "text/Heading.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::rcmdx {
namespace {

// "ACC_LEFT", "AXLEBOX_ACC_L", "ABA2": a word of the name stands for an acceleration.
bool namesAcceleration(const std::string& name) {
  std::string word;
  for (const char c : text::lowerCase(name) + " ")
    if (c >= 'a' && c <= 'z') {
      word += c;
    } else {
      if (word.size() > 1 && text::siUnitOfName(word) == "m/s2") return true;
      word.clear();
    }
  return false;
}

bool matches(const std::string& path, const std::string& name, const std::string& object) {
  return object == path || object == "/" + name || object == name || object == nameIn(path);
}

bool isInside(const std::string& object, const std::string& path) { return object.rfind(path + "/", 0) == 0; }

bool isOverTime(const Channel& channel) { return channel.triggerMode.empty() || channel.triggerMode == "TIME"; }

std::string shortened(std::string list) {
  constexpr std::size_t longest = 1500;  // [bytes] of a message
  if (list.size() > longest) list = list.substr(0, list.rfind(',', longest)) + ", ...";
  return list;
}

std::string channelList(const Session& session) {
  std::string list;
  for (const auto& source : session.sources)
    for (const auto& channel : source.channels)
      list += (list.empty() ? "" : ", ") + source.system + "/" + source.name + "/" + channel.name +
              (channel.unit.empty() ? "" : " [" + channel.unit + "]");
  return list.empty() ? "none" : shortened(std::move(list));
}

class SourceChooser {
 public:
  SourceChooser(const Recording& recording, std::string object) : recording_(recording), object_(std::move(object)) {
    while (object_.size() > 1 && object_.back() == '/') object_.pop_back();
  }

  ChosenSource choose() {
    const Session* session = chooseSession();
    chosen_.session = *session;
    const DataSource* source = named(*session);
    if (!source) source = fastest(*session);
    const auto all = source->channels;
    chosen_.source = *source;
    if (channel_.empty())
      std::erase_if(chosen_.source.channels, [](const Channel& one) { return !isAcceleration(one) && !isSpeed(one); });
    else
      std::erase_if(chosen_.source.channels, [&](const Channel& one) { return one.path != channel_ && !isSpeed(one); });
    if (std::none_of(chosen_.source.channels.begin(), chosen_.source.channels.end(), isAcceleration) &&
        channel_.empty())
      refuseChannels(*session);
    for (const auto& channel : chosen_.source.channels)
      if (channel.samples != chosen_.source.samples)
        throw FileError(
            recording_.path, channel.data,
            "has " + std::to_string(channel.samples) + " values, its times " + std::to_string(chosen_.source.samples),
            "A channel has a value for each timestamp of its data source; export the session again");
    return std::move(chosen_);
  }

 private:
  const Session* chooseSession() const {
    const auto& sessions = recording_.sessions;
    for (const auto& session : sessions)
      if (!object_.empty() && (matches(session.path, session.name, object_) || isInside(object_, session.path)))
        return &session;
    if (sessions.size() == 1) return &sessions.front();
    std::string list;
    for (const auto& session : sessions) list += (list.empty() ? "" : ", ") + session.path;
    throw FileError(recording_.path, object_, object_.empty() ? "holds several sessions" : "is in none of the sessions",
                    "Name the object to read: " + shortened(list));
  }

  // The source that `object` names, or whose channel it names; null where it is the session or empty.
  const DataSource* named(const Session& session) {
    if (object_.empty() || matches(session.path, session.name, object_)) return nullptr;
    for (const auto& source : session.sources) {
      if (matches(source.path, source.name, object_)) return &source;
      for (const auto& channel : source.channels)
        if (matches(channel.path, channel.name, object_) || object_ == channel.data) {
          channel_ = channel.path;
          return &source;
        }
    }
    throw FileError(recording_.path, object_, "is neither a session, nor a data source, nor a channel",
                    "Its channels are " + channelList(session));
  }

  // The highest rate: by the frequency that is stated, or by the number of samples where one source states none.
  const DataSource* fastest(const Session& session) {
    std::vector<std::pair<const DataSource*, double>> found;
    bool stated = true;
    for (const auto& source : session.sources) {
      const auto first = std::find_if(source.channels.begin(), source.channels.end(), [](const Channel& channel) {
        return isAcceleration(channel) && isOverTime(channel);
      });
      if (first == source.channels.end() || source.samples < 2) continue;
      found.emplace_back(&source, first->frequency);
      stated = stated && first->frequency > 0;
    }
    if (found.empty()) refuseChannels(session);
    const auto slower = [stated](const auto& a, const auto& b) {
      if (stated && a.second != b.second) return a.second < b.second;
      return a.first->samples < b.first->samples;
    };
    const auto best = std::max_element(found.begin(), found.end(), slower);
    std::string others;
    for (const auto& one : found)
      if (one.first != best->first) others += (others.empty() ? "" : ", ") + one.first->path;
    if (!others.empty())
      chosen_.notes.push_back("read: " + best->first->path + ", the fastest; passed over: " + shortened(others));
    return best->first;
  }

  [[noreturn]] void refuseChannels(const Session& session) const {
    const bool spaced = std::any_of(session.sources.begin(), session.sources.end(), [](const DataSource& source) {
      return std::any_of(source.channels.begin(), source.channels.end(),
                         [](const Channel& one) { return isAcceleration(one) && !isOverTime(one); });
    });
    if (spaced)
      throw FileError(recording_.path, session.path, "has accelerations at equal distances or at events alone",
                      "Samples over time are read (TriggerMode TIME); or name a channel to read it nevertheless");
    throw FileError(recording_.path, session.path, "has no channel of accelerations",
                    "Name a channel to read; there are " + channelList(session));
  }

  const Recording& recording_;
  std::string object_, channel_;
  ChosenSource chosen_;
};

}  // namespace

bool isAcceleration(const Channel& channel) {
  const auto* unit = text::findUnit(text::bareUnit(channel.unit));
  return unit ? unit->si == "m/s2" : channel.unit.empty() && namesAcceleration(channel.name);
}

bool isSpeed(const Channel& channel) {
  const auto* unit = text::findUnit(text::bareUnit(channel.unit));
  return unit && unit->si == "m/s" && text::siUnitOfName(channel.name) == "m/s";
}

ChosenSource chooseSource(const Recording& recording, const std::string& object) {
  return SourceChooser(recording, object).choose();
}

}  // namespace squat::rcmdx
