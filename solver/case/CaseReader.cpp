// Reading of case files. The decimal text of numbers is taken from the source itself, so that units are applied to the
// digits that the user typed (DecimalNumber.h).
#include <algorithm>
#include <optional>

#include "case/CaseFile.h"
#include "case/DecimalNumber.h"
#include "case/MeshPresets.h"
#include "case/ParameterValue.h"
#include "case/PointsText.h"
#include "case/ProfileFile.h"
#include "case/ShippedCases.h"
#include "case/TomlGuard.h"
#include "case/TomlLibrary.h"
#include "case/Validation.h"
#include "core/DurableFile.h"
#include "core/Errors.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestFile = 4'000'000;  // bytes; toml++ takes about fifty times that in memory at worst
constexpr std::size_t mostProblems = 50, mostParts = 8;

// A key as the file states it.
struct Stated {
  std::string key;
  std::string text;  // as for trySetValue
  std::size_t line = 0;
  std::optional<CaseProblem> typeProblem;
};

class Source {
 public:
  explicit Source(std::string_view text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t end = std::min(text.find('\n', from), text.size());
      lines_.push_back(text.substr(from, end - from));
      from = end + 1;
    }
  }

  // The number's own digits where they can be found again, else the shortest text of its value.
  std::string numberText(const toml::node& node, double value) const {
    const auto& region = node.source();
    if (region.begin.line == region.end.line && region.begin.line >= 1 && region.begin.line <= lines_.size()) {
      const std::string_view line = lines_[region.begin.line - 1];
      const std::size_t from = region.begin.column - 1, to = std::min<std::size_t>(region.end.column - 1, line.size());
      if (from < to) {
        std::string token(line.substr(from, to - from));
        token.erase(std::remove(token.begin(), token.end(), '_'), token.end());
        const auto parsed = parseDecimal(token);
        if (parsed && *parsed == value) return token;
      }
    }
    return formatDecimal(value);
  }

 private:
  std::vector<std::string_view> lines_;
};

