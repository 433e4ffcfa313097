#include "detection/CandidateFile.h"

#include <array>
#include <concepts>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "case/ShortHash.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "results/TreeStream.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::detection {
namespace {

// CBOR (RFC 8949) behind a line with name, version of the layout, and checksum: small, and exact for every number.
using PlainJson = nlohmann::json;
constexpr const char* kMagic = "squat-candidates 3 ";
constexpr std::size_t kLargestFile = std::size_t{1} << 30;
constexpr const char* kAdvice = "Delete the file and compute its record again";

template <typename Value, typename Type>
concept Is = std::same_as<std::remove_const_t<Value>, Type>;

// The fields of each type, once for both directions.
void fields(auto& visit, Is<records::RecordChannel> auto& value) {
  visit("name", value.name);
  visit("unit", value.unit);
}
void fields(auto& visit, Is<records::RecordLayout> auto& value) {
  visit("path", value.path);
  visit("channels", value.channels);
  visit("rate", value.rate);
  visit("samples", value.samples);
  visit("hasPosition", value.hasPosition);
  visit("falling", value.falling);
  visit("hasCoordinates", value.hasCoordinates);
  visit("notes", value.notes);
}
void fields(auto& visit, Is<records::RecordFault> auto& value) {
  visit("kind", value.kind);
  visit("first", value.first);
  visit("end", value.end);
  visit("time", value.time);
  visit("position", value.position);
  visit("channel", value.channel);
  visit("text", value.text);
  visit("advice", value.advice);
}
void fields(auto& visit, Is<signals::TimeSeries> auto& value) {
  visit("start", value.start);
  visit("step", value.step);
  visit("values", value.values);
  visit("name", value.name);
  visit("unit", value.unit);
}
void fields(auto& visit, Is<EventFeatures> auto& value) {
  visit("speed", value.speed);
  visit("energy", value.energy);
  visit("noise", value.noise);
  visit("freedom", value.freedom);
  visit("before", value.before);
  visit("reach", value.reach);
  visit("wavelength", value.wavelength);
}
void fields(auto& visit, Is<FirstArrival> auto& value) {
  visit("energy", value.energy);
  visit("noise", value.noise);
}
// As found: what judging adds is not kept.
void fields(auto& visit, Is<Event> auto& value) {
  visit("channel", value.channel);
  visit("unit", value.unit);
  visit("time", value.time);
  visit("position", value.position);
  visit("travelled", value.travelled);
  visit("latitude", value.latitude);
  visit("longitude", value.longitude);
  visit("score", value.score);
  visit("peak", value.peak);
  visit("features", value.features);
  visit("arrival", value.arrival);
  visit("otherPeak", value.otherPeak);
  visit("passage", value.passage);
}
void fields(auto& visit, Is<Axle> auto& value) {
  visit("left", value.left);
  visit("right", value.right);
}
void fields(auto& visit, Is<Piece> auto& value) {
  visit("position", value.position);
  visit("rms", value.rms);
  visit("peak", value.peak);
  visit("evidence", value.evidence);
}
void fields(auto& visit, Is<WavyStretch> auto& value) {
  visit("time", value.time);
  visit("from", value.from);
  visit("to", value.to);
  visit("wavelength", value.wavelength);
  visit("shortest", value.shortest);
  visit("longest", value.longest);
  visit("share", value.share);
  visit("slowest", value.slowest);
  visit("fastest", value.fastest);
}
void fields(auto& visit, Is<ChannelDetection> auto& value) {
  visit("name", value.name);
  visit("events", value.events);
  visit("pieces", value.pieces);
  visit("waves", value.waves);
}
void fields(auto& visit, Is<RecordDetection> auto& value) {
  visit("layout", value.layout);
  visit("channels", value.channels);
  visit("axles", value.axles);
  visit("faults", value.faults);
  visit("notes", value.notes);
  visit("duration", value.duration);
  visit("length", value.length);
}
void fields(auto& visit, Is<CandidateKey> auto& value) {
  visit("record", value.record);
  visit("settings", value.settings);
  visit("bytes", value.bytes);
  visit("ends", value.ends);
}

struct AnyVisitor {
  void operator()(const char*, auto&) {}
};
template <typename Value>
concept HasFields = requires(AnyVisitor& visit, Value& value) {
  fields(visit, value);
};

template <typename Value>
concept IsList = requires {
  typename Value::value_type;
}
&&!std::same_as<Value, std::string>;

template <typename Value>
concept IsOptional = requires(Value& value) {
  value.has_value();
};

template <typename Value>
PlainJson saved(const Value& value);

struct Saver {
  PlainJson json = PlainJson::object();
  template <typename Value>
  void operator()(const char* name, const Value& value) {
    json[name] = saved(value);
  }
};

template <typename Value>
PlainJson saved(const Value& value) {
  if constexpr (HasFields<const Value>) {
    Saver saver;
    fields(saver, value);
    return std::move(saver.json);
  } else if constexpr (IsOptional<Value>) {
    return value ? saved(*value) : PlainJson();
  } else if constexpr (IsList<Value>) {
    PlainJson list = PlainJson::array();
    for (const auto& each : value) list.push_back(saved(each));
    return list;
  } else if constexpr (std::is_enum_v<Value>) {
    return static_cast<int>(value);
  } else {
    return value;
  }
}

template <typename Value>
void load(const PlainJson& json, Value& value);

struct Loader {
  const PlainJson& json;
  template <typename Value>
  void operator()(const char* name, Value& value) {
    load(json.at(name), value);
  }
};

template <typename Value>
void load(const PlainJson& json, Value& value) {
  if constexpr (HasFields<Value>) {
    Loader loader{json};
    fields(loader, value);
  } else if constexpr (IsOptional<Value>) {
    if (json.is_null())
      value.reset();
    else
      load(json, value.emplace());
  } else if constexpr (IsList<Value>) {
    if constexpr (requires { value.resize(1); }) value.resize(json.size());
    for (std::size_t i = 0; i < value.size(); ++i) load(json.at(i), value[i]);
  } else if constexpr (std::is_enum_v<Value>) {
    value = static_cast<Value>(json.get<int>());
  } else {
    value = json.get<Value>();
  }
}

std::string checksumOf(const std::string& bytes) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", results::crc32(std::as_bytes(std::span(bytes))));
  return text;
}

