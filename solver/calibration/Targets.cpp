#include "calibration/Targets.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "calibration/TargetChecks.h"
#include "case/CaseFile.h"
#include "case/ShippedCases.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "readers/TableFile.h"

namespace squat::calibration {

namespace {

using nlohmann::json;
using statements::ReferenceRun;

constexpr int kVersion = 1;
constexpr const char* kAdvice = "Compare with the page about calibration in the manual";

// The run that entries without "run" are about.
constexpr const char* kOwnRun = "the case";

double weightOf(const json& entry) {
  const double weight = entry.value("weight", 1.0);
  if (!(weight > 0 && weight <= 1e6)) throw std::invalid_argument("weight must be positive, at most 1e6");
  return weight;
}

// Everything that one JSON file adds to the targets.
class TargetFile {
 public:
  TargetFile(std::string path, std::string caseName, Targets& targets)
      : path_(std::move(path)), caseName_(std::move(caseName)), targets_(targets) {}

  void read() {
    constexpr std::size_t largest = 10000000;
    const auto text = readWholeFile(path_, largest);
    try {
      const auto all = json::parse(text);
      if (all.value("schema", "") == "squat-reference") return addReference(text);
      if (all.value("schema", "") != "squat-targets")
        throw std::invalid_argument("\"schema\" must be \"squat-targets\" or \"squat-reference\"");
      if (!all.at("schema_version").is_number_integer()) throw std::invalid_argument("\"schema_version\" must be 1");
      if (all.at("schema_version") > kVersion)
        throw std::invalid_argument("was written for a newer version; install the newer program");
      addStatements(all);
      addAll(all, "paper", [&](const json& entry) { addPaper(entry); });
      addAll(all, "signals", [&](const json& entry) { addSignal(entry); });
      addAll(all, "receptance", [&](const json& entry) { addReceptance(entry); });
      addAll(all, "decay", [&](const json& entry) { addDecay(entry); });
    } catch (const json::exception& error) {
      throw FileError(path_, location_, error.what(), kAdvice);
    } catch (const std::invalid_argument& error) {
      throw FileError(path_, location_, error.what(), kAdvice);
    }
  }

 private:
  template <typename Add>
  void addAll(const json& all, const char* name, Add add) {
    if (!all.contains(name)) return;
    std::size_t number = 0;
    for (const auto& entry : all.at(name)) {
      location_ = std::string(name) + " " + std::to_string(++number);
      add(entry);
    }
    location_.clear();
  }

  // In the words of a reference file, whose reader knows the rest.
  void addStatements(const json& all) {
    json reference{{"schema", "squat-reference"}, {"schema_version", 2}, {"source", path_}};
    reference["runs"] = all.value("runs", json::array());
    reference["runs"].push_back({{"name", kOwnRun}});
    for (auto& run : reference["runs"]) {
      if (!run.contains("case")) run["case"] = caseName_;
      if (!run.contains("set")) run["set"] = json::array();
    }
    reference["statements"] = all.value("statements", json::array());
    std::vector<double> weights;
    for (auto& entry : reference["statements"]) {
      location_ = "statement " + std::to_string(weights.size() + 1);
      weights.push_back(weightOf(entry));
      if (!entry.contains("run")) entry["run"] = kOwnRun;
      for (const char* text : {"section", "reason"})
        if (!entry.contains(text)) entry[text] = "";
    }
    location_.clear();
    const bool isEmpty = weights.empty();
    if (isEmpty)  // a placeholder: the reader of references asks for one
      reference["statements"].push_back(
          {{"section", ""}, {"statement", ""}, {"run", kOwnRun}, {"measure", "none"}, {"unit", "1"}, {"reason", ""}});
    const auto read = statements::parseReference(reference.dump(), path_);
    targets_.runs.insert(targets_.runs.end(), read.runs.begin(), read.runs.end());
    for (std::size_t i = 0; i < weights.size(); ++i) targets_.statements.push_back({read.statements[i], weights[i]});
  }

