#include "project/ProjectFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "project/MeasuredRecords.h"
#include "text/Numbers.h"

namespace squat::project {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* schemaName = "squat-project";
constexpr std::size_t largestFile = 64U << 20U;  // [bytes]
constexpr std::size_t mostEntries = 10000;

std::string linkOf(const std::string& path, const std::string& folder) {
  if (path.empty()) return {};
  const fs::path file(path), base(folder);
  const auto below = [](const fs::path& absolute) { return *std::next(absolute.begin(), 1); };
  const bool near = file.is_absolute() && base.is_absolute() && std::distance(base.begin(), base.end()) > 1 &&
                    std::distance(file.begin(), file.end()) > 1 && below(file) == below(base);
  return near ? file.lexically_relative(base).generic_string() : path;
}

std::string pathOf(const std::string& link, const std::string& folder) {
  return link.empty() ? std::string() : (fs::path(folder) / link).lexically_normal().string();
}

std::string folderOf(const std::string& path) { return fs::absolute(path).parent_path().lexically_normal().string(); }

std::string letter(char each) { return each == 0 ? std::string() : std::string(1, each); }

Json jsonOf(const Entry& entry, const std::string& folder) {
  Json json{{"kind", entry.kind == Kind::run ? "run" : "measured"},
            {"path", linkOf(entry.path, folder)},
            {"digest", entry.digest},
            {"name", entry.name},
            {"named", entry.named},
            {"overlaid", entry.overlaid},
            {"colour", entry.colour}};
  if (entry.kind == Kind::run) return json;
  const auto& reading = entry.reading;
  json["signal"] = entry.signal;
  json["impact"] = entry.impact;
  if (entry.gain != 1) json["gain"] = entry.gain;
  json["reading"] = {{"column", reading.column},
                     {"time_column", reading.timeColumn},
                     {"position_column", reading.positionColumn},
                     {"speed_column", reading.speedColumn},
                     {"run_column", reading.runColumn},
                     {"object", reading.object},
                     {"rate", reading.rate},
                     {"speed", reading.speed},
                     {"delimiter", letter(reading.delimiter)},
                     {"decimal", letter(reading.decimal)}};
  return json;
}

// A value of the file with its place in it: whoever reads it says where it is wrong.
class Node {
 public:
  Node(const Json& json, std::string place, const std::string& origin)
      : json_(json), place_(std::move(place)), origin_(origin) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(origin_, place_.empty() ? "the whole file" : place_, what,
                    "Correct it there, or open an earlier copy of the project");
  }
  Node at(const char* key) const {
    if (!json_.is_object()) fail("is not a table of keys and values");
    const auto found = json_.find(key);
    if (found == json_.end()) fail(std::string("lacks the key '") + key + "'");
    return {*found, place_ + "/" + key, origin_};
  }
  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  std::vector<Node> list() const {
    if (!json_.is_array()) fail("is not a list");
    if (json_.size() > mostEntries) fail("has more than " + std::to_string(mostEntries) + " entries");
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < json_.size(); ++i)
      nodes.push_back({json_[i], place_ + "/" + std::to_string(i), origin_});
    return nodes;
  }
  std::string text() const {
    if (!json_.is_string()) fail("is not a text");
    return json_.get<std::string>();
  }
  bool flag() const {
    if (!json_.is_boolean()) fail("is neither true nor false");
    return json_.get<bool>();
  }
  double number(double lowest, double highest) const {
    const double value = json_.is_number() ? json_.get<double>() : NAN;
    if (!(value >= lowest && value <= highest))
      fail("is " + (json_.is_number() ? json_.dump() : std::string(json_.type_name())) + ", not a number from " +
           text::roundedText(lowest) + " to " + text::roundedText(highest));
    return value;
  }
  int whole(int lowest, int highest) const {
    const double value = number(lowest, highest);
    if (value != std::floor(value)) fail("is not a whole number");
    return static_cast<int>(value);
  }
  char letter() const {
    const std::string value = text();
    if (value.size() > 1) fail("has more than one letter");
    return value.empty() ? '\0' : value[0];
  }

 private:
  const Json& json_;
  std::string place_;
  const std::string& origin_;
};

bool isHexadecimal(const std::string& text, std::size_t from) {
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(),
                     [](unsigned char each) { return std::isxdigit(each) != 0; });
}

std::string digestIn(const Node& node) {
  std::string digest = node.text();
  if (!digest.empty() && (digest.size() != 8 || !isHexadecimal(digest, 0)))
    node.fail("is not eight hexadecimal digits");
  return digest;
}

std::string colourIn(const Node& node) {
  std::string colour = node.text();
  if (!colour.empty() && (colour.size() != 7 || colour[0] != '#' || !isHexadecimal(colour, 1)))
    node.fail("is not a colour such as #0072b2");
  return colour;
}

std::string linkIn(const Node& node, const std::string& folder) {
  const std::string link = node.text();
  if (link.empty() || link.find('\0') != std::string::npos) node.fail("is not a path");
  return pathOf(link, folder);
}

