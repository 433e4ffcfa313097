#include "project/ProjectFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <span>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "project/JsonNode.h"
#include "project/MeasuredRecords.h"
#include "project/ViewsInFile.h"

namespace squat::project {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* schemaName = "squat-project";
constexpr std::size_t largestProjectFile = 64U << 20U;  // [bytes]
constexpr double farthest = 1e12;                       // [m]

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
  if (entry.isAutomatic) json["automatic"] = true;
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

Json jsonOf(const LongRecords& records, const std::string& folder) {
  Json files = Json::array(), seen = Json::array();
  for (const auto& file : records.files) files.push_back(linkOf(file, folder));
  for (const auto& each : records.seen)
    seen.push_back({{"position", each.position}, {"channel", each.channel}, {"seen_as", each.seenAs}});
  Json json{{"files", files},
            {"channels", records.channels},
            {"chainage", records.chainage},
            {"speed", records.speed},
            {"own_vehicle", records.ownVehicle},
            {"labels", linkOf(records.labels, folder)},
            {"events", linkOf(records.events, folder)},
            {"seen", seen}};
  const auto isKnown = [](const std::string& digest) { return !digest.empty(); };
  if (std::any_of(records.digests.begin(), records.digests.end(), isKnown)) json["digests"] = records.digests;
  if (!records.units.empty()) json["units"] = records.units;
  if (!records.together.empty()) json["together"] = records.together;
  if (!records.axles.empty()) json["axles"] = records.axles;
  if (records.order != TableOrder()) json["order"] = jsonOf(records.order);
  return json;
}

bool isHexadecimal(const std::string& text, std::size_t from) {
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(),
                     [](unsigned char each) { return std::isxdigit(each) != 0; });
}

std::string digestIn(const JsonNode& node) {
  std::string digest = node.text();
  if (!digest.empty() && (digest.size() != 8 || !isHexadecimal(digest, 0)))
    node.fail("is not eight hexadecimal digits");
  return digest;
}

std::string colourIn(const JsonNode& node) {
  std::string colour = node.text();
  if (!colour.empty() && (colour.size() != 7 || colour[0] != '#' || !isHexadecimal(colour, 1)))
    node.fail("is not a colour such as #0072b2");
  return colour;
}

std::string linkIn(const JsonNode& node, const std::string& folder) {
  const std::string link = node.text();
  if (link.empty() || link.find('\0') != std::string::npos) node.fail("is not a path");
  return pathOf(link, folder);
}

std::string optionalLinkIn(const JsonNode& node, const std::string& folder) {
  return node.text().empty() ? std::string() : linkIn(node, folder);
}

readers::SignalFileOptions readingIn(const JsonNode& node) {
  constexpr double highest = 1e12;
  readers::SignalFileOptions options;
  options.column = node.at("column").text();
  options.timeColumn = node.at("time_column").text();
  options.positionColumn = node.at("position_column").text();
  options.speedColumn = node.at("speed_column").text();
  options.runColumn = node.at("run_column").text();
  options.object = node.at("object").text();
  options.rate = node.at("rate").number(0, highest);
  options.speed = node.at("speed").number(0, highest);
  options.delimiter = node.at("delimiter").letter();
  options.decimal = node.at("decimal").letter();
  return options;
}

Entry entryIn(const JsonNode& node, const std::string& folder) {
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
  entry.impact = node.at("impact").number(-farthest, farthest);
  if (node.has("gain")) entry.gain = node.at("gain").number(minimumGain, maximumGain);
  if (node.has("automatic")) entry.isAutomatic = node.at("automatic").flag();
  entry.reading = readingIn(node.at("reading"));
  return entry;
}

std::vector<std::string> digestsIn(const JsonNode& node, std::size_t count) {
  std::vector<std::string> digests;
  for (const auto& digest : node.list()) digests.push_back(digestIn(digest));
  if (digests.size() != count)
    node.fail("has " + std::to_string(digests.size()) + " entries, not one for each of " + std::to_string(count) +
              " files");
  return digests;
}

