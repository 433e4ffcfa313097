#include "statements/Judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/ParameterValue.h"
#include "case/Resolve.h"
#include "statements/Measures.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::statements {

namespace {

using Results = std::map<std::string, const results::RunResult*>;

bool isAboutALine(const Statement& statement) { return statement.measure == "line" && statement.against.empty(); }

// The lines of one run and point shared out among the statements about them (indices into `statements`).
void shareLines(const std::vector<Statement>& statements, const std::vector<std::size_t>& group,
                const results::RunResult& result, std::map<std::size_t, double>& shared) {
  struct Pair {
    double distance;
    std::size_t statement;
    double line, resolution;
  };
  std::vector<Pair> pairs;
  for (const std::size_t index : group)
    if (const auto lines = strongLines(result, statements[index]))
      for (const double line : lines->frequencies)
        pairs.push_back({std::abs(std::log(line / statements[index].near)), index, line, lines->resolution});
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<Pair> taken;
  for (const auto& pair : pairs) {
    const bool free = std::none_of(taken.begin(), taken.end(), [&](const Pair& other) {
      return std::abs(other.line - pair.line) < std::max(other.resolution, pair.resolution);
    });
    if (!free || shared.count(pair.statement) > 0) continue;
    shared[pair.statement] = pair.line;
    taken.push_back(pair);
  }
}

// For every statement about a line: the line that is its own.
std::map<std::size_t, double> ownLines(const std::vector<Statement>& statements, const Results& results) {
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (isAboutALine(statements[i])) groups[{statements[i].run, statements[i].point}].push_back(i);
  std::map<std::size_t, double> shared;
  for (const auto& [key, group] : groups)
    if (const auto found = results.find(key.first); found != results.end())
      shareLines(statements, group, *found->second, shared);
  return shared;
}

Judged notJudged(Judged judged, const std::string& why) {
  judged.value.reset();
  judged.why = why;
  return judged;
}

Judged judgeLine(Judged judged, const results::RunResult& result, const std::map<std::size_t, double>& lines,
                 std::size_t index) {
  if (const auto own = lines.find(index); own != lines.end()) {
    judged.value = own->second;
    return judged;
  }
  if (!strongLines(result, judged.statement))
    return notJudged(judged, "cannot be determined from run " + judged.statement.run);
  judged.verdict = Verdict::notMet;
  judged.why = "no line of its own: each strong line is assigned to the statement closest to it";
  return judged;
}

Judged judgeOne(const Statement& statement, std::size_t index, const Results& results, const std::string& mesh,
                const std::map<std::size_t, double>& lines) {
  Judged judged{statement, {}, Verdict::notJudged, {}, {}};
  if (statement.measure == "none") return notJudged(judged, statement.reason);
  if (!statement.mesh.empty() && statement.mesh != mesh) return notJudged(judged, "only with --mesh " + statement.mesh);
  for (const auto& name : {statement.run, statement.against}) {
    if (name.empty()) continue;
    const auto found = results.find(name);
    if (found == results.end()) return notJudged(judged, "no result of run " + name);
    if (isAboutALine(statement)) {
      judged = judgeLine(judged, *found->second, lines, index);
      if (!judged.value) return judged;
      continue;
    }
    const auto value = measure(*found->second, statement);
    if (!value || !std::isfinite(*value) || (name == statement.against && *value == 0))
      return notJudged(judged, "cannot be determined from run " + name);
    judged.value = judged.value ? *judged.value / *value : *value;
  }
  judged.verdict = *judged.value >= statement.low && *judged.value <= statement.high ? Verdict::met : Verdict::notMet;
  return judged;
}

std::vector<Judged> judgeAll(const std::vector<Statement>& statements, const Results& results,
                             const std::string& mesh) {
  const auto lines = ownLines(statements, results);
  std::vector<Judged> all;
  for (std::size_t i = 0; i < statements.size(); ++i) all.push_back(judgeOne(statements[i], i, results, mesh, lines));
  return all;
}

// With the numbers at the wheel centre beside them.
std::vector<Judged> judgeHereAndThere(std::vector<Statement> statements, const Results& results,
                                      const std::string& mesh) {
  auto all = judgeAll(statements, results, mesh);
  for (auto& statement : statements) statement.point = wheelCentre;
  const auto elsewhere = judgeAll(statements, results, mesh);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].statement.measure != "elements") all[i].elsewhere = elsewhere[i].value;
  return all;
}