const char* typeName(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::optional<std::string> numberText(const toml::node& node, const Source& source) {
  if (const auto* number = node.as_floating_point()) return source.numberText(node, number->get());
  // Integers beyond 2^53 are no sensible values; as a double they fail the range check.
  if (const auto* number = node.as_integer()) return source.numberText(node, static_cast<double>(number->get()));
  return std::nullopt;
}

std::optional<std::string> pointsText(const toml::node& node, const Source& source) {
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::string text = "[";
  for (const auto& element : *array) {
    const auto* pair = element.as_array();
    if (!pair || pair->size() != 2) return std::nullopt;
    const auto position = numberText((*pair)[0], source), height = numberText((*pair)[1], source);
    if (!position || !height) return std::nullopt;
    text += (text.size() > 1 ? ",[" : "[") + *position + "," + *height + "]";
  }
  return text + "]";
}

std::optional<std::string> linesText(const toml::node& node, const Source& source) {
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::string text = "[";
  for (const auto& element : *array) {
    const auto* line = element.as_array();
    if (!line || line->size() != 2) return std::nullopt;
    const auto lateral = numberText((*line)[0], source), points = pointsText((*line)[1], source);
    if (!lateral || !points) return std::nullopt;
    text += (text.size() > 1 ? ",[" : "[") + *lateral + "," + *points + "]";
  }
  return text + "]";
}

std::optional<std::string> seatsText(const toml::node& node, const Source& source) {
  const auto* array = node.as_array();
  if (!array) return std::nullopt;
  std::string text = "[";
  for (const auto& element : *array) {
    const auto* seat = element.as_table();
    if (!seat) return std::nullopt;
    std::string own;
    for (const auto& [key, value] : *seat) {
      const auto number = numberText(value, source);
      if (!number) return std::nullopt;
      own += (own.empty() ? "" : ", ") + std::string(key.str()) + " = " + *number;
    }
    text += (text.size() > 1 ? ", {" : "{") + own + "}";
  }
  return text + "]";
}

std::optional<std::string> textFor(const toml::node& node, Kind kind, const Source& source) {
  switch (kind) {
    case Kind::number:
      return numberText(node, source);
    case Kind::boolean:
      if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
      return std::nullopt;
    case Kind::choice:
    case Kind::text:
      if (const auto* value = node.as_string()) return value->get();
      return std::nullopt;
    case Kind::points:
    case Kind::forceCurve:
      return pointsText(node, source);
    case Kind::lines:
      return linesText(node, source);
    case Kind::seats:
      return seatsText(node, source);
  }
  return std::nullopt;
}

std::string lineNote(std::size_t line) { return line == 0 ? "" : " (line " + std::to_string(line) + ")"; }

class Statements {
 public:
  Statements(const toml::table& table, const Source& source) : source_(source) {
    for (const auto& [key, node] : table) {
      if (key.str() == "schema") continue;
      if (const auto* group = node.as_table(); group && !findParameter(key.str()))
        addGroup(std::string(key.str()), *group);
      else
        add(std::string(key.str()), node);
    }
    std::stable_sort(stated.begin(), stated.end(), [](const Stated& a, const Stated& b) { return a.line < b.line; });
  }

  std::vector<Stated> stated;

 private:
  void addGroup(const std::string& name, const toml::table& group) {
    for (const auto& [key, node] : group) add(name + "." + std::string(key.str()), node);
    const auto& all = parameterTable();
    const bool known = std::any_of(all.begin(), all.end(), [&](const auto& row) { return row.group == name; });
    if (group.empty() && !known) add(name, group);
  }

  void add(const std::string& key, const toml::node& node) {
    Stated one{key, {}, node.source().begin.line, {}};
    if (const Parameter* parameter = findParameter(key)) {
      if (auto text = textFor(node, parameter->kind, source_))
        one.text = std::move(*text);
      else
        one.typeProblem = CaseProblem{key, typeName(node), allowedText(*parameter), "Write the value in this form"};
    } else {
      // Looking for the nearest key takes its time; a list of thousands is not read by anybody.
      one.typeProblem = ++unknown_ <= mostProblems ? unknownKey(key, typeName(node)) : CaseProblem{key, {}, {}, {}};
    }
    stated.push_back(std::move(one));
  }

  const Source& source_;
  std::size_t unknown_ = 0;
};

// Collects problems; knows which keys have one, so that relations among wrong values are not judged as well.
class Problems {
 public:
  void add(CaseProblem problem, const std::string& note = {}) {
    if (problems_.size() >= mostProblems) {
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
    if (more_ > 0) all.push_back({"...", std::to_string(more_) + " more mistakes", "", "Mend these first"});
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

int presetOf(const std::vector<Stated>& stated, int otherwise) {
  const Stated* one = find(stated, "mesh.preset");
  const int index = one ? presetIndex(one->text) : otherwise;
  return index < 0 ? otherwise : index;
}

// True where the file's value is only what its own preset says.
bool isOwnPreset(const Stated& one, int filePreset) {
  for (const auto& row : presetTable())
    if (row.key == one.key) {
      const auto value = parseDecimal(one.text);
      return value && value == parseDecimal(row.values[static_cast<std::size_t>(filePreset)]);
    }
  return false;
}

int wantedPreset(const CaseOverrides& overrides, int filePreset, Problems& problems) {
  const std::string* set = overrideOf(overrides, "mesh.preset");
  const std::string name = set ? *set : overrides.preset;
  if (name.empty()) return filePreset;
  const int index = presetIndex(name);
  if (index >= 0) return index;
  if (!set) problems.add({"--mesh", name, allowedText(*findParameter("mesh.preset")), "Choose one of the names"});
  return filePreset;  // a wrong --set is reported where all of them are set
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
                    "the case is of schema " + std::to_string(number->get()) + ", this program reads up to " +
                        std::to_string(caseSchema),
                    "Use a newer version of Squat Studio");
  }
}

void applyStated(CaseDescription& description, const std::vector<Stated>& stated, int filePreset, int preset,
                 Problems& problems) {
  for (const auto& one : stated) {
    const std::string note = lineNote(one.line);
    if (one.typeProblem) {
      problems.add(*one.typeProblem, note);
    } else if (one.key != "mesh.preset" || presetIndex(one.text) < 0) {
      if (preset != filePreset && isOwnPreset(one, filePreset)) continue;
      if (auto wrong = trySetValue(description, *findParameter(one.key), one.text)) problems.add(*wrong, note);
    }
  }
}

void applyOverrides(CaseDescription& description, const CaseOverrides& overrides, Problems& problems) {
  for (const auto& [key, text] : overrides.values) {
    const Parameter* parameter = findParameter(key);
    if (!parameter)
      problems.add(unknownKey(key, text), " (--set)");
    else if (auto wrong = trySetValue(description, *parameter, text))
      problems.add(*wrong, " (--set)");
  }
}

// A profile that nothing asks to roll over would go unnoticed: the shape must be chosen where the profile is named, in
// the file or with --set. A case that states another shape may keep its points (the studio writes such).
void checkProfileIsUsed(const CaseDescription& description, const std::vector<Stated>& stated,
                        const CaseOverrides& overrides, Problems& problems) {
  if (description.defect.shape == static_cast<int>(DefectShape::profile)) return;
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
                  std::string("profile where ") + key + " is given",
                  level == 2 ? std::string("Add --set defect.shape=profile, or leave --set ") + key + " out"
                             : std::string("Write shape = \"profile\" beside it, or take ") + key + " out"},
                 level == 2 ? " (--set)" : lineNote(line ? line->line : 0));
  }
}

