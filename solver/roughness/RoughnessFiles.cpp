#include "roughness/RoughnessFiles.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/AnalysisFiles.h"
#include "core/DurableFile.h"
#include "scenario/Irregularity.h"
#include "text/Csv.h"
#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::roughness {

namespace {

using Json = nlohmann::ordered_json;
using text::formatted;

// Of the exact middle: 6.3 mm for 6.31 mm.
std::string wavelengthText(double metres) { return formatted("%.3g mm", 1e3 * metres); }
std::string levelText(double level) { return std::isfinite(level) ? formatted("%.1f", level) : "-"; }
std::string micrometres(double metres) { return std::isfinite(metres) ? formatted("%.3g", 1e6 * metres) : "-"; }

Json numberOf(double value) { return std::isfinite(value) ? Json(value) : Json(); }

double limitAt(double wavelength) { return scenario::levelAt(scenario::iso3095Limit(), wavelength); }

Json levelsJson(const RecordRoughness& roughness) {
  Json rows = Json::array();
  for (const auto& row : roughness.levels)
    rows.push_back({{"wavelength_mm", 1e3 * row.band.middle},
                    {"level_db", numberOf(row.level)},
                    {"lowest_db", numberOf(row.lowest)},
                    {"highest_db", numberOf(row.highest)},
                    {"iso_3095_db", numberOf(limitAt(row.band.middle))},
                    {"track_db", numberOf(row.track)},
                    {"pads_db", numberOf(row.pads)},
                    {"waves", numberOf(row.waves)},
                    {"weak_share", numberOf(row.weak)}});
  return rows;
}

Json corrugationJson(const RecordRoughness& roughness) {
  Json rows = Json::array();
  for (const auto& index : roughness.corrugation)
    rows.push_back({{"shortest_mm", 1e3 * index.band.shortest},
                    {"longest_mm", 1e3 * index.band.longest},
                    {"window_m", index.band.window()},
                    {"rms_um", numberOf(1e6 * index.rms)},
                    {"median_um", numberOf(1e6 * index.typical)},
                    {"exceeded_by_5_percent_um", numberOf(1e6 * index.exceeded)},
                    {"largest_um", numberOf(1e6 * index.largest)},
                    {"largest_after_m", numberOf(index.largestAt)},
                    {"windows", index.windows}});
  return rows;
}

std::vector<double> magnitudes(const std::vector<double>& power) {
  std::vector<double> values;
  for (const double each : power) values.push_back(std::sqrt(each));
  return values;
}

}  // namespace

std::string roughnessSummary(const NamedRoughness& named) {
  const auto& [name, roughness] = named;
  std::string text = "roughness that " + (name.empty() ? std::string("the signal") : name) +
                     " implies: " + formatted("%.4g m", roughness.length) + formatted(" at %.3g m/s", roughness.speed) +
                     ", contact filter " + toText(roughness.filter) + "\n";
  text::TextTable levels({"wavelength", "dB re 1 µm", "from", "to", "ISO 3095", "track", "pads", "waves", "weak"});
  for (const auto& row : roughness.levels)
    if (std::isfinite(row.level))
      levels.add({wavelengthText(row.band.middle), levelText(row.level), levelText(row.lowest), levelText(row.highest),
                  levelText(limitAt(row.band.middle)), levelText(row.track), levelText(row.pads),
                  formatted("%.0f", row.waves), formatted("%.0f %%", 100 * row.weak)});
  if (levels.empty()) text += "  no third octave lies within what the record and the transfer function reach\n";
  if (!levels.empty()) text += levels.text();
  text::TextTable corrugation({"corrugation", "window", "rms [µm]", "median", "5 % exceed", "largest", "after"});
  for (const auto& index : roughness.corrugation)
    corrugation.add({formatted("%.0f", 1e3 * index.band.shortest) + formatted(" to %.0f mm", 1e3 * index.band.longest),
                     formatted("%.3g m", index.band.window()), micrometres(index.rms), micrometres(index.typical),
                     micrometres(index.exceeded), micrometres(index.largest),
                     std::isfinite(index.largestAt) ? formatted("%.1f m", index.largestAt) : "-"});
  text += "\n" + corrugation.text();
  if (roughness.left > 0)
    text += "note: " + formatted("%.4g m", roughness.left) +
            " left out: slower than 1 m/s, speed changing by more than a tenth, or not a number\n";
  for (const auto& note : roughness.notes) text += "note: " + note + "\n";
  return text;
}

