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
constexpr std::size_t maximumProblems = 50, maximumParts = 8;

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
      return "a string";
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
      if (const auto* quantity = node.as_string(); quantity && !parseDecimal(quantity->get()))
        return quantity->get();  // "108 km/h"; a plain number stands without quotes
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

std::string formAdvice(const toml::node& node, const Parameter& parameter) {
  const auto* array = node.as_array();
  if (parameter.kind == Kind::number && array) return "Write a decimal point, no comma";
  if (parameter.kind == Kind::choice || parameter.kind == Kind::text) return "Put the text between quotes";
  return isList(parameter) ? "Write pairs of numbers in brackets, with decimal points" : "Write it without quotes";
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
        one.typeProblem = CaseProblem{key, typeName(node), allowedText(*parameter), formAdvice(node, *parameter)};
    } else {
      // Looking for the nearest key takes its time; a list of thousands is not read by anybody.
      one.typeProblem = ++unknown_ <= maximumProblems ? unknownKey(key) : CaseProblem{key, {}, {}, {}};
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

MeshPreset presetOf(const std::vector<Stated>& stated, MeshPreset otherwise) {
  const Stated* one = find(stated, "mesh.preset");
  return one ? presetNamed(one->text).value_or(otherwise) : otherwise;
}

// True where the file's value is only what its own preset says.
bool isOwnPreset(const Stated& one, MeshPreset filePreset) {
  for (const auto& row : presetTable())
    if (row.key == one.key) {
      const auto value = parseDecimal(one.text);
      return value && value == parseDecimal(row.values[static_cast<std::size_t>(filePreset)]);
    }
  return false;
}

MeshPreset requestedPreset(const CaseOverrides& overrides, MeshPreset filePreset, Problems& problems) {
  const std::string* set = overrideOf(overrides, "mesh.preset");
  const std::string name = set ? *set : overrides.preset;
  if (name.empty()) return filePreset;
  if (const auto named = presetNamed(name)) return *named;
  if (!set) problems.add({"--mesh", name, allowedText(*findParameter("mesh.preset")), ""});
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
                    "case schema " + std::to_string(number->get()) + " is newer than the supported schema " +
                        std::to_string(caseSchema),
                    "Use a newer version of Squat Studio");
  }
}

void applyStated(CaseDescription& description, const std::vector<Stated>& stated, MeshPreset filePreset,
                 MeshPreset preset, Problems& problems) {
  for (const auto& one : stated) {
    const std::string note = lineNote(one.line);
    if (one.typeProblem) {
      problems.add(*one.typeProblem, note);
    } else if (one.key != "mesh.preset" || !presetNamed(one.text)) {
      if (preset != filePreset && isOwnPreset(one, filePreset)) continue;
      if (auto wrong = trySetValue(description, *findParameter(one.key), one.text)) problems.add(*wrong, note);
    }
  }
}

void applyOverrides(CaseDescription& description, const CaseOverrides& overrides, Problems& problems) {
  for (const auto& [key, text] : overrides.values) {
    const Parameter* parameter = findParameter(key);
    if (!parameter)
      problems.add(unknownKey(key), " (--set)");
    else if (auto wrong = trySetValue(description, *parameter, text))
      problems.add(*wrong, " (--set)");
  }
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

// Points in the case override the file; a file given by --set overrides points of the case.
void readProfile(CaseDescription& description, const CaseOverrides& overrides, const std::filesystem::path& folder,
                 Problems& problems) {
  Defect& defect = description.defect;
  if (defect.shape != DefectShape::profile || defect.file.empty()) return;
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
    problems.throwIfAny();  // errors of the case first: the file may be one of them
  }
}

std::string_view lineOf(std::string_view text, std::size_t number) {
  for (; number > 1 && !text.empty(); --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

// What to write instead of "key = 0,15" and "key = 108 km/h", which are no TOML. Empty where it is neither.
std::string valueAdvice(std::string_view line) {
  const auto blanks = " \t\r";
  line = line.substr(0, line.find('#'));
  const auto equals = line.find('=');
  const auto from = line.find_first_not_of(blanks, equals == std::string_view::npos ? line.size() : equals + 1);
  if (from == std::string_view::npos) return {};
  const auto value = line.substr(from, line.find_last_not_of(blanks) + 1 - from);
  const auto number = value.substr(0, value.find_first_not_of("+-.0123456789eE"));
  const auto rest = value.substr(number.size());
  if (!parseDecimal(number) || rest.empty()) return {};
  if (rest.front() != ',') return "Put a value with a unit between quotes: \"" + std::string(value) + "\"";
  const auto decimals = rest.substr(1, rest.find_first_not_of("0123456789", 1) - 1);
  if (decimals.empty()) return {};
  return "Write a decimal point: " + std::string(number) + "." + std::string(decimals);
}

toml::table parsedToml(std::string_view text, const std::string& origin) {
  if (maximumKeyParts(text) > maximumParts)
    throw FileError(origin, "", "key with more than " + std::to_string(maximumParts) + " parts",
                    "Keys of a case have two parts, like pad.stiffness");
  if (const auto foreign = firstForeignByte(text); foreign.position != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(foreign.position), '\n');
    const bool outside = foreign.where == ForeignByte::Where::outsideStrings;
    throw FileError(origin, "line " + std::to_string(line),
                    outside ? "non-ASCII character outside quotes" : "non-ASCII character after a backslash",
                    outside ? "Put text between quotes" : "Write the text on one line, without the backslash");
  }
  try {
    toml::parse_result parsed = toml::parse(text, origin);
    if (parsed) return std::move(parsed).table();
    throw FileError(origin, "line " + std::to_string(parsed.error().source().begin.line),
                    "invalid TOML: " + std::string(parsed.error().description()),
                    valueAdvice(lineOf(text, parsed.error().source().begin.line)));
  } catch (const TomlAssertion& failed) {
    throw FileError(origin, "", std::string("invalid TOML: ") + failed.what());
  }
}

CaseDescription parse(std::string_view text, const std::string& origin, const std::filesystem::path& folder,
                      const CaseOverrides& overrides, bool finished) {
  if (text.size() > largestFile)
    throw FileError(origin, "", "larger than 4 MB", "Put long profiles into a CSV file and give it as defect.file");
  const toml::table table = parsedToml(text, origin);
  Problems problems;
  checkSchema(table, origin, problems);
  const Source source(text);
  const Statements statements(table, source);
  CaseDescription description = defaultCase();
  const MeshPreset filePreset = presetOf(statements.stated, description.mesh.preset);
  const MeshPreset preset = requestedPreset(overrides, filePreset, problems);
  applyPreset(description, preset);
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