std::string bound(double value) { return std::isinf(value) ? std::string() : text::numberText(value); }

}  // namespace

std::vector<Judged> judge(const Reference& reference, const std::map<std::string, results::RunResult>& results,
                          const std::string& mesh) {
  Results seen;
  for (const auto& [name, result] : results) seen.emplace(name, &result);
  return judgeHereAndThere(reference.statements, seen, mesh);
}

std::vector<Judged> judgeAlone(const Reference& reference, const std::string& run, const results::RunResult& result,
                               const std::string& mesh) {
  std::vector<Statement> own;
  for (const auto& statement : reference.statements)
    if (statement.run == run && statement.against.empty()) own.push_back(statement);
  return judgeHereAndThere(own, {{run, &result}}, mesh);
}

std::string toText(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::notMet:
      return "not met";
    case Verdict::notJudged:
      break;
  }
  return "not judged";
}

std::string rangeText(const Statement& s) {
  if (s.measure == "none") return {};
  const bool bare = s.unit == "1" || s.unit == "ratio" || s.unit.empty();
  const std::string unit = bare ? "" : " " + (s.unit == "m/s2" ? "m/s²" : s.unit);
  if (std::isinf(s.high)) return "at least " + text::roundedText(s.low) + unit;
  if (std::isinf(s.low)) return "at most " + text::roundedText(s.high) + unit;
  return text::roundedText(s.low) + " to " + text::roundedText(s.high) + unit;
}

int countOf(const std::vector<Judged>& judged, Verdict verdict) {
  return static_cast<int>(
      std::count_if(judged.begin(), judged.end(), [&](const Judged& one) { return one.verdict == verdict; }));
}

std::vector<ComparedParameter> compareParameters(const Reference& reference, const results::RunResult& result) {
  std::vector<ComparedParameter> all;
  auto paper = cases::defaultCase();
  const auto& ours = results::caseOf(result).description;
  for (const auto& parameter : reference.parameters) {
    const auto* known = cases::findParameter(parameter.key);
    if (!known) continue;
    cases::setValue(paper, parameter.key, parameter.value);
    ComparedParameter compared{parameter, cases::valueText(ours, *known), known->unit == "-" ? "" : known->unit, false};
    compared.same = compared.ours == cases::valueText(paper, *known);
    all.push_back(std::move(compared));
  }
  return all;
}

std::string judgedCsv(const std::vector<Judged>& judged) {
  using text::csvField;
  using text::numberText;
  std::string text =
      "section,statement,run,against,at,expected,low,high,value,unit,verdict,at the wheel centre,reason\n";
  for (const auto& one : judged) {
    const auto& s = one.statement;
    const bool ranged = s.measure != "none";
    text += csvField(s.section) + "," + csvField(s.text) + "," + csvField(s.run) + "," + csvField(s.against) + "," +
            s.point + "," + (s.expected ? numberText(*s.expected) : "") + "," + (ranged ? bound(s.low) : "") + "," +
            (ranged ? bound(s.high) : "") + "," + (one.value ? numberText(*one.value) : "") + "," + csvField(s.unit) +
            "," + toText(one.verdict) + "," + (one.elsewhere ? numberText(*one.elsewhere) : "") + "," +
            csvField(one.why.empty() ? s.reason : one.why) + "\n";
  }
  return text;
}

std::string parametersCsv(const std::vector<ComparedParameter>& parameters) {
  using text::csvField;
  std::string text = "section,parameter,key,paper,ours,unit,same\n";
  for (const auto& one : parameters)
    text += csvField(one.parameter.section) + "," + csvField(one.parameter.text) + "," + one.parameter.key + "," +
            csvField(one.parameter.value) + "," + csvField(one.ours) + "," + csvField(one.unit) + "," +
            (one.same ? "yes" : "no") + "\n";
  return text;
}

}  // namespace squat::statements