LongRecords recordsIn(const JsonNode& node, const std::string& folder) {
  constexpr double fastest = 1e6;  // [m/s]
  LongRecords records;
  for (const auto& file : node.at("files").list()) records.files.push_back(linkIn(file, folder));
  records.channels = node.at("channels").text();
  records.chainage = node.at("chainage").text();
  records.speed = node.at("speed").number(0, fastest);
  if (node.has("units")) records.units = node.at("units").text();
  if (node.has("together")) records.together = node.at("together").text();
  if (!records.together.empty() && records.together != "ride" && records.together != "passes")
    node.at("together").fail("must be ride or passes");
  if (node.has("axles")) records.axles = node.at("axles").text();
  records.ownVehicle = node.at("own_vehicle").flag();
  records.labels = optionalLinkIn(node.at("labels"), folder);
  records.events = optionalLinkIn(node.at("events"), folder);
  constexpr std::size_t maximumSeen = 1000000;
  for (const auto& seen : node.at("seen").list(maximumSeen))
    records.seen.push_back(
        {seen.at("position").number(-farthest, farthest), seen.at("channel").text(), seen.at("seen_as").text()});
  if (node.has("digests")) records.digests = digestsIn(node.at("digests"), records.files.size());
  if (node.has("order")) records.order = orderIn(node.at("order"));
  return records;
}

OpenCase openCaseIn(const JsonNode& node, const std::string& folder) {
  OpenCase open;
  open.name = node.at("name").text();
  open.path = optionalLinkIn(node.at("path"), folder);
  open.modified = node.at("modified").flag();
  open.toml = node.at("toml").text();
  try {
    cases::parseUnfinishedCase(open.toml, "the case");
  } catch (const std::exception& error) {
    node.at("toml").fail(std::string("is not a case: ") + error.what());
  }
  return open;
}

void requireSchema(const JsonNode& root) {
  if (root.at("schema").text() != schemaName) root.at("schema").fail("is not a project of this program");
  const int version = root.at("schema_version").whole(1, 1 << 30);
  if (version > projectSchema)
    root.at("schema_version")
        .fail("is " + std::to_string(version) + "; this version of the program reads up to " +
              std::to_string(projectSchema) + ": use a newer one");
}

// The lowest version whose readers lose nothing of the project.
int versionOf(const Project& project) {
  if (!project.records.files.empty()) return 3;
  const bool hasGain =
      std::any_of(project.entries.begin(), project.entries.end(), [](const Entry& entry) { return entry.gain != 1; });
  return hasGain ? 2 : 1;
}

}  // namespace

std::string projectText(const Project& project, const std::string& folder) {
  Json cases = Json::array(), runs = Json::array();
  for (const auto& path : project.cases) cases.push_back(linkOf(path, folder));
  for (const auto& entry : project.entries) runs.push_back(jsonOf(entry, folder));
  const auto& open = project.open;
  Json json{
      {"schema", schemaName},
      {"schema_version", versionOf(project)},
      {"code_version", programVersionText()},
      {"open_case",
       {{"name", open.name}, {"path", linkOf(open.path, folder)}, {"modified", open.modified}, {"toml", open.toml}}},
      {"cases", cases},
      {"runs", runs},
      {"current", project.current},
      {"reference", project.reference},
      {"notes", project.notes},
      {"views", project.views}};
  if (project.figures) json["figures"] = jsonOf(*project.figures);
  if (!project.records.files.empty()) json["records"] = jsonOf(project.records, folder);
  if (project.runOrder != TableOrder()) json["run_order"] = jsonOf(project.runOrder);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Project parseProject(const std::string& text, const std::string& origin, const std::string& folder) {
  const Json json = parsedJson(text, origin, "Open an earlier copy of the project");
  const std::string advice = "Correct it there, or open an earlier copy of the project";
  const JsonNode root(json, origin, advice);
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
  if (root.has("figures")) project.figures = figuresIn(root.at("figures"));
  if (root.has("records")) project.records = recordsIn(root.at("records"), folder);
  if (root.has("run_order")) project.runOrder = orderIn(root.at("run_order"));
  return project;
}

void writeProject(const std::string& path, const Project& project) {
  const std::string text = projectText(project, folderOf(path));
  writeDurably(path, std::as_bytes(std::span(text)), [&](const std::string& written) {
    parseProject(readWholeFile(written, largestProjectFile), path, folderOf(path));
  });
}

Project readProject(const std::string& path) {
  return parseProject(readWholeFile(path, largestProjectFile), path, folderOf(path));
}

}  // namespace squat::project
