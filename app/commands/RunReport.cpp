#include "commands/RunReport.h"

#include <nlohmann/json.hpp>

#include "commands/PaperTable.h"
#include "signals/SignalError.h"
#include "studies/CaseStudy.h"
#include "studies/EvaluationFiles.h"

namespace squat::commands {

namespace {

using Json = nlohmann::ordered_json;

Json quantity(double value, const std::string& unit) { return {{"value", value}, {"unit", unit}}; }

Json scalars(const std::vector<results::Scalar>& list) {
  Json json = Json::object();
  for (const auto& scalar : list) json[scalar.name] = quantity(scalar.value, scalar.unit);
  return json;
}

// "peak [m/s2]" -> "m/s2"
std::string unitIn(const std::string& column) {
  const auto from = column.find('['), to = column.rfind(']');
  return from == std::string::npos || to == std::string::npos ? std::string() : column.substr(from + 1, to - from - 1);
}

Json featuresOf(const results::RunResult& result) {
  Json json = Json::object();
  try {
    for (const auto& [column, value] : studies::studyFeatures(result))
      json[studies::featureWord(column)] = quantity(value, unitIn(column));
  } catch (const signals::SignalError&) {
    return Json::object();
  }
  return json;
}

Json energiesOf(const results::RunResult& result) {
  Json json = Json::object();
  for (const auto& term : result.energy)
    if (!term.values.empty()) json[term.name] = quantity(term.values.back(), term.unit);
  return json;
}

}  // namespace

std::string runReport(const results::RunResult& result, const std::vector<std::string>& files) {
  Json json{{"schema", "squat-run"},           {"schema_version", 1},       {"code_version", result.codeVersion},
            {"commit", result.commit},         {"stem", result.stem},       {"title", result.title},
            {"case_hash", result.caseHash},    {"created", result.created}, {"complete", result.complete},
            {"stop_reason", result.stopReason}};
  if (const auto seconds = scalarNamed(result.performance, "seconds")) json["wall_time"] = quantity(*seconds, "s");
  json["files"] = files;
  json["features"] = featuresOf(result);
  json["energy"] = energiesOf(result);
  json["equilibrium"] = scalars(result.equilibrium);
  json["mesh"] = scalars(result.meshFigures);
  if (!result.plasticity.empty()) json["plasticity"] = scalars(result.plasticity);
  json["performance"] = scalars(result.performance);
  json["warnings"] = result.warnings;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace squat::commands