std::string settingsText(const records::RecordOptions& read, const DetectOptions& options) {
  const auto& columns = read.columns;
  std::string all = "threshold " + text::numberText(options.threshold);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) all += std::string(", ") + name + " " + value;
  };
  if (options.leastShare != 0.9) add("least share", text::numberText(options.leastShare));
  if (options.axles && options.axles->empty()) add("axle", "none");
  if (options.axles)
    for (const auto& [left, right] : *options.axles) add("axle", text::csvField(left) + "," + text::csvField(right));
  add("column", columns.column);
  add("time column", columns.timeColumn);
  add("position column", columns.positionColumn);
  add("speed column", columns.speedColumn);
  add("run column", columns.runColumn);
  add("object", columns.object);
  for (const auto& [column, unit] : columns.units) add("unit", column + "=" + unit);
  add("signal unit", columns.signalUnit);
  add("time unit", columns.timeUnit);
  if (columns.headLine > 0) add("head line", std::to_string(columns.headLine));
  if (columns.rate > 0) add("rate", text::numberText(columns.rate));
  if (columns.speed > 0) add("speed", text::numberText(columns.speed));
  if (columns.delimiter != 0) add("delimiter", std::string(1, columns.delimiter));
  if (columns.decimal != 0) add("decimal", std::string(1, columns.decimal));
  if (read.chainage) add("chainage", text::numberText(*read.chainage));
  return all;
}

[[noreturn]] void refuse(const std::string& path, const std::string& found, const std::string& now) {
  throw CaseError({{"-o", path, "candidates of this call and version",
                    "They were found with \"" + found + "\", this call has \"" + now +
                        "\": repeat that call, or choose another folder"}});
}

}  // namespace

CandidateKey candidateKey(const std::string& record, const records::RecordOptions& read, const DetectOptions& options) {
  constexpr std::size_t end = std::size_t{64} << 10;
  CandidateKey key{record, settingsText(read, options), 0, {}};
  std::error_code failure;
  key.bytes = std::filesystem::file_size(record, failure);
  std::ifstream file(record, std::ios::binary);
  if (failure || !file) throw FileError(record, "", "cannot be read", "Check the name and the permissions");
  std::string bytes(std::min<std::uintmax_t>(key.bytes, end), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  key.ends = cases::shortHash(bytes);
  file.seekg(-static_cast<std::streamoff>(bytes.size()), std::ios::end);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  key.ends += cases::shortHash(bytes);
  return key;
}

std::string candidateFile(const std::string& folder, const std::string& record) {
  return folder + "/candidates/" + std::filesystem::path(record).stem().string() + "-" + cases::shortHash(record) +
         ".candidates";
}

void writeCandidates(const std::string& folder, const CandidateKey& key, const RecordDetection& detection) {
  makeFolder(folder + "/candidates");
  const PlainJson json{{"version", programVersion()}, {"key", saved(key)}, {"detection", saved(detection)}};
  std::string bytes;
  PlainJson::to_cbor(json, bytes);
  writeDurably(candidateFile(folder, key.record), kMagic + checksumOf(bytes) + "\n" + bytes);
}

std::optional<RecordDetection> readCandidates(const std::string& folder, const CandidateKey& key) {
  const auto path = candidateFile(folder, key.record);
  if (!std::filesystem::exists(path)) return std::nullopt;
  const auto content = readWholeFile(path, kLargestFile);
  const auto line = content.find('\n');
  const std::string bytes = line == std::string::npos ? "" : content.substr(line + 1);
  if (content.substr(0, line) != kMagic + checksumOf(bytes)) throw FileError(path, "", "is damaged", kAdvice);
  try {
    const auto json = PlainJson::from_cbor(bytes);
    CandidateKey found;
    load(json.at("key"), found);
    const auto version = json.at("version").get<std::string>();
    if (version != programVersion()) refuse(path, "squat " + version, std::string("squat ") + programVersion());
    if (found.settings != key.settings) refuse(path, found.settings, key.settings);
    if (found.bytes != key.bytes || found.ends != key.ends) return std::nullopt;
    RecordDetection detection;
    load(json.at("detection"), detection);
    return detection;
  } catch (const PlainJson::exception&) {
    throw FileError(path, "", "is damaged", kAdvice);
  }
}

}  // namespace squat::detection
