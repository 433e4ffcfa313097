// Reading of case files: presets, what the file states, what the command line sets, and what is wrong with it.
#include <algorithm>
#include <optional>

#include "case/CaseFile.h"
#include "case/CaseStatements.h"
#include "case/InputPresets.h"
#include "case/MeshPresets.h"
#include "case/NamedTables.h"
#include "case/ParameterValue.h"
#include "case/RightSide.h"
#include "case/ShippedCases.h"
#include "case/Validation.h"
#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestCaseFile = 4'000'000;  // bytes; toml++ takes about fifty times that in memory at worst
constexpr std::size_t maximumProblems = 50;

std::string lineNote(std::size_t line) { return line == 0 ? "" : " (line " + std::to_string(line) + ")"; }

// Collects problems; knows which keys have one, so that relations among wrong values are not judged as well.
class Problems {
 public:
  void add(CaseProblem problem, const std::string& note = {}) {
    if (problems_.size() >= maximumProblems) {
      ++more_;
      return;
    }
    keys_.push_back(problem.key);
    problem.key += note;
    problems_.push_back(std::move(problem));
  }
  bool concern(const std::vector<std::string>& keys) const {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const auto& key) { return std::find(keys_.begin(), keys_.end(), key) != keys_.end(); });
  }
  void throwIfAny() const {
    if (problems_.empty()) return;
    auto all = problems_;
    if (more_ > 0) all.push_back({std::to_string(more_) + " more errors", "", "", "fix these first"});
    throw CaseError(std::move(all));
  }
  bool empty() const { return problems_.empty(); }

 private:
  std::vector<CaseProblem> problems_;
  std::vector<std::string> keys_;
  std::size_t more_ = 0;
};

const std::string* overrideOf(const CaseOverrides& overrides, std::string_view key) {
  const std::string* last = nullptr;
  for (const auto& [name, text] : overrides.values)
    if (name == key) last = &text;
  return last;
}

const Stated* find(const std::vector<Stated>& stated, std::string_view key) {
  for (const auto& one : stated)
    if (one.key == key && !one.typeProblem) return &one;
  return nullptr;
}

// A preset key with another name than the file's, and all keys that either of the two has values for.
struct ReplacedPreset {
  std::string key;
  std::vector<std::string> sets;
};

// What presets make of the defaults: those that the file names, and those that count, which the command line may have
// put in their place.
struct Presets {
  CaseDescription ofFile, asked;
  std::vector<ReplacedPreset> replaced;
};

std::string statedChoice(const std::vector<Stated>& stated, std::string_view key) {
  const Stated* one = find(stated, key);
  const auto& names = findParameter(key)->choices;
  const bool known = one && std::find(names.begin(), names.end(), one->text) != names.end();
  return known ? one->text : findParameter(key)->defaultText;
}

std::string askedName(const CaseOverrides& overrides, std::string_view key, const std::string& otherwise,
                      Problems& problems) {
  const std::string* set = overrideOf(overrides, key);
  std::string name = set ? *set : key == "mesh.preset" ? overrides.preset : "";
  const auto& names = findParameter(key)->choices;
  if (name.empty()) return otherwise;
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  if (!set) problems.add({"--mesh", name, allowedText(*findParameter(key)), ""});
  return otherwise;  // a wrong --set is reported where all of them are set
}

std::vector<std::string> keysOf(const std::string& preset, const std::vector<std::string>& names) {
  std::vector<std::string> keys;
  if (preset == "mesh.preset")
    for (const auto& row : presetTable()) keys.push_back(row.key);
  else
    for (const auto& name : names)
      for (const auto& [key, text] : inputPresetValues(preset, name)) keys.push_back(key);
  return keys;
}