std::string roughnessCsv(const RecordRoughness& roughness) {
  std::vector<double> wavelength, level, lowest, highest, limit, track, pads, waves, weak;
  for (const auto& row : roughness.levels) {
    wavelength.push_back(1e3 * row.band.middle);
    level.push_back(row.level), lowest.push_back(row.lowest), highest.push_back(row.highest);
    const double iso = limitAt(row.band.middle);
    limit.push_back(std::isfinite(iso) ? iso : std::nan(""));
    track.push_back(row.track), pads.push_back(row.pads), waves.push_back(row.waves), weak.push_back(row.weak);
  }
  return text::csvColumns({"wavelength [mm]", "level [dB re 1 um]", "lowest [dB re 1 um]", "highest [dB re 1 um]",
                           "ISO 3095:2013 [dB re 1 um]", "track [dB]", "pads [dB]", "waves", "weak share"},
                          {&wavelength, &level, &lowest, &highest, &limit, &track, &pads, &waves, &weak});
}

std::string transferCsv(const TransferFunction& transfer) {
  std::vector<double> real, imaginary;
  for (const auto& value : transfer.response) real.push_back(value.real()), imaginary.push_back(value.imag());
  const auto mean = magnitudes(transfer.power), sleeper = magnitudes(transfer.overSleeper.power),
             midspan = magnitudes(transfer.midspan.power), soft = magnitudes(transfer.softPads.power),
             stiff = magnitudes(transfer.stiffPads.power);
  return text::csvColumns({"frequency [Hz]", "real [1/s2]", "imaginary [1/s2]", "magnitude [1/s2]",
                           "over a sleeper [1/s2]", "midspan [1/s2]", "softer pads [1/s2]", "stiffer pads [1/s2]"},
                          {&transfer.frequency, &real, &imaginary, &mean, &sleeper, &midspan, &soft, &stiff});
}

std::string roughnessJson(const std::vector<NamedRoughness>& roughness, const TransferFunction& transfer,
                          const std::string& caseName) {
  Json signals = Json::array();
  for (const auto& [name, each] : roughness)
    signals.push_back({{"name", name},
                       {"length_m", each.length},
                       {"left_out_m", each.left},
                       {"speed_m_s", each.speed},
                       {"contact_filter", toText(each.filter)},
                       {"levels", levelsJson(each)},
                       {"corrugation", corrugationJson(each)},
                       {"notes", each.notes}});
  const Json json{{"schema", "squat-roughness"},
                  {"schema_version", 1},
                  {"case", caseName},
                  {"transfer",
                   {{"wheel_load_n", transfer.load},
                    {"contact_stiffness_n_m", transfer.contactStiffness},
                    {"half_patch_mm", 1e3 * transfer.halfPatch},
                    {"half_wheelset_kg", transfer.wheelsetMass},
                    {"notes", transfer.notes}}},
                  {"signals", signals}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string fileStem(const std::vector<NamedRoughness>& roughness, std::size_t index) {
  const auto& name = roughness[index].first;
  const auto number = roughness.size() > 1 ? std::to_string(index + 1) + "-" : std::string();
  return number + analysis::safeFileName(name.empty() ? "signal" : name) + "_roughness";
}

std::vector<std::string> writeRoughness(const std::vector<NamedRoughness>& roughness, const TransferFunction& transfer,
                                        const std::string& caseName, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files{
      {folder + "/roughness.json", roughnessJson(roughness, transfer, caseName)},
      {folder + "/roughness-transfer.csv", transferCsv(transfer)}};
  for (std::size_t i = 0; i < roughness.size(); ++i)
    files.emplace_back(folder + "/" + fileStem(roughness, i) + ".csv", roughnessCsv(roughness[i].second));
  std::vector<std::string> paths;
  for (const auto& [path, content] : files) {
    writeDurably(path, std::string_view(content));
    paths.push_back(path);
  }
  return paths;
}

}  // namespace squat::roughness
