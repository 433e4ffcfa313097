#include "validation/Judge.h"

#include "laboratory/NumberTable.h"
#include "validation/Measures.h"

namespace squat::validation {

namespace {

Judged judgeOne(const Statement& statement, const std::map<std::string, results::RunResult>& results,
                const std::string& mesh) {
  Judged judged{statement, {}, Verdict::notJudged, {}};
  if (statement.measure == "none") {
    judged.why = statement.reason;
    return judged;
  }
  if (!statement.mesh.empty() && statement.mesh != mesh) {
    judged.why = "only with --mesh " + statement.mesh;
    return judged;
  }
  for (const auto& name : {statement.run, statement.against}) {
    if (name.empty()) continue;
    const auto found = results.find(name);
    if (found == results.end()) {
      judged.why = "run " + name + " has no result";
      return judged;
    }
    const auto value = measure(found->second, statement);
    if (!value || (name == statement.against && *value == 0)) {
      judged.why = "the signal of run " + name + " does not have it";
      judged.value.reset();
      return judged;
    }
    judged.value = judged.value ? *judged.value / *value : *value;
  }
  judged.verdict = *judged.value >= statement.low && *judged.value <= statement.high ? Verdict::met : Verdict::notMet;
  return judged;
}

}  // namespace

std::vector<Judged> judge(const Reference& reference, const std::map<std::string, results::RunResult>& results,
                          const std::string& mesh) {
  std::vector<Judged> all;
  for (const auto& statement : reference.statements) all.push_back(judgeOne(statement, results, mesh));
  return all;
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

std::string judgedCsv(const std::vector<Judged>& judged) {
  using laboratory::csvField;
  using laboratory::numberText;
  std::string text = "section,statement,run,against,value,low,high,unit,verdict,reason\n";
  for (const auto& one : judged) {
    const auto& s = one.statement;
    text += csvField(s.section) + "," + csvField(s.text) + "," + csvField(s.run) + "," + csvField(s.against) + ",";
    if (one.value) text += numberText(*one.value);
    const bool ranged = s.measure != "none";
    text += "," + (ranged ? numberText(s.low) : "") + "," + (ranged ? numberText(s.high) : "") + "," +
            csvField(s.unit) + "," + toText(one.verdict) + "," + csvField(one.why.empty() ? s.reason : one.why) + "\n";
  }
  return text;
}

}  // namespace squat::validation
