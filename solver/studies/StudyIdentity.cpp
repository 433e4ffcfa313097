#include "studies/StudyIdentity.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/platform/Process.h"
#include "studies/StudyTable.h"

namespace squat::studies {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kLargestIdentity = std::size_t{64} << 20;

std::string partsPath(const std::string& folder) { return folder + "/study-parts.json"; }

Json identityOf(const StudyDefinition& definition) {
  Json json{{"schema", "squat-study"},
            {"schema_version", 1},
            {"case", definition.caseName},
            {"case_hash", definition.caseHash},
            {"anchor", kStudyAnchor}};
  if (!definition.program.empty()) json["code_version"] = definition.program;
  if (!definition.work.empty()) json["work"] = definition.work;
  if (definition.isList) json["design"] = "list";
  json["vary"] = Json::array();
  for (const auto& variation : definition.variations)
    json["vary"].push_back({{"key", variation.key}, {"values", variation.values}});
  return json;
}

Json identityOfParts(const StudyDefinition& definition) {
  auto json = identityOf(definition);
  if (!definition.start.empty()) json["start"] = definition.start;
  return json;
}

std::string textOf(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json read(const std::string& path) {
  try {
    return Json::parse(readWholeFile(path, kLargestIdentity));
  } catch (const Json::exception&) {
    throw FileError(path, "", "is damaged", "Remove the folder, or choose another one with -o");
  }
}

// A study of an earlier version of the program has no version in it.
std::string versionIn(const Json& json) {
  const auto found = json.find("code_version");
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

[[noreturn]] void refuseFolder(const std::string& found, const std::string& allowed, const std::string& advice) {
  throw CaseError({{"-o", found, allowed, advice}});
}

bool isList(const Json& json) { return json.contains("design"); }
bool samePoints(const Json& one, const Json& other) {
  return isList(one) == isList(other) && one["vary"] == other["vary"];
}

// The case's name may differ (another path to the same file); hash, values and version count.
void requireSameStudy(const Json& found, const Json& own, const std::string& path) {
  if (!found.is_object() || !found.contains("case_hash") || !found.contains("vary"))
    throw FileError(path, "", "is not the file of a study", "Restore it, or choose another folder with -o");
  if (found["case_hash"] != own["case_hash"] || found.value("work", "") != own.value("work", ""))
    refuseFolder(path, "the file of the same case and values", "The folder holds another study: choose another one");
  if (const auto version = versionIn(found); !version.empty() && version != versionIn(own))
    refuseFolder(
        path + " of version " + version, "the file of this version of the program (" + versionIn(own) + ")",
        "Numbers of two versions do not belong into one table: use version " + version + ", or choose another folder");
}

std::set<std::string> pointsOf(const Json& identity) {
  StudyDefinition definition;
  definition.isList = isList(identity);
  for (const auto& variation : identity["vary"])
    definition.variations.push_back({variation.at("key"), variation.at("values")});
  std::set<std::string> points;
  for (const auto& point : gridOf(definition)) points.insert(toText(definition, point));
  return points;
}

// Whether all points of `earlier` are among those of `later`.
bool hasGrown(const Json& earlier, const Json& later, const std::string& path) {
  try {
    const auto before = pointsOf(earlier), now = pointsOf(later);
    return std::includes(now.begin(), now.end(), before.begin(), before.end());
  } catch (const Json::exception&) {
    throw FileError(path, "", "is not the file of a study", "Restore it, or choose another folder with -o");
  }
}

bool hasGrownByHash(const Json& found, const Json& own, const Partition& parts, const std::string& path) {
  if (parts.kind != Partition::Kind::hash || !hasGrown(found, own, path)) return false;
  if (found.contains("start") && own.contains("start") && found["start"] != own["start"])
    refuseFolder(
        path, "the file of a study on the same mesh",
        "The added points have a longer defect than the others, so that all runs get another mesh: choose another "
        "folder");
  return true;
}

// Under its name whole or not at all, and never over another file. False where one stands there.
bool writeFirst(const std::string& path, const std::string& text) {
  const auto beside = path + "." + platform::hostName() + "-" + std::to_string(platform::processNumber());
  writeDurably(beside, std::string_view(text));
  std::error_code linking;
  std::filesystem::create_hard_link(beside, path, linking);
  std::remove(beside.c_str());
  if (!linking || linking == std::errc::file_exists) return !linking;
  if (std::filesystem::exists(path)) return false;
  writeDurably(path, std::string_view(text));  // a file system without links
  return true;
}

}  // namespace

std::string identityPath(const std::string& folder) { return folder + "/study.json"; }

void writeIdentity(const StudyDefinition& definition, const std::string& folder) {
  const auto path = identityPath(folder), text = textOf(identityOf(definition));
  if (!std::filesystem::exists(path) || readWholeFile(path, kLargestIdentity) != text)
    writeDurably(path, std::string_view(text));
}

bool hasIdentity(const StudyDefinition& definition, const std::string& folder) {
  const auto path = identityPath(folder);
  if (!std::filesystem::exists(path)) return false;
  const auto found = read(path), own = identityOf(definition);
  requireSameStudy(found, own, path);
  if (!samePoints(found, own))
    refuseFolder(path, "the file of the same case and values", "The folder holds another study: choose another one");
  return true;
}

void requireOwnTable(const StudyDefinition& definition, const Partition& parts, const std::string& folder) {
  const auto path = identityPath(folder);
  if (!std::filesystem::exists(path)) {
    if (std::filesystem::exists(folder + "/study.csv"))
      refuseFolder(folder + "/study.csv", "a file with its study.json", "Move it away: nothing says which study it is");
    return;
  }
  const auto found = read(path), own = identityOf(definition);
  requireSameStudy(found, own, path);
  if (!samePoints(found, own) && !hasGrownByHash(found, own, parts, path))
    refuseFolder(path, "the file of the same case and values", "The folder holds another study: choose another one");
}

std::optional<Partition> partsIn(const StudyDefinition& definition, const std::string& folder) {
  const auto path = partsPath(folder);
  if (!std::filesystem::exists(path)) return std::nullopt;
  const auto found = read(path), own = identityOfParts(definition);
  requireSameStudy(found, own, path);
  const auto family = found.find("partition");
  if (family == found.end() || !family->is_string())
    throw FileError(path, "partition", "is missing", "Restore it, or choose another folder with -o");
  const auto parts = familyFromText(family->get<std::string>());
  if (!samePoints(found, own) && !hasGrownByHash(found, own, parts, path))
    refuseFolder(
        path, "the file of the same values" + std::string(parts.kind == Partition::Kind::hash ? ", or of fewer" : ""),
        "The folder holds parts of another study: choose another one");
  return parts;
}

void claimParts(const StudyDefinition& definition, const Partition& partition, const std::string& folder) {
  auto own = identityOfParts(definition);
  own["partition"] = familyOf(partition);
  const auto path = partsPath(folder);
  if (!std::filesystem::exists(path)) {
    if (std::filesystem::exists(identityPath(folder)))
      refuseFolder(identityPath(folder), "a folder without the study of one process",
                   "Resume it without --partition, or choose another folder");
    if (writeFirst(path, textOf(own))) return;
  }
  const auto there = partsIn(definition, folder);
  if (!there)
    refuseFolder(path, "left in place while parts are computed", "It was removed meanwhile: start the part again");
  if (familyOf(*there) != familyOf(partition))
    refuseFolder(path + " (parts " + familyOf(*there) + ")", "the file of parts " + familyOf(partition),
                 "Some points would be computed twice: divide the study in the same way, or choose another folder");
  if (!samePoints(read(path), own)) writeDurably(path, std::string_view(textOf(own)));  // it has grown
}

}  // namespace squat::studies
