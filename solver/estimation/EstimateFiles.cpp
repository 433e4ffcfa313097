#include "estimation/EstimateFiles.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/DurableFile.h"
#include "text/Csv.h"

namespace squat::estimation {

namespace {

constexpr const char* kProfileFile = "estimate-profile.csv";

double rounded(double value, double step) { return std::round(value / step) * step; }

std::string table(const Estimate& estimate) {
  std::vector<double> position, height, lower, upper, felt;
  for (const auto& sample : estimate.profile) {
    position.push_back(rounded(1e3 * sample.position, 1e-3));
    height.push_back(rounded(1e6 * sample.height, 1e-3));
    lower.push_back(rounded(1e6 * sample.lower, 1e-3));
    upper.push_back(rounded(1e6 * sample.upper, 1e-3));
    felt.push_back(sample.isFelt ? 1 : 0);
  }
  return text::csvColumns({"position [mm]", "height [um]", "lower [um]", "upper [um]", "felt"},
                          {&position, &height, &lower, &upper, &felt});
}

std::string profileTable(const Estimate& estimate) {
  std::vector<double> position, height;
  for (const auto& sample : estimate.profile) {
    position.push_back(rounded(1e3 * sample.position, 1e-3));
    height.push_back(rounded(1e6 * sample.height, 1e-3));
  }
  return text::csvColumns({"position [mm]", "height [um]"}, {&position, &height});
}

}  // namespace

std::vector<std::string> estimateFiles(const std::string& folder) {
  return {folder + "/estimate.csv", folder + "/estimate.toml", folder + "/" + kProfileFile, folder + "/estimate.json"};
}

void writeEstimate(const Estimate& estimate, const std::string& folder) {
  const auto paths = estimateFiles(folder);
  writeDurably(paths[0], std::string_view(table(estimate)));
  writeDurably(paths[2], std::string_view(profileTable(estimate)));
  auto description = estimate.description;
  description.title = "Estimated from " + estimate.passages.front().name;
  description.defect.points.clear();
  description.defect.file = kProfileFile;
  writeDurably(paths[1], std::string_view(cases::writeCase(description)));
  writeDurably(paths[3], std::string_view(estimateJson(estimate)));
}

std::string estimateJson(const Estimate& estimate) {
  using nlohmann::json;
  const auto interval = [](const Interval& each, double unit) {
    return json{{"value", each.value * unit}, {"low", each.low * unit}, {"high", each.high * unit}};
  };
  json all{{"schema", "squat-estimate"},
           {"schema_version", 1},
           {"complete", estimate.complete},
           {"depth_um", interval(estimate.depth, 1e6)},
           {"length_mm", interval(estimate.length, 1e3)},
           {"wheel_path_depth_um", 1e6 * estimate.depthOfPath},
           {"misfit", estimate.misfit},
           {"runs", estimate.runs},
           {"notes", estimate.notes}};
  for (const auto& passage : estimate.passages)
    all["passages"].push_back({{"name", passage.name},
                               {"speed", passage.speed},
                               {"position", passage.location},
                               {"peak", passage.peak},
                               {"noise", passage.noise},
                               {"difference", passage.difference}});
  for (const auto& sample : estimate.profile)
    all["profile"].push_back({{"position_mm", 1e3 * sample.position},
                              {"height_um", 1e6 * sample.height},
                              {"lower_um", 1e6 * sample.lower},
                              {"upper_um", 1e6 * sample.upper},
                              {"felt", sample.isFelt}});
  return all.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace squat::estimation
