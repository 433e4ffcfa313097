#include "project/CopyPlan.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "case/NamedTables.h"
#include "case/RightSide.h"
#include "core/DurableFile.h"
#include "core/platform/File.h"

namespace squat::project {
namespace {

namespace fs = std::filesystem;

bool isReadable(const fs::path& file) {
  std::error_code none;
  return fs::is_regular_file(file, none) && platform::mayRead(file.string());
}

// A copy may go to a file system that takes "Dip.h5" and "dip.h5" for one name.
std::string folded(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char each) { return std::tolower(each); });
  return name;
}

// The numbered folders of a kind: "runs", "runs/2", ...
fs::path numbered(const std::string& kind, int number) {
  return number == 1 ? fs::path(kind) : fs::path(kind) / std::to_string(number);
}

// The names of all tables that a case has, of both sides; each once.
std::vector<std::string> tablesOf(const cases::CaseDescription& description) {
  std::vector<std::string> names;
  for (auto side : {description, cases::rightOf(description)})
    for (const auto& table : cases::namedTables())
      if (const auto& name = table.file(side);
          !name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  return names;
}

// The table that has this name in a case gets another; false: none has.
bool renameTable(cases::CaseDescription& description, const std::string& from, const std::string& to) {
  bool isRenamed = false;
  for (const auto& table : cases::namedTables())
    if (table.file(description) == from) table.file(description) = to, isRenamed = true;
  for (auto& [key, text] : description.right)
    if (cases::namedTable(key) && text == from) text = to, isRenamed = true;
  return isRenamed;
}

// The text of a case with `profile`, which it names by a full path, named `name` instead; empty where that path is not
// written plainly.
std::string renamedProfile(const std::string& path, const std::string& profile, const std::string& name) {
  constexpr std::size_t largestCase = 4U << 20U;  // [bytes], as its reader has it
  std::string text = readWholeFile(path, largestCase);
  const auto before = cases::parseCase(text, path, fs::path(path).parent_path());
  for (const char quote : {'"', '\''}) {
    const std::string written = quote + profile + quote;
    auto at = text.find(written);
    if (at == std::string::npos) continue;
    for (; at != std::string::npos; at = text.find(written, at))
      text.replace(at, written.size(), quote + name + quote), at += name.size() + 2;
    auto after = cases::parseCase(text, path, fs::path(profile).parent_path());
    return renameTable(after, name, name) && cases::caseHash(after) == cases::caseHash(before) ? text : std::string();
  }
  return {};
}

class Planner {
 public:
  Planner(const Project& project, std::string folder) : folder_(std::move(folder)) { plan_.project = project; }

  CopyPlan plan() {
    Project& project = plan_.project;
    // Passages of the list may be measured signals as well: they stay with the list.
    project.records.events = placeEvents(project.records.events);
    for (auto& entry : project.entries) entry.path = place(entry.path, entry.kind == Kind::run ? "runs" : "signals");
    for (auto& file : project.records.files) file = place(file, "records");
    project.records.labels = place(project.records.labels, "records");
    project.open.path = placeCase(project.open.path);
    for (auto& path : project.cases) path = placeCase(path);
    return std::move(plan_);
  }

 private:
  // The path in the copy; the path as it is where there is no such file.
  std::string place(const std::string& path, const std::string& kind) {
    if (path.empty()) return {};
    if (const auto known = placed_.find(path); known != placed_.end()) return known->second;
    if (!isReadable(path)) return missing(path);
    for (int number = 1;; ++number) {
      const fs::path to = numbered(kind, number) / fs::path(path).filename();
      if (isFree(to, path)) return add(path, to);
    }
  }

  std::string placeEvents(const std::string& list) {
    if (list.empty()) return {};
    if (!isReadable(list)) return missing(list);
    const fs::path from = fs::path(list).parent_path(), to = "events";
    std::string placed = add(list, to / fs::path(list).filename());
    for (const char* name : {"squats.csv", "squats.geojson"})
      if (isReadable(from / name) && isFree(to / name, from / name)) add(from / name, to / name);
    for (const char* name : {"passages", "other-events"}) {
      std::error_code none;
      for (const auto& each : fs::directory_iterator(from / name, none))
        if (each.path().extension() == ".csv" && isReadable(each.path()))
          add(each.path(), to / name / each.path().filename());
    }
    return placed;
  }

  std::string placeCase(const std::string& path) {
    if (path.empty()) return {};
    if (const auto known = placed_.find(path); known != placed_.end()) return known->second;
    if (!isReadable(path)) return missing(path);
    std::vector<fs::path> beside;  // tables that the case names by a path relative to its own
    std::string full;              // and the one by a full path
    try {
      for (const auto& table : tablesOf(cases::readCase(path))) {
        const fs::path at = (fs::path(path).parent_path() / table).lexically_normal();
        if (!isReadable(at)) continue;  // the case has the points of the table itself
        if (fs::path(table).is_relative())
          beside.push_back(at);
        else if (full.empty() && beside.empty())
          full = table;
        else
          plan_.problems.push_back(path + " still names a table by its full path, " + table);
      }
    } catch (const std::exception& error) {
      plan_.problems.push_back(path + " is copied without the profile that it may name: " + error.what());
    }
    if (!full.empty() && beside.empty()) return placeRewritten(path, full);
    if (!full.empty()) plan_.problems.push_back(path + " still names a table by its full path, " + full);
    return beside.empty() ? place(path, "cases") : placeTogether(path, beside);
  }

  // As many folders above the case come along as the profile is away from it.
  std::string placeTogether(const fs::path& path, const std::vector<fs::path>& tables) {
    fs::path root = path.parent_path();
    for (const auto& table : tables)
      while (root.has_relative_path() && *table.lexically_relative(root).begin() == "..") root = root.parent_path();
    for (int number = 1;; ++number) {
      const fs::path to = numbered("cases", number);
      const auto placeOf = [&](const fs::path& file) { return to / file.lexically_relative(root); };
      if (!isFree(placeOf(path), path) ||
          !std::all_of(tables.begin(), tables.end(), [&](const auto& table) { return isFree(placeOf(table), table); }))
        continue;
      for (const auto& table : tables) add(table, placeOf(table));
      return add(path, placeOf(path));
    }
  }

  std::string placeRewritten(const fs::path& path, const std::string& profile) {
    const std::string name = fs::path(profile).filename().string();
    const std::string text = renamedProfile(path.string(), profile, name);
    if (text.empty()) {
      plan_.problems.push_back(path.string() + " still names its profile by its full path, " + profile);
      return place(path.string(), "cases");
    }
    if (path == plan_.project.open.path) {
      auto open = cases::parseUnfinishedCase(plan_.project.open.toml, plan_.project.open.name);
      if (renameTable(open, profile, name)) plan_.project.open.toml = cases::writeCase(open);
    }
    for (int number = 1;; ++number) {
      const fs::path to = numbered("cases", number);
      if (!isFree(to / path.filename(), path) || !isFree(to / name, profile)) continue;
      add(profile, to / name);
      return add(path, to / path.filename(), text);
    }
  }

  bool isFree(const fs::path& to, const fs::path& from) const {
    const auto found = taken_.find(folded(to.string()));
    return found == taken_.end() || found->second == from;
  }

  // A profile may belong to several cases: it may be there already.
  std::string add(const fs::path& from, const fs::path& to, const std::string& text = {}) {
    if (taken_.emplace(folded(to.string()), from).second)
      plan_.files.push_back({from.string(), to.generic_string(), text});
    return placed_[from.string()] = folder_ + "/" + to.generic_string();
  }

  std::string missing(const std::string& path) {
    plan_.problems.push_back(path + " is missing or cannot be read; the copy keeps the link to it");
    return placed_[path] = path;
  }

  std::string folder_;
  CopyPlan plan_;
  std::map<fs::path, std::string> placed_;  // of a file, its path in the copy
  std::map<std::string, fs::path> taken_;   // of a name in the copy, the file
};

}  // namespace

CopyPlan planCopy(const Project& project, const std::string& folder) { return Planner(project, folder).plan(); }

}  // namespace squat::project
