#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "rcmdx/EventsToWrite.h"
#include "rcmdx/Recording.h"
#include "rcmdx/SpecifiedColumns.h"
#include "rcmdx/TypedFile.h"
#include "results/Hdf5.h"
#include "text/Text.h"
#include "text/Utf8Text.h"

namespace squat::rcmdx {
namespace {

constexpr std::int16_t majorVersion = 2, minorVersion = 0, featureVersion = 4;

// A name of a group: no slash, nothing that other programs would have to quote.
std::string groupName(const std::string& text, const std::string& otherwise) {
  std::string name;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += plain || c == '_' || c == '-' || c == '.' ? c : '_';
  }
  return name.empty() || name == "." || name == ".." ? otherwise : name;
}

std::string uniqueName(std::set<std::string>& taken, const std::string& name) {
  std::string own = name;
  for (int number = 2; !taken.insert(own).second; ++number) own = name + "_" + std::to_string(number);
  return own;
}

Cell textCell(const std::string& text) { return text::asUtf8(text); }

class RcmDxWriter {
 public:
  RcmDxWriter(const std::string& path, const EventsToWrite& events) : file_(path), given_(events) {
    for (const auto& event : events.events) sorted_.push_back(&event);
    std::stable_sort(sorted_.begin(), sorted_.end(), [](const auto* a, const auto* b) { return a->time < b->time; });
    start_ = events.start, end_ = events.end;
    for (const auto& [time, place] : events.way) include(time, place);
    for (const auto* event : sorted_) include(event->time, event->place);
    for (const auto* event : sorted_) end_ = std::max(end_, event->time + event->duration);
    platform_ = groupName(events.platform, "UNKNOWN");
    system_ = platform_ + "." + groupName(events.system, "SQUATS");
    source_ = system_ + ".EVENTS";
    session_ = "/RCMDX/" + platform_ + "/" + sessionName(start_);
    nameChannels();
  }

  std::vector<std::byte> bytes() {
    writeRoot();
    writeSession();
    writeSystem();
    writePositions(file_, session_, way_);
    writeSections(file_, session_, way_, start_, given_);
    writeEvents();
    return file_.bytes();
  }

 private:
  void include(std::int64_t time, const Place& place) {
    way_[time] = place;
    start_ = start_ == 0 ? time : std::min(start_, time);
    end_ = std::max(end_, time);
  }

  void nameChannels() {
    std::set<std::string> taken{"LATITUDE", "LONGITUDE", "timestamp"};
    channels_ = given_.channels;
    if (channels_.empty()) channels_.push_back({"EVENT", "", "TOTAL", "", 0});  // a data source has one at least
    for (const auto& channel : channels_) names_.push_back(uniqueName(taken, groupName(channel.name, "CHANNEL")));
    for (const auto* event : sorted_)
      if (!event->channel.empty() && indexOf(event->channel) == channels_.size())
        throw CaseError({{"channel", event->channel, "one of the channels that are written", "List the channel"}});
  }

  std::size_t indexOf(const std::string& channel) const {
    for (std::size_t c = 0; c < channels_.size(); ++c)
      if (channels_[c].name == channel) return c;
    return channels_.size();
  }

  // "DFZ00.SQUATS.EVENTS.ABA_LEFT", as SBB names channels; empty where there is none.
  std::string fullName(const std::string& channel) const {
    const auto c = indexOf(channel);
    return c == channels_.size() ? std::string() : source_ + "." + names_[c];
  }

  void writeRoot() {
    file_.group("/RCMDX");
    file_.attribute("/RCMDX", "Major", majorVersion);
    file_.attribute("/RCMDX", "Minor", minorVersion);
    file_.attribute("/RCMDX", "Feature", featureVersion);
    writeElement(file_, "/RCMDX/FILE", "File");
    file_.attribute("/RCMDX/FILE", "StructureVersion", std::string("1"));
    const std::string processing = "/RCMDX/FILE/DATAPROCESSING", log = processing + "/PROCESSINGLOG";
    const std::int64_t written = given_.written != 0 ? given_.written : end_;
    file_.group(processing);
    writeElement(file_, log, "ProcessingLog");
    const auto entry = [&](const std::string& name, const std::string& value) {
      file_.dataset(name, std::vector<std::string>{text::asUtf8(value)});
    };
    entry(log + "/type", "CREATION");
    file_.dataset(log + "/timestamp", std::vector<std::int64_t>{written});
    for (const char* name : {"service", "executable"}) entry(log + "/" + name, given_.program);
    for (const char* name : {"serviceUser", "user"}) entry(log + "/" + name, given_.user);
    entry(log + "/host", given_.host);
    entry(log + "/message", "events found by a program, not yet reviewed");
    const std::string clearance = processing + "/CLEARANCE";
    writeElement(file_, clearance, "Clearance");
    entry(clearance + "/clearance", "PENDING");
    file_.dataset(clearance + "/timestamp", std::vector<std::int64_t>{written});
    entry(clearance + "/user", given_.user);
  }

