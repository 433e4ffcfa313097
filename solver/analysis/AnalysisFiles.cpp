#include "analysis/AnalysisFiles.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/DurableFile.h"
#include "text/Csv.h"
#include "text/Numbers.h"

namespace squat::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const signals::Dispersion& dispersion) {
  return {{"values", dispersion.values},
          {"mean", dispersion.mean},
          {"standard_deviation", dispersion.standardDeviation},
          {"range_by_mean", dispersion.range}};
}

Json jsonOf(const signals::PowerSpectrum& spectrum) {
  return {{"window", spectrum.window}, {"integral", spectrum.integral}, {"mean_square", spectrum.meanSquare}};
}

Json jsonOf(const SignalAnalysis& signal) {
  const auto& f = signal.features;
  Json features, bands = Json::array(), peaks = Json::array();
  for (const auto& [name, value] : signals::featureRow(f)) features[name] = value;
  for (const auto& band : f.bands)
    bands.push_back({{"name", band.band.name},
                     {"low_hz", band.band.low},
                     {"high_hz", band.band.high},
                     {"power", band.power},
                     {"share", band.share},
                     {"free_vibration_s", band.freeVibration},
                     {"vibrates_at_least_s", band.ringsFor}});
  for (const auto& peak : f.peaks)
    peaks.push_back({{"frequency_hz", peak.frequency},
                     {"density", peak.density},
                     {"prominence", peak.prominence},
                     {"width_hz", peak.width}});
  return {{"file", signal.file},
          {"run", signal.run},
          {"unit", f.unit},
          {"rate_hz", signal.filtered.rate()},
          {"samples", signal.filtered.values.size()},
          {"anchor", signals::toText(f.anchor)},
          {"features", features},
          {"bands", bands},
          {"peaks", peaks},
          {"spectrum", jsonOf(signal.spectrum)},
          {"spectrum_around_impact", jsonOf(f.spectrum)},
          {"notes", signal.notes}};
}

}  // namespace

FeatureTable featureTable(const Analysis& analysis) {
  FeatureTable table;
  std::vector<std::vector<std::pair<std::string, double>>> rows;
  for (const auto& signal : analysis.signals) {
    rows.push_back(signals::featureRow(signal.features));
    for (const auto& [name, value] : rows.back())
      if (std::find(table.names.begin(), table.names.end(), name) == table.names.end()) table.names.push_back(name);
  }
  for (const auto& row : rows) {
    auto& values = table.values.emplace_back(table.names.size(), NAN);
    for (const auto& [name, value] : row)
      values[static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) - table.names.begin())] =
          value;
  }
  return table;
}

std::string featureCsv(const Analysis& analysis) {
  const FeatureTable table = featureTable(analysis);
  std::string text = "file,run,anchor";
  for (const auto& name : table.names) text += "," + text::csvField(name);
  text += '\n';
  for (std::size_t i = 0; i < analysis.signals.size(); ++i) {
    text += text::csvField(analysis.signals[i].file) + "," + text::csvField(analysis.signals[i].run) + "," +
            text::csvField(signals::toText(analysis.signals[i].features.anchor));
    for (const double value : table.values[i]) text += "," + text::numberText(value);
    text += '\n';
  }
  return text;
}

std::string featureJson(const Analysis& analysis) {
  Json json{{"schema", "squat-features"}, {"schema_version", 1}};
  json["signals"] = Json::array();
  for (const auto& signal : analysis.signals) json["signals"].push_back(jsonOf(signal));
  if (analysis.dispersion)
    json["dispersion"] = {{"largest_peak", jsonOf(analysis.dispersion->largestPeak)},
                          {"wavelength_m", jsonOf(analysis.dispersion->wavelength)}};
  json["notes"] = analysis.notes;
  // File names need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string spectrumCsv(const SignalAnalysis& signal) {
  const std::string unit = " [(" + signal.features.unit + ")2/Hz]";
  const auto& local = signal.features.spectrum;
  return text::csvColumns(
      {"frequency [Hz]", "whole record" + unit, "frequency around the impact [Hz]", "around the impact" + unit},
      {&signal.spectrum.frequency, &signal.spectrum.density, &local.frequency, &local.density});
}

std::string alignedCsv(const signals::AlignedRuns& runs) {
  std::vector<std::string> names{runs.inPosition ? "position [m]" : "time [s]", "mean", "lowest", "highest"};
  std::vector<const std::vector<double>*> columns{&runs.axis, &runs.mean, &runs.lowest, &runs.highest};
  for (std::size_t r = 0; r < runs.values.size(); ++r) {
    names.push_back(runs.names[r]);
    columns.push_back(&runs.values[r]);
  }
  return text::csvColumns(names, columns);
}

std::string safeFileName(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-';
    if (plain)
      safe += c;
    else if (!safe.empty() && safe.back() != '_')
      safe += '_';
  }
  while (!safe.empty() && safe.back() == '_') safe.pop_back();
  return safe.empty() ? "signal" : safe.substr(0, 100);
}

std::vector<std::string> writeAnalysis(const Analysis& analysis, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files{{"features.csv", featureCsv(analysis)},
                                                         {"features.json", featureJson(analysis)}};
  std::set<std::string> names;
  for (const auto& signal : analysis.signals) {
    const std::string base = safeFileName(signal.run);
    std::string name = base;
    for (int i = 2; !names.insert(name).second; ++i) name = base + "_" + std::to_string(i);
    files.emplace_back(name + "_spectrum.csv", spectrumCsv(signal));
  }
  if (analysis.inTime) files.emplace_back("aligned_time.csv", alignedCsv(*analysis.inTime));
  if (analysis.inPosition) files.emplace_back("aligned_position.csv", alignedCsv(*analysis.inPosition));
  std::vector<std::string> inputs;
  for (const auto& signal : analysis.signals) inputs.push_back(signal.file);
  std::vector<std::string> paths;
  for (const auto& [name, text] : files) paths.push_back(folder + "/" + name);
  keepInputs(inputs, paths);
  makeFolder(folder);
  for (std::size_t i = 0; i < files.size(); ++i) writeDurably(paths[i], std::string_view(files[i].second));
  return paths;
}

}  // namespace squat::analysis