  void addPaper(const json& entry) {
    const auto paper = statements::readReference(statements::paperReferencePath());
    const std::string name = entry.at("run");
    const auto* run = paper.run(name);
    if (!run) throw std::invalid_argument("run '" + name + "' is not one of paper.json");
    const std::vector<std::string> sections = entry.value("sections", std::vector<std::string>{});
    addRun({name, caseName_, run->sets});
    std::size_t count = 0;
    for (const auto& statement : paper.statements) {
      const bool isWanted = std::any_of(sections.begin(), sections.end(), [&](const std::string& section) {
        return statement.section == section || statement.section.rfind(section + ".", 0) == 0;
      });
      if (statement.run != name || !statement.against.empty() || statement.measure == "none") continue;
      if (!statement.mesh.empty() || (!sections.empty() && !isWanted)) continue;
      targets_.statements.push_back({statement, weightOf(entry)});
      ++count;
    }
    if (count == 0) throw std::invalid_argument("paper.json has no such statement about run '" + name + "'");
  }

  void addReference(const std::string& text) {
    const auto reference = statements::parseReference(text, path_);
    const auto stem = cases::caseStem(caseName_);
    const auto isOwn = [&](const std::string& name) {
      const auto* run = reference.run(name);
      return name.empty() || (run && run->caseName == stem);
    };
    std::size_t left = 0;
    for (const auto& statement : reference.statements) {
      const bool serves = statement.measure != "none" && statement.mesh.empty();
      if (!serves || !isOwn(statement.run) || !isOwn(statement.against)) {
        ++left;
        continue;
      }
      targets_.statements.push_back({statement, 1});
      for (const auto& name : {statement.run, statement.against})
        if (!name.empty()) addRun({name, caseName_, reference.run(name)->sets});
    }
    if (left > 0)
      targets_.notes.push_back(path_ + ": " + std::to_string(left) + " statements are not about case " + stem +
                               " or cannot be judged, and are left out");
  }

  void addSignal(const json& entry) {
    SignalTarget target;
    for (const std::string file : entry.at("files")) target.files.push_back(beside(file));
    if (target.files.empty()) throw std::invalid_argument("\"files\" is empty");
    target.name = entry.value("name", std::filesystem::path(target.files.front()).stem().string());
    target.run = entry.value("run", std::string(kOwnRun));
    target.weight = weightOf(entry);
    target.before = entry.value("before", target.before), target.after = entry.value("after", target.after);
    target.cutoff = entry.value("cutoff", target.cutoff), target.noise = entry.value("noise", target.noise);
    target.reading.column = entry.value("column", "");
    target.reading.speed = entry.value("speed", 0.0), target.reading.rate = entry.value("rate", 0.0);
    const auto isWithin = [](double value, double maximum) { return value > 0 && value <= maximum; };
    if (!isWithin(target.before, 5) || !isWithin(target.after, 5))
      throw std::invalid_argument("before and after must be positive, at most 5 m");
    if (!isWithin(target.cutoff, 10000)) throw std::invalid_argument("cutoff must be positive, at most 10000 Hz");
    if (!(target.noise >= 0 && target.noise <= 1)) throw std::invalid_argument("noise must be from 0 to 1");
    targets_.signals.push_back(std::move(target));
  }

  void addReceptance(const json& entry) {
    ReceptanceTarget target;
    target.file = beside(entry.at("file"));
    target.name = entry.value("name", std::filesystem::path(target.file).stem().string());
    target.point = entry.value("point", "over a sleeper");
    if (target.point != "over a sleeper" && target.point != "midspan")
      throw std::invalid_argument("point '" + target.point + "' must be \"over a sleeper\" or \"midspan\"");
    target.weight = weightOf(entry);
    target.lowest = entry.value("lowest", target.lowest), target.highest = entry.value("highest", target.highest);
    target.tolerance = entry.value("tolerance", target.tolerance);
    if (!(target.lowest > 0 && target.lowest < target.highest && target.highest <= 2000 && target.tolerance > 0))
      throw std::invalid_argument("lowest must be below highest, highest at most 2000 Hz, tolerance positive");
    targets_.receptances.push_back(std::move(target));
  }

  void addDecay(const json& entry) {
    DecayTarget target;
    target.file = beside(entry.at("file"));
    target.name = entry.value("name", std::filesystem::path(target.file).stem().string());
    target.weight = weightOf(entry);
    target.lowest = entry.value("lowest", target.lowest), target.highest = entry.value("highest", target.highest);
    target.tolerance = entry.value("tolerance", target.tolerance);
    if (!(target.lowest >= 50 && target.lowest <= target.highest && target.highest <= 5000 && target.tolerance > 0))
      throw std::invalid_argument("lowest and highest must be third octaves from 50 to 5000 Hz, tolerance positive");
    targets_.decays.push_back(std::move(target));
  }