  void writeSession() {
    const std::string platform = "/RCMDX/" + platform_;
    writeElement(file_, platform, "Platform");
    file_.attribute(platform, "VehicleNumber", textCell(given_.vehicleNumber));
    writeElement(file_, session_, "Session");
    file_.attribute(session_, "StartTime", static_cast<std::uint64_t>(start_));
    file_.attribute(session_, "EndTime", static_cast<std::uint64_t>(end_));
    if (!given_.alias.empty()) file_.attribute(session_, "SessionAlias", textCell(given_.alias));
    file_.group(session_ + "/CONFIGURATION");
    writeTopology(file_, session_ + "/CONFIGURATION/TOPOLOGY", given_);
  }

  // One sample an event: its largest value, in the channel where it was found.
  void writeSystem() {
    const std::string system = session_ + "/" + system_, source = system + "/" + source_;
    writeElement(file_, system, "System");
    file_.group(system + "/CONFIGURATION");
    writeElement(file_, source, "Datasource");
    file_.dataset(source + "/timestamp", times());
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      std::vector<double> peaks;
      for (const auto* event : sorted_)
        peaks.push_back(indexOf(event->channel) == c ? event->peak : std::numeric_limits<double>::quiet_NaN());
      writeChannel(source, names_[c], channels_[c], peaks);
    }
    std::vector<double> latitude, longitude;
    for (const auto* event : sorted_) latitude.push_back(event->latitude), longitude.push_back(event->longitude);
    if (std::none_of(latitude.begin(), latitude.end(), [](double value) { return std::isfinite(value); })) return;
    writeChannel(source, "LATITUDE", {"LATITUDE", "deg", "TOTAL", "", 0}, latitude);
    writeChannel(source, "LONGITUDE", {"LONGITUDE", "deg", "TOTAL", "", 0}, longitude);
  }

  void writeChannel(const std::string& source, const std::string& name, const ChannelToWrite& channel,
                    const std::vector<double>& values) {
    const std::string group = source + "/" + source_ + "." + name;
    writeElement(file_, group, "Channel");
    file_.attribute(group, "TriggerMode", std::string("EVENT"));
    file_.attribute(group, "CommonTriggerDistance", 0.0f);
    file_.attribute(group, "CommonTriggerFrequency", 0.0f);
    file_.attribute(group, "ChannelBasis", textCell(channel.basis));
    file_.attribute(group, "MeasurementType", std::string("MEASURED_VALUE"));
    file_.attribute(group, "Neighbor", fullName(channel.neighbour));
    file_.attribute(group, "PositionOffset", static_cast<float>(1e3 * channel.positionOffset));  // [mm]
    file_.dataset(group + "/data", values);
    // Of the dataset, by the chapter on arrays; of the channel, by the chapter on channels.
    for (const auto& object : {group + "/data", group}) file_.attribute(object, "Unit", textCell(channel.unit));
  }

  void writeEvents() {
    std::vector<std::string> systems(sorted_.size(), system_), channels, types(sorted_.size(), "Defect"), data;
    std::vector<std::int64_t> durations;
    for (const auto* event : sorted_) {
      channels.push_back(fullName(event->channel));
      data.push_back(defectXml(*event, given_));
      durations.push_back(event->duration);
    }
    const std::string group = session_ + "/EVENTS";
    writeElement(file_, group, "Events");
    const auto column = [&](const char* name, const Cells& cells) { writeColumn(file_, group, "events", name, cells); };
    column("systemref", systems);
    column("channelref", channels);
    column("eventtype", types);
    file_.link(group + "/eventtype", group + "/type");  // the specification names it both ways
    column("data", data);
    column("duration", durations);
    column("timestamp", times());
  }

  std::vector<std::uint64_t> times() const {
    std::vector<std::uint64_t> list;
    for (const auto* event : sorted_) list.push_back(static_cast<std::uint64_t>(event->time));
    return list;
  }

  TypedFile file_;
  const EventsToWrite& given_;
  std::vector<const EventToWrite*> sorted_;
  WayOfSession way_;
  std::int64_t start_ = 0, end_ = 0;
  std::string platform_, system_, source_, session_;
  std::vector<ChannelToWrite> channels_;
  std::vector<std::string> names_;  // of the channels' groups, without those above
};

}  // namespace

std::string sessionName(std::int64_t time) {
  using namespace std::chrono;
  const sys_time<milliseconds> moment{floor<milliseconds>(nanoseconds(time))};
  const auto day = floor<days>(moment);
  const year_month_day date(day);
  const hh_mm_ss<milliseconds> clock(moment - day);
  char text[64];
  std::snprintf(text, sizeof text, "%04d%02u%02u_%02d%02d%02d.%03d", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()), static_cast<int>(clock.subseconds().count()));
  return text;
}

void writeRcmDx(const std::string& path, const EventsToWrite& events) {
  // The writer holds the library's lock: it is gone before the file is read again.
  const auto bytes = RcmDxWriter(path, events).bytes();
  writeDurably(path, bytes, [&](const std::string& part) {
    results::Hdf5Limits limits;
    limits.skipForeign = true;
    const auto tree = results::readOwnHdf5(part, limits);
    if (!isRcmDx(tree) || recordingOf(part, tree).sessions.size() != 1)
      throw FileError(part, "", "does not read back as it was written");
  });
}

}  // namespace squat::rcmdx