// Points in the case go before the file; a file given by --set goes before points of the case.
void readProfile(CaseDescription& description, const CaseOverrides& overrides, const std::filesystem::path& folder,
                 Problems& problems) {
  Defect& defect = description.defect;
  if (defect.shape != static_cast<int>(DefectShape::profile) || defect.file.empty()) return;
  const bool fileSet = overrideOf(overrides, "defect.file") != nullptr;
  const bool sampledSet = overrideOf(overrides, "defect.points") || overrideOf(overrides, "defect.lines");
  if (!(defect.points.empty() && defect.lines.empty()) && !(fileSet && !sampledSet)) return;
  const std::filesystem::path named = defect.file;
  // What is typed on the command line is relative to where it is typed.
  const auto path = named.is_absolute() || fileSet ? named : folder / named;
  try {
    auto profile = readProfileLines(path);
    defect.points.clear(), defect.lines.clear();
    if (profile.size() == 1)
      defect.points = std::move(profile.front().points);
    else
      defect.lines = std::move(profile);
  } catch (const FileError&) {
    if (problems.empty()) throw;
    problems.throwIfAny();  // mistakes of the case first: the file may be one of them
  }
}

toml::table parsedToml(std::string_view text, const std::string& origin) {
  if (mostKeyParts(text) > mostParts)
    throw FileError(origin, "", "has a key of more than " + std::to_string(mostParts) + " parts",
                    "Keys of a case have two, like pad.stiffness");
  if (const auto foreign = firstForeignByte(text); foreign != std::string_view::npos)
    throw FileError(origin, "line " + std::to_string(1 + std::count(text.begin(), text.begin() + foreign, '\n')),
                    "has a letter beyond ASCII outside quotes", "Put texts between quotes");
  try {
    toml::parse_result parsed = toml::parse(text, origin);
    if (parsed) return std::move(parsed).table();
    throw FileError(origin, "line " + std::to_string(parsed.error().source().begin.line),
                    "is no valid TOML: " + std::string(parsed.error().description()));
  } catch (const TomlAssertion& failed) {
    throw FileError(origin, "", std::string("is no valid TOML: ") + failed.what());
  }
}

CaseDescription parse(std::string_view text, const std::string& origin, const std::filesystem::path& folder,
                      const CaseOverrides& overrides, bool finished) {
  if (text.size() > largestFile)
    throw FileError(origin, "", "is larger than 4 MB", "Put long profiles into a CSV file and name it as defect.file");
  const toml::table table = parsedToml(text, origin);
  Problems problems;
  checkSchema(table, origin, problems);
  const Source source(text);
  const Statements statements(table, source);
  CaseDescription description = defaultCase();
  const int filePreset = presetOf(statements.stated, description.mesh.preset);
  const int preset = wantedPreset(overrides, filePreset, problems);
  applyPreset(description, static_cast<MeshPreset>(preset));
  applyStated(description, statements.stated, filePreset, preset, problems);
  applyOverrides(description, overrides, problems);
  if (finished) checkProfileIsUsed(description, statements.stated, overrides, problems);
  readProfile(description, overrides, folder, problems);
  for (auto& finding : finished ? validateRelations(description) : std::vector<Finding>())
    if (finding.severity == Severity::problem && !problems.concern(finding.keys)) {
      const Stated* stated = find(statements.stated, finding.problem.key);
      problems.add(finding.problem, lineNote(stated ? stated->line : 0));
    }
  problems.throwIfAny();
  return description;
}

}  // namespace

CaseDescription parseCase(std::string_view text, const std::string& origin, const std::filesystem::path& folder,
                          const CaseOverrides& overrides) {
  return parse(text, origin, folder, overrides, true);
}

CaseDescription parseUnfinishedCase(std::string_view text, const std::string& origin) {
  return parse(text, origin, {}, {}, false);
}

CaseDescription parseCaseOfResult(std::string_view text, const std::string& origin) {
  return parseCase(text, origin, {}, {{}, {{"defect.file", ""}}});
}

CaseDescription readCase(const std::filesystem::path& path, const CaseOverrides& overrides) {
  return parseCase(readWholeFile(path.string(), largestFile), path.string(), path.parent_path(), overrides);
}

CaseDescription loadCase(const std::string& nameOrPath, const CaseOverrides& overrides) {
  return readCase(findCase(nameOrPath), overrides);
}

std::vector<std::string> filesOfCase(const std::string& nameOrPath, const std::string& profile) {
  const auto file = findCase(nameOrPath);
  std::vector<std::string> files{file.string()};
  if (!profile.empty()) files.insert(files.end(), {(file.parent_path() / profile).string(), profile});
  return files;
}

std::string caseStem(const std::string& nameOrPath) { return std::filesystem::path(nameOrPath).stem().string(); }

}  // namespace squat::cases