// Input presets are files: `opensFiles` says whether they may be read.
Presets presetsOf(const std::vector<Stated>& stated, const CaseOverrides& overrides, bool opensFiles,
                  Problems& problems) {
  Presets presets{defaultCase(), defaultCase(), {}};
  const auto apply = [&](const std::string& key, const auto& set) {
    const auto own = statedChoice(stated, key), asked = askedName(overrides, key, own, problems);
    set(presets.ofFile, own), set(presets.asked, asked);
    if (own != asked) presets.replaced.push_back({key, keysOf(key, {own, asked})});
  };
  apply("mesh.preset", [](CaseDescription& to, const auto& name) { applyPreset(to, *presetNamed(name)); });
  if (!opensFiles) return presets;
  for (const char* key : inputPresetKeys)
    apply(key, [key](CaseDescription& to, const auto& name) { applyInputPreset(to, key, name); });
  return presets;
}

// True where the file states just what its own preset says, and another one is asked for: it counts as not stated.
bool isReplaced(const Stated& one, const Presets& presets) {
  if (!keyOnRight(one.key).empty()) return false;
  const Parameter& parameter = *findParameter(one.key);
  const bool isSet = std::any_of(presets.replaced.begin(), presets.replaced.end(), [&](const auto& replaced) {
    return one.key == replaced.key ||
           std::find(replaced.sets.begin(), replaced.sets.end(), one.key) != replaced.sets.end();
  });
  if (!isSet) return false;
  CaseDescription trial = presets.ofFile;
  if (trySetValue(trial, parameter, one.text)) return false;  // a wrong value is reported
  return valueText(trial, parameter) == valueText(presets.ofFile, parameter);
}

void checkSchema(const toml::table& table, const std::string& origin, Problems& problems) {
  const toml::node* node = table.get("schema");
  if (!node) return;  // a file without the key is of the first schema
  const auto* number = node->as_integer();
  if (!number || number->get() < 1) {
    problems.add({"schema", typeName(*node), "1 to " + std::to_string(caseSchema), "Write schema = 1"},
                 lineNote(node->source().begin.line));
  } else if (number->get() > caseSchema) {
    throw FileError(origin, "line " + std::to_string(node->source().begin.line),
                    "case schema " + std::to_string(number->get()) + " is newer than the supported schema " +
                        std::to_string(caseSchema),
                    "Use a newer version of Squat Studio");
  }
}

void applyStated(CaseDescription& description, const std::vector<Stated>& stated, const Presets& presets,
                 Problems& problems) {
  for (const auto& one : stated) {
    const std::string note = lineNote(one.line);
    if (one.typeProblem) {
      problems.add(*one.typeProblem, note);
    } else if (!keyOnRight(one.key).empty()) {
      continue;  // once the left side is known
    } else if (!isReplaced(one, presets)) {
      if (auto wrong = trySetValue(description, *findParameter(one.key), one.text)) problems.add(*wrong, note);
    }
  }
}

void applyOverrides(CaseDescription& description, const CaseOverrides& overrides, Problems& problems) {
  for (const auto& [key, text] : overrides.values) {
    const Parameter* parameter = findParameter(key);
    if (!keyOnRight(key).empty()) continue;
    if (!parameter)
      problems.add(unknownKey(key), " (--set)");
    else if (auto wrong = trySetValue(description, *parameter, text))
      problems.add(*wrong, " (--set)");
  }
}

// What the right side has of its own: as stated, then as set.
void applyRight(CaseDescription& description, const std::vector<Stated>& stated, const CaseOverrides& overrides,
                Problems& problems) {
  const auto set = [&](std::string_view key, const std::string& text, const std::string& note) {
    if (auto wrong = trySetRight(description, key, text)) problems.add(*wrong, note);
  };
  for (const auto& one : stated)
    if (const auto key = keyOnRight(one.key); !key.empty() && !one.typeProblem) set(key, one.text, lineNote(one.line));
  for (const auto& [name, text] : overrides.values)
    if (const auto key = keyOnRight(name); !key.empty()) set(key, text, " (--set)");
}

