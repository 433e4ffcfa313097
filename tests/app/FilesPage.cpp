#include "app/FilesPage.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "analysis/FeatureTable.h"
#include "arch/Page.h"
#include "case/ParameterTable.h"
#include "core/DurableFile.h"
#include "results/Hdf5.h"
#include "text/Csv.h"
#include "text/Text.h"

namespace squat {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestFile = std::size_t{256} << 20;

// Tables, the first that fits, and the section that describes them.
const std::vector<std::pair<std::regex, std::string>>& tables() {
  const auto is = [](const char* pattern) { return std::regex(pattern); };
  static const std::vector<std::pair<std::regex, std::string>> all{
      {is("study(-(slice|hash)-\\d+-of-\\d+)?\\.csv"), "study.csv"},
      {is("calibration\\.csv"), "calibration.csv"},
      {is("calibration-residuals\\.csv"), "calibration-residuals.csv"},
      {is("squats\\.csv"), "squats.csv"},
      {is("squat-\\d{4}\\.csv"), "passages/squat-NNNN.csv"},
      {is("own\\.csv|.*\\.examples\\.csv"), "examples.csv"},
      {is("estimate-profile\\.csv"), "estimate-profile.csv"},
      {is("estimate\\.csv"), "estimate.csv"},
      {is("estimates\\.csv"), "estimates.csv"},
      {is("features\\.csv"), "features.csv"},
      {is("aligned_(time|position)\\.csv"), "aligned_time.csv, aligned_position.csv"},
      {is("comparison\\.csv"), "comparison.csv"},
      {is(".*_spectrum\\.csv"), "NAME_spectrum.csv"},
      {is(".*_overlay\\.csv"), "NAME_overlay.csv"},
      {is(".*_spectra\\.csv"), "NAME_spectra.csv"},
      {is(".*-receptance\\.csv"), "STEM-receptance.csv"},
      {is(".*-receptance-third-octaves\\.csv"), "STEM-receptance-third-octaves.csv"},
      {is(".*-decay-rate\\.csv"), "STEM-decay-rate.csv"},
      {is(".*_roughness\\.csv"), "NAME_roughness.csv"},
      {is("roughness-transfer\\.csv"), "roughness-transfer.csv"},
      {is(".*-wheelset-modes\\.csv"), "STEM-wheelset-modes.csv"},
      {is("validation\\.csv"), "validation.csv"},
      {is("validation_parameters\\.csv"), "validation_parameters.csv"},
      {is("sensitivity\\.csv"), "sensitivity.csv"},
  };
  return all;
}

// Objects below which keys are no words of the format: columns of a table, bands, free names.
constexpr const char* kOpenObjects[] = {"features", "comparison",  "first_features", "second_features", "power_m2_s4",
                                        "energy",   "equilibrium", "mesh",           "plasticity",      "performance"};

void addKeys(const nlohmann::json& json, std::set<std::string>& keys) {
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    const bool isOpen = json.is_object() && value.is_object() &&
                        std::find(std::begin(kOpenObjects), std::end(kOpenObjects), key) != std::end(kOpenObjects);
    if (!isOpen) addKeys(value, keys);
  }
}

// Names of the first table as expressions: `STEM_NNN.vtu`, and `.svg` behind `FIGURE.png`.
bool isNamed(const std::string& name, const std::string& table) {
  static const std::regex code("`([^`]+)`"), capitals("[A-Z]{3,}|\\b[MN]\\b"), special("[.+()]");
  std::string before;
  for (std::sregex_iterator found(table.begin(), table.end(), code), end; found != end; ++found) {
    auto pattern = found->str(1);
    if (pattern.front() == '.') pattern = before + pattern;
    before = pattern.substr(0, pattern.rfind('.'));
    pattern = pattern.substr(pattern.rfind('/') + 1);
    pattern = std::regex_replace(std::regex_replace(pattern, special, "\\$&"), capitals, ".+");
    if (std::regex_match(name, std::regex(pattern))) return true;
  }
  return false;
}

// "peak [m/s2]" -> "peak", "m/s2".
std::pair<std::string, std::string> nameAndUnit(const std::string& column) {
  const auto at = column.rfind(" [");
  if (at == std::string::npos || !column.ends_with(']')) return {column, ""};
  return {column.substr(0, at), column.substr(at + 2, column.size() - at - 3)};
}

std::string withoutCode(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  return text;
}

}  // namespace

FilesPage::FilesPage(const std::string& path) {
  static const std::regex code("`([^`]+)`");
  std::string heading;
  for (const auto& line : arch::linesOf(path)) {
    if (line.starts_with("#")) {
      heading = withoutCode(line.substr(line.find(' ') + 1));
      continue;
    }
    auto& section = sections_[heading];
    if (!line.starts_with("| `")) {
      section.prose += line + "\n";
      continue;
    }
    const auto cells = text::split(line.substr(2), '|');
    if (heading == "Files") files_ += cells[0] + "\n";
    for (std::sregex_iterator found(cells[0].begin(), cells[0].end(), code), end; found != end; ++found)
      section.rows[found->str(1)] = {cells.size() > 3 ? cells[1] : "", false};
  }
}

