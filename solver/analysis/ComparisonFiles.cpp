#include "analysis/ComparisonFiles.h"

#include <nlohmann/json.hpp>
#include <set>

#include "analysis/AnalysisFiles.h"
#include "core/DurableFile.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json rowOf(const std::vector<std::pair<std::string, double>>& row) {
  Json json;
  for (const auto& [name, value] : row) json[name] = value;
  return json;
}

}  // namespace

std::string comparisonCsv(const std::vector<FileComparison>& comparisons) {
  // Pairs may have different numbers of common lines: the longest row names the columns.
  std::vector<std::string> names;
  for (const auto& entry : comparisons) {
    const auto row = signals::comparisonRow(entry.comparison);
    if (row.size() > names.size()) {
      names.clear();
      for (const auto& [name, value] : row) names.push_back(name);
    }
  }
  std::string text = "first,second";
  for (const auto& name : names) text += "," + text::csvField(name);
  text += '\n';
  for (const auto& entry : comparisons) {
    text += text::csvField(entry.comparison.firstName) + "," + text::csvField(entry.comparison.secondName);
    const auto row = signals::comparisonRow(entry.comparison);
    for (std::size_t i = 0; i < names.size(); ++i)
      text += "," + (i < row.size() ? text::numberText(row[i].second) : "");
    text += '\n';
  }
  return text;
}

std::string comparisonJson(const std::vector<FileComparison>& comparisons) {
  Json json{{"schema", "squat-comparison"}, {"schema_version", 1}, {"pairs", Json::array()}};
  for (const auto& entry : comparisons)
    json["pairs"].push_back({{"first_file", entry.firstFile},
                             {"second_file", entry.secondFile},
                             {"first", entry.comparison.firstName},
                             {"second", entry.comparison.secondName},
                             {"comparison", rowOf(signals::comparisonRow(entry.comparison))},
                             {"first_anchor", signals::toText(entry.comparison.firstFeatures.anchor)},
                             {"second_anchor", signals::toText(entry.comparison.secondFeatures.anchor)},
                             {"first_features", rowOf(signals::featureRow(entry.comparison.firstFeatures))},
                             {"second_features", rowOf(signals::featureRow(entry.comparison.secondFeatures))},
                             {"notes", entry.notes}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string overlayCsv(const signals::Comparison& c) {
  const std::string unit = " [" + c.unit + "]";
  return text::csvColumns(
      {c.inPosition ? "position [m]" : "time [s]", c.firstName + unit, c.secondName + unit, "difference" + unit},
      {&c.axis, &c.first, &c.second, &c.difference});
}

std::string spectraCsv(const signals::Comparison& c) {
  const std::string unit = " [(" + c.unit + ")2/Hz]";
  return text::csvColumns(
      {"frequency [Hz]", c.firstName + unit, c.secondName + unit, "ratio [-]"},
      {&c.firstSpectrum.frequency, &c.firstSpectrum.density, &c.secondSpectrum.density, &c.densityRatio});
}

std::vector<std::string> writeComparisons(const std::vector<FileComparison>& comparisons, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files{{"comparison.csv", comparisonCsv(comparisons)},
                                                         {"comparison.json", comparisonJson(comparisons)}};
  std::set<std::string> names;
  for (const auto& entry : comparisons) {
    const std::string base = safeFileName(entry.comparison.secondName);
    std::string name = base;
    for (int i = 2; !names.insert(name).second; ++i) name = base + "_" + std::to_string(i);
    files.emplace_back(name + "_overlay.csv", overlayCsv(entry.comparison));
    files.emplace_back(name + "_spectra.csv", spectraCsv(entry.comparison));
  }
  std::vector<std::string> inputs;
  for (const auto& entry : comparisons) inputs.insert(inputs.end(), {entry.firstFile, entry.secondFile});
  std::vector<std::string> paths;
  for (const auto& [name, text] : files) paths.push_back(folder + "/" + name);
  keepInputs(inputs, paths);
  makeFolder(folder);
  for (std::size_t i = 0; i < files.size(); ++i) writeDurably(paths[i], std::string_view(files[i].second));
  return paths;
}

}  // namespace squat::analysis