// A profile that nothing asks to roll over would go unnoticed: the shape must be chosen where the profile is named, in
// the file or with --set. A case that states another shape may keep its points (the studio writes such).
void checkProfileIsUsed(const CaseDescription& description, const std::vector<Stated>& stated,
                        const CaseOverrides& overrides, Problems& problems) {
  if (description.defect.shape == DefectShape::profile) return;
  const auto levelOf = [&](std::string_view key) { return overrideOf(overrides, key) ? 2 : find(stated, key) ? 1 : 0; };
  const int chosen = levelOf("defect.shape");
  const auto& defect = description.defect;
  const std::pair<const char*, bool> profiles[] = {{"defect.file", !defect.file.empty()},
                                                   {"defect.points", !defect.points.empty()},
                                                   {"defect.lines", !defect.lines.empty()}};
  for (const auto& [key, given] : profiles) {
    const int level = levelOf(key);
    if (!given || level <= chosen || problems.concern({"defect.shape"})) continue;
    const Stated* line = level == 1 ? find(stated, key) : nullptr;
    problems.add({"defect.shape", valueText(description, *findParameter("defect.shape")),
                  std::string("profile if ") + key + " is given",
                  level == 2 ? std::string("Add --set defect.shape=profile, or remove --set ") + key
                             : std::string("Add shape = \"profile\", or remove ") + key},
                 level == 2 ? " (--set)" : lineNote(line ? line->line : 0));
  }
}

// Numbers in the case override the file; a file given by --set overrides numbers of the case.
void readNamedTables(CaseDescription& description, const CaseOverrides& overrides, const std::filesystem::path& folder,
                     Problems& problems) {
  for (const auto& table : namedTables()) {
    if (!table.isWanted(description)) continue;
    const bool fileSet = overrideOf(overrides, table.fileKey) != nullptr;
    const bool valuesSet = std::any_of(table.valueKeys.begin(), table.valueKeys.end(),
                                       [&](const auto& key) { return overrideOf(overrides, key) != nullptr; });
    if (table.isFilled(description) && (!fileSet || valuesSet)) continue;
    const std::filesystem::path named = table.file(description);
    try {
      // What is typed on the command line is relative to where it is typed.
      table.read(description, named.is_absolute() || fileSet ? named : folder / named);
    } catch (const FileError&) {
      if (problems.empty()) throw;
      problems.throwIfAny();  // errors of the case first: the file may be one of them
    }
  }
}

// The profile that the right side names for itself, as readNamedTables() reads that of the left one. A right side that
// states another shape may keep the name.
void readRightProfile(CaseDescription& description, const CaseOverrides& overrides,
                      const std::filesystem::path& folder) {
  const auto& table = *namedTable("defect.file");
  const auto isOwn = [&](const std::string& key) {
    return std::any_of(description.right.begin(), description.right.end(),
                       [&](const auto& stated) { return stated.first == key; });
  };
  const auto isSet = [&](const std::string& key) {
    return overrideOf(overrides, std::string(rightGroup) + "." + key) != nullptr;
  };
  const auto any = [&](const auto& matches) {
    return std::any_of(table.valueKeys.begin(), table.valueKeys.end(), matches);
  };
  CaseDescription right = rightOf(description);
  if (!table.isWanted(right)) return;
  // The name may be the left side's, which has another shape and no use for it.
  const bool ownFile = isOwn(table.fileKey), ownSet = isSet(table.fileKey);
  if (ownFile ? any(isOwn) && (!ownSet || any(isSet)) : table.isFilled(right)) return;
  const bool fileSet = ownFile ? ownSet : overrideOf(overrides, table.fileKey) != nullptr;
  const std::filesystem::path named = table.file(right);
  table.clear(right);
  table.read(right, named.is_absolute() || fileSet ? named : folder / named);
  for (const auto& key : table.valueKeys)
    if (auto wrong = trySetRight(description, key, valueText(right, *findParameter(key)))) throw CaseError({*wrong});
}

