#include "commands/RunReport.h"

#include <nlohmann/json.hpp>

#include "analysis/FeatureTable.h"
#include "commands/PaperTable.h"

namespace squat::commands {

namespace {

using Json = nlohmann::ordered_json;

Json quantity(double value, const std::string& unit) { return {{"value", value}, {"unit", unit}}; }

Json scalars(const std::vector<results::Scalar>& list) {
  Json json = Json::object();
  for (const auto& scalar : list) json[scalar.name] = quantity(scalar.value, scalar.unit);
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
  // Results of versions up to 0.2.0 hold none.
  json["features"] = scalars(result.features.empty() ? analysis::featureScalars(result) : result.features);
  json["energy"] = energiesOf(result);
  json["equilibrium"] = scalars(result.equilibrium);
  json["mesh"] = scalars(result.meshFigures);
  if (!result.plasticity.empty()) json["plasticity"] = scalars(result.plasticity);
  json["performance"] = scalars(result.performance);
  json["warnings"] = result.warnings;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace squat::commands