bool FilesPage::isPlaceholder(const Section& section, const std::string& name) const {
  const auto has = [&](const char* placeholder) { return section.rows.contains(placeholder); };
  const auto isOf = [&](const char* heading, const std::string& word) {
    return sections_.at(heading).rows.contains(word);
  };
  if (has("KEY") && cases::findParameter(name)) return true;
  if (has("SIGNAL") && isOf("/signals", name)) return true;
  if (has("FEATURE") && isOf("/features", analysis::featureWord(name))) return true;
  if (has("line N first") && std::regex_match(name, std::regex("line [1-4] (first|second|shift)"))) return true;
  return has("TARGET") || has("STATEMENT") || has("RUN");  // any name
}

void FilesPage::see(const std::string& file, const std::string& section, const std::string& name,
                    const std::string& unit) {
  const auto found = sections_.find(section);
  if (found == sections_.end()) {
    missing_.push_back(file + ": no section " + section);
    return;
  }
  found->second.seen = true;
  const auto row = found->second.rows.find(name);
  if (row == found->second.rows.end()) {
    if (!isPlaceholder(found->second, name)) missing_.push_back(file + ": " + section + " has no " + name);
    return;
  }
  row->second.seen = true;
  if (!row->second.unit.empty() && row->second.unit != unit)
    missing_.push_back(file + ": " + section + ", " + name + " is in '" + unit + "', not '" + row->second.unit + "'");
}

void FilesPage::checkHead(const std::string& file, const std::string& section, const std::string& text) {
  const auto rows = text::csvRecords(text.substr(0, text.find('\n')));
  if (rows.empty()) return;
  for (const auto& column : rows.front()) {
    const auto [name, unit] = nameAndUnit(column);
    see(file, section, name, unit);
  }
}

void FilesPage::checkKeys(const std::string& file, const std::string& section, const std::string& text) {
  std::set<std::string> keys;
  addKeys(nlohmann::json::parse(text), keys);
  for (const auto& key : keys) see(file, section, key, "");
}

void FilesPage::checkArrays(const std::string& file, bool isResult) {
  static const std::regex frame("^/(fields|patch)/\\d{3}");
  const auto tree = results::readHdf5(file);
  const auto inProse = [&](const std::string& section, const std::vector<results::Attribute>& list) {
    for (const auto& attribute : list)
      if (sections_[section].prose.find("`" + attribute.name + "`") == std::string::npos &&
          sections_[section].rows.find(attribute.name) == sections_[section].rows.end())
        missing_.push_back(file + ": " + section + " has no attribute " + attribute.name);
  };
  if (isResult)
    for (const auto& attribute : tree.attributes) see(file, "/", attribute.name, "");
  else
    inProse("Receptance", tree.attributes);
  for (const auto& group : tree.groups)
    inProse(isResult ? std::regex_replace(group.path, frame, "/$1/NNN") : "Receptance", group.attributes);
  for (const auto& array : tree.arrays) {
    const auto path = std::regex_replace(array.path, frame, "/$1/NNN");
    const auto slash = isResult ? path.rfind('/') : 0;
    const auto section = !isResult ? "Receptance" : slash == 0 ? "/" : path.substr(0, slash);
    see(file, section, path.substr(slash + 1), results::textAttribute(array.attributes, "unit"));
    inProse("Results", array.attributes);
  }
}

std::vector<std::string> FilesPage::notSaid(const std::string& folder) {
  missing_.clear();
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const auto file = entry.path().string(), name = entry.path().filename().string();
    if (!isNamed(name, files_)) missing_.push_back(file + ": the page names no such file");
    if (name.ends_with(".h5")) checkArrays(file, !name.ends_with("-receptance.h5"));
    if (name.ends_with(".json"))
      checkKeys(file, name == "study-parts.json" ? "study.json" : name, readWholeFile(file, kLargestFile));
    if (!name.ends_with(".csv")) continue;
    if (name == "points.csv" && entry.path().parent_path() == folder)
      continue;  // typed: its columns are keys of a case
    const auto table = std::find_if(tables().begin(), tables().end(),
                                    [&](const auto& each) { return std::regex_match(name, each.first); });
    const bool isTyped = entry.path().parent_path() == folder && (name == "dip.csv" || name == "measured.csv");
    const auto section = table != tables().end() ? table->second : std::string(isTyped ? "PROFILE.csv" : "STEM.csv");
    checkHead(file, section, readWholeFile(file, kLargestFile));
  }
  return missing_;
}

std::vector<std::string> FilesPage::notSaid(const std::string& section, const std::string& text) {
  missing_.clear();
  checkHead("a table", section, text);
  return missing_;
}

std::vector<std::string> FilesPage::notSaidOfJson(const std::string& section, const std::string& text) {
  missing_.clear();
  checkKeys("a file", section, text);
  return missing_;
}

std::vector<std::string> FilesPage::notSeen() const {
  std::vector<std::string> names;
  for (const auto& [heading, section] : sections_)
    for (const auto& [name, row] : section.rows)
      if (section.seen && !row.seen && !std::regex_search(name, std::regex("[A-Z]{3,}|line N")))
        names.push_back(heading + ": " + name);
  return names;
}

}  // namespace squat