// As checkProfileIsUsed(): a profile named on the right, in the file or with --set, where nothing on the right asks for
// one.
void checkRightProfileIsUsed(const CaseDescription& description, const std::vector<Stated>& stated,
                             const CaseOverrides& overrides, Problems& problems) {
  const CaseDescription right = rightOf(description);
  if (right.defect.file.empty() || right.defect.shape == DefectShape::profile) return;
  const auto isPoints = [](const auto& one) { return one.first == "defect.points" || one.first == "defect.lines"; };
  if (std::any_of(description.right.begin(), description.right.end(), isPoints)) return;  // read before
  const std::string start = std::string(rightGroup) + ".";
  const auto levelOf = [&](std::string_view key) { return overrideOf(overrides, key) ? 2 : find(stated, key) ? 1 : 0; };
  const int level = levelOf(start + "defect.file");
  if (level <= levelOf(start + "defect.shape")) return;
  const Stated* line = level == 1 ? find(stated, start + "defect.file") : nullptr;
  problems.add({start + "defect.shape", valueText(right, *findParameter("defect.shape")),
                "profile if " + start + "defect.file is given",
                "Give shape = \"profile\" to [right.defect], or remove right.defect.file"},
               level == 2 ? " (--set)" : lineNote(line ? line->line : 0));
}

struct Reading {
  bool finished = true;    // relations between values hold
  bool opensFiles = true;  // of presets, and tables that the case names
};

CaseDescription parse(std::string_view text, const std::string& origin, const std::filesystem::path& folder,
                      const CaseOverrides& overrides, const Reading& reading) {
  if (text.size() > largestCaseFile)
    throw FileError(origin, "", "larger than 4 MB", "Put long profiles into a CSV file and give it as defect.file");
  const toml::table table = parsedToml(text, origin);
  Problems problems;
  checkSchema(table, origin, problems);
  const auto stated = statementsOf(table, text);
  const Presets presets = presetsOf(stated, overrides, reading.opensFiles, problems);
  CaseDescription description = presets.asked;
  applyStated(description, stated, presets, problems);
  applyOverrides(description, overrides, problems);
  applyRight(description, stated, overrides, problems);
  if (reading.finished) {
    checkProfileIsUsed(description, stated, overrides, problems);
    checkRightProfileIsUsed(description, stated, overrides, problems);
  }
  if (reading.opensFiles) {
    readNamedTables(description, overrides, folder, problems);
    if (problems.empty()) readRightProfile(description, overrides, folder);
  }
  for (auto& finding : reading.finished ? validateRelations(description) : std::vector<Finding>())
    if (finding.severity == Severity::problem && !problems.concern(finding.keys)) {
      const Stated* one = find(stated, finding.problem.key);
      problems.add(finding.problem, lineNote(one ? one->line : 0));
    }
  problems.throwIfAny();
  return description;
}

}  // namespace

CaseDescription parseCase(std::string_view text, const std::string& origin, const std::filesystem::path& folder,
                          const CaseOverrides& overrides) {
  return parse(text, origin, folder, overrides, {});
}

CaseDescription parseUnfinishedCase(std::string_view text, const std::string& origin) {
  return parse(text, origin, {}, {}, {false, true});
}

CaseDescription parseCaseOfResult(std::string_view text, const std::string& origin) {
  CaseOverrides unnamed;  // a result holds the numbers; where they are from may be gone
  for (const auto& table : namedTables()) unnamed.values.emplace_back(table.fileKey, "");
  return parse(text, origin, {}, unnamed, {true, false});
}

CaseDescription readCase(const std::filesystem::path& path, const CaseOverrides& overrides) {
  return parseCase(readWholeFile(path.string(), largestCaseFile), path.string(), path.parent_path(), overrides);
}

CaseDescription loadCase(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return readCase(findCase(nameOrPath), overrides);
}

std::vector<std::string> filesOfCase(const std::string& nameOrPath, const CaseDescription& description) {
  const auto file = findCase(nameOrPath);
  std::vector<std::string> files{file.string()};
  for (auto named : {description, rightOf(description)})
    for (const auto& table : namedTables())
      if (const auto& path = table.file(named); !path.empty())
        files.insert(files.end(), {(file.parent_path() / path).string(), path});
  return files;
}

std::string caseStem(const std::string& nameOrPath) { return std::filesystem::path(nameOrPath).stem().string(); }

}  // namespace squat::cases