readers::SignalFileOptions readingIn(const Node& node) {
  constexpr double most = 1e12;
  readers::SignalFileOptions options;
  options.column = node.at("column").text();
  options.timeColumn = node.at("time_column").text();
  options.positionColumn = node.at("position_column").text();
  options.speedColumn = node.at("speed_column").text();
  options.runColumn = node.at("run_column").text();
  options.object = node.at("object").text();
  options.rate = node.at("rate").number(0, most);
  options.speed = node.at("speed").number(0, most);
  options.delimiter = node.at("delimiter").letter();
  options.decimal = node.at("decimal").letter();
  return options;
}

Entry entryIn(const Node& node, const std::string& folder) {
  constexpr double most = 1e12;  // [m]
  Entry entry;
  const std::string kind = node.at("kind").text();
  if (kind != "run" && kind != "measured") node.at("kind").fail("is neither \"run\" nor \"measured\"");
  entry.kind = kind == "run" ? Kind::run : Kind::measured;
  entry.path = linkIn(node.at("path"), folder);
  entry.digest = digestIn(node.at("digest"));
  entry.name = node.at("name").text();
  entry.named = node.at("named").flag();
  entry.overlaid = node.at("overlaid").flag();
  entry.colour = colourIn(node.at("colour"));
  if (entry.kind == Kind::run) return entry;
  entry.signal = node.at("signal").text();
  entry.impact = node.at("impact").number(-most, most);
  if (node.has("gain")) entry.gain = node.at("gain").number(leastGain, mostGain);
  entry.reading = readingIn(node.at("reading"));
  return entry;
}

OpenCase openCaseIn(const Node& node, const std::string& folder) {
  OpenCase open;
  open.name = node.at("name").text();
  open.path = node.at("path").text().empty() ? std::string() : linkIn(node.at("path"), folder);
  open.modified = node.at("modified").flag();
  open.toml = node.at("toml").text();
  try {
    cases::parseUnfinishedCase(open.toml, "the case");
  } catch (const std::exception& error) {
    node.at("toml").fail(std::string("is not a case: ") + error.what());
  }
  return open;
}

// Line and column of a byte, counted from 1.
std::string placeOf(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto start = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return "line " + std::to_string(line) + ", column " + std::to_string(1 + (end - start));
}

void requireSchema(const Node& root) {
  if (root.at("schema").text() != schemaName) root.at("schema").fail("is not a project of this program");
  const int version = root.at("schema_version").whole(1, 1 << 30);
  if (version > projectSchema)
    root.at("schema_version")
        .fail("is " + std::to_string(version) + "; this version of the program reads up to " +
              std::to_string(projectSchema) + ": use a newer one");
}

bool hasGain(const Project& project) {
  return std::any_of(project.entries.begin(), project.entries.end(),
                     [](const Entry& entry) { return entry.gain != 1; });
}

}  // namespace

std::string projectText(const Project& project, const std::string& folder) {
  Json cases = Json::array(), runs = Json::array();
  for (const auto& path : project.cases) cases.push_back(linkOf(path, folder));
  for (const auto& entry : project.entries) runs.push_back(jsonOf(entry, folder));
  const auto& open = project.open;
  const Json json{
      {"schema", schemaName},
      {"schema_version", hasGain(project) ? projectSchema : 1},
      {"code_version", programVersionText()},
      {"open_case",
       {{"name", open.name}, {"path", linkOf(open.path, folder)}, {"modified", open.modified}, {"toml", open.toml}}},
      {"cases", cases},
      {"runs", runs},
      {"current", project.current},
      {"reference", project.reference},
      {"notes", project.notes},
      {"views", project.views}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Project parseProject(const std::string& text, const std::string& origin, const std::string& folder) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw FileError(origin, placeOf(text, error.byte), "is not JSON, or was cut off here",
                    "Open an earlier copy of the project");
  }
  const Node root(json, "", origin);
  requireSchema(root);
  Project project;
  project.open = openCaseIn(root.at("open_case"), folder);
  for (const auto& node : root.at("cases").list()) project.cases.push_back(linkIn(node, folder));
  for (const auto& node : root.at("runs").list()) project.entries.push_back(entryIn(node, folder));
  const int last = static_cast<int>(project.entries.size()) - 1;
  project.current = root.at("current").whole(-1, last);
  project.reference = root.at("reference").whole(-1, last);
  if (project.current >= 0 && project.entries[static_cast<std::size_t>(project.current)].kind != Kind::run)
    root.at("current").fail("is a measured signal; it must be a run");
  project.notes = root.at("notes").text();
  for (const auto& node : root.at("views").list()) project.views.push_back(node.text());
  return project;
}

void writeProject(const std::string& path, const Project& project) {
  const std::string text = projectText(project, folderOf(path));
  writeDurably(path, std::as_bytes(std::span(text)), [&](const std::string& written) {
    parseProject(readWholeFile(written, largestFile), path, folderOf(path));
  });
}

Project readProject(const std::string& path) {
  return parseProject(readWholeFile(path, largestFile), path, folderOf(path));
}

}  // namespace squat::project