  void addRun(const ReferenceRun& run) {
    const auto same = [&](const ReferenceRun& other) { return other.name == run.name; };
    if (std::none_of(targets_.runs.begin(), targets_.runs.end(), same)) targets_.runs.push_back(run);
  }

  std::string beside(const std::string& file) const {
    const std::filesystem::path named(file);
    const auto whole = named.is_absolute() ? named : std::filesystem::path(path_).parent_path() / named;
    if (!std::filesystem::exists(whole)) throw std::invalid_argument("file '" + file + "' is missing");
    return whole.string();
  }

  std::string path_, caseName_, location_;
  Targets& targets_;
};

bool isReceptanceTable(const std::string& path) {
  const auto ending = std::filesystem::path(path).extension();
  if (ending == ".h5" || ending == ".hdf5" || ending == ".mat") return false;
  const auto table = readers::readTableFile(path).table;
  return !table.columns.empty() && (table.columns[0].unit == "Hz" || table.columns[0].name.rfind("freq", 0) == 0 ||
                                    table.columns[0].name.rfind("Freq", 0) == 0);
}

void addTable(const std::string& path, std::optional<std::size_t>& ofTables, Targets& targets) {
  const auto name = std::filesystem::path(path).stem().string();
  if (isReceptanceTable(path)) {
    ReceptanceTarget target;
    target.name = name, target.file = path, target.point = "over a sleeper";
    targets.receptances.push_back(target);
    return;
  }
  if (ofTables) return targets.signals[*ofTables].files.push_back(path);  // repeated runs over one defect
  ofTables = targets.signals.size();
  SignalTarget target;
  target.name = name, target.run = kOwnRun, target.files = {path};
  targets.signals.push_back(target);
}

// A path, or the name of shipped targets.
std::string findTargets(const std::string& nameOrPath) {
  std::error_code error;
  if (std::filesystem::is_regular_file(nameOrPath, error)) return nameOrPath;
  const auto folder = cases::resourcesFolder() / "reference";
  if (nameOrPath == "paper") return (folder / "paper.json").string();
  const auto shipped = folder / (nameOrPath + "-targets.json");
  const bool isName = !nameOrPath.empty() && nameOrPath.find_first_of("/\\") == std::string::npos;
  if (isName && std::filesystem::is_regular_file(shipped, error)) return shipped.string();
  throw FileError(nameOrPath, "", "no such target file", "Give the path of a file, or one of: light-defect, paper");
}

}  // namespace

std::vector<std::string> Targets::names() const {
  std::vector<std::string> all;
  for (const auto& target : statements) all.push_back(target.statement.name);
  for (const auto& target : signals) all.push_back(target.name);
  for (const auto& target : receptances) all.push_back(target.name);
  for (const auto& target : decays) all.push_back(target.name);
  return all;
}

std::vector<double> Targets::weights() const {
  std::vector<double> all;
  for (const auto& target : statements) all.push_back(target.weight);
  for (const auto& target : signals) all.push_back(target.weight);
  for (const auto& target : receptances) all.push_back(target.weight);
  for (const auto& target : decays) all.push_back(target.weight);
  return all;
}

Targets readTargets(const std::vector<std::string>& paths, const std::string& caseName) {
  Targets targets;
  std::optional<std::size_t> ofTables;  // the target that tables without a target file make together
  for (const auto& nameOrPath : paths) {
    const auto path = findTargets(nameOrPath);
    targets.path += (targets.path.empty() ? "" : ", ") + path;
    if (std::filesystem::path(path).extension() == ".json")
      TargetFile(path, caseName, targets).read();
    else
      addTable(path, ofTables, targets);
  }
  const auto named = [&](const std::string& name) {
    return std::any_of(targets.runs.begin(), targets.runs.end(), [&](const auto& run) { return run.name == name; });
  };
  if (!named(kOwnRun)) targets.runs.push_back({kOwnRun, caseName, {}});
  checkTargets(targets);
  return targets;
}

}  // namespace squat::calibration
