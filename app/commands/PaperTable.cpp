#include "commands/PaperTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "commands/TextTable.h"
#include "laboratory/RunFeatures.h"
#include "signals/SignalError.h"
#include "validation/PaperCase.h"

namespace squat::commands {

namespace {

using results::RunResult;

constexpr const char* kNone = "not available";

struct PaperLine {
  const char* name;       // row
  double low, high;       // [Hz] within which the line counts as the paper's
  const char* statement;  // of the paper
};
// Light defect: about 300 and 1000 Hz (section 4.1). Class C squat: 130-320 and 1030-1130 Hz (section 4.2).
constexpr PaperLine kLightLines[] = {{"line near 300 Hz", 250, 400, "300 Hz"},
                                     {"line near 1000 Hz", 950, 1200, "1000 Hz"}};
constexpr PaperLine kSquatLines[] = {{"line at 130-320 Hz", 130, 320, "130-320 Hz"},
                                     {"line at 1030-1130 Hz", 1030, 1130, "1030-1130 Hz"}};

using validation::PaperCase;

bool startsWith(const std::string& text, const char* beginning) { return text.rfind(beginning, 0) == 0; }

// Which of the paper's cases the result is; nothing where it is none of them or a key differs.
std::string paperName(const std::optional<PaperCase>& nearest) {
  return nearest && nearest->isThePapers() ? nearest->name : std::string();
}

// Why the paper's statements are not judged, for a case that is nearly the paper's.
void addChangedKeys(std::vector<PaperRow>& rows, const PaperCase& nearest) {
  constexpr std::size_t listed = 3;
  for (std::size_t i = 0; i < std::min(listed, nearest.changed.size()); ++i) {
    const auto& one = nearest.changed[i];
    rows.push_back(
        {"differs from " + nearest.name, one.key + " = " + one.ours, "paper's case: " + one.paper, "not judged"});
  }
  if (nearest.changed.size() > listed)
    rows.push_back({"differs from " + nearest.name,
                    "and " + std::to_string(nearest.changed.size() - listed) + " more keys", "", "not judged"});
}

struct Lines {
  std::vector<signals::SpectralPeak> peaks;
  double apart = 0;  // [Hz] nearer lines are one: Hann's main lobe is two steps of 1/T wide either way
};

// From 0.1 m before the defect to `after` behind it, as far as the record goes.
Lines strongLines(const RunResult& result, double after) {
  signals::FeatureOptions options;
  options.after = after;
  try {
    const auto spectrum = laboratory::runFeatures(result, options).spectrum;
    Lines lines{signals::namedLines(spectrum), 0};
    const double step = (result.time.back() - result.time.front()) / static_cast<double>(result.time.size() - 1);
    lines.apart = 2 / (static_cast<double>(spectrum.segmentLength) * step);
    return lines;
  } catch (const signals::SignalError&) {  // too short, constant
    return {};
  }
}

std::string listed(const std::vector<signals::SpectralPeak>& lines) {
  std::string text;
  for (const auto& line : lines) text += (text.empty() ? "" : ", ") + std::to_string(std::lround(line.frequency));
  return text.empty() ? kNone : text + " Hz";
}

void addPeak(std::vector<PaperRow>& rows, const RunResult& result, const char* channel, const char* what,
             const std::string& paper) {
  const auto* values = result.signal(channel);
  if (!values || values->empty()) {
    rows.push_back({what, kNone, paper, ""});
    return;
  }
  const auto [low, high] = std::minmax_element(values->begin(), values->end());
  rows.push_back({what, number(*high) + " / " + number(*low) + " m/s²", paper, ""});
}

void addLines(std::vector<PaperRow>& rows, const RunResult& result, const std::string& paper) {
  constexpr double figure = 0.28, lowLines = 0.58, lowest = 320;  // [m], [m], [Hz] as `squat validate` judges
  const auto strong = strongLines(result, figure);
  rows.push_back({"strongest lines of the PSD", listed(strong.peaks),
                  strong.peaks.empty() ? "" : "resolution " + number(std::round(strong.apart), "Hz"), ""});
  const bool light = paper == "light-defect";
  if (!light && !startsWith(paper, "class-c-squat")) return;
  for (const auto& wanted : light ? kLightLines : kSquatLines) {
    const bool isLow = wanted.low < lowest && !result.position.empty();
    const auto seen = isLow ? strongLines(result, std::clamp(result.position.back() - 0.02, figure, lowLines)) : strong;
    if (seen.apart == 0) {
      rows.push_back({wanted.name, kNone, wanted.statement, ""});
      continue;
    }
    const auto& lines = seen.peaks;
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
      return line.frequency >= wanted.low && line.frequency <= wanted.high;
    });
    rows.push_back({wanted.name, found == lines.end() ? "none" : number(std::round(found->frequency), "Hz"),
                    wanted.statement, found == lines.end() ? "not met" : "met"});
  }
}

// What lines, wavelength and band powers refer to.
void addAnchor(std::vector<PaperRow>& rows, const RunResult& result) {
  try {
    const auto features = laboratory::runFeatures(result);
    rows.push_back(
        {"features anchored at", number(1e3 * features.impactTime, "ms"), signals::toText(features.anchor), ""});
  } catch (const signals::SignalError&) {  // too short: no features
  }
}

void addWavelength(std::vector<PaperRow>& rows, const RunResult& result, const std::string& paper) {
  PaperRow row{"mean wavelength after the impact", kNone, paper == "light-defect" ? "29 mm" : "", ""};
  try {
    const double length = laboratory::runFeatures(result).wavelengthByRidge;
    if (length > 0) row.ours = number(1e3 * length, "mm");
  } catch (const signals::SignalError&) {  // too short for a spectrum: stays "not available"
  }
  rows.push_back(row);
}

void addContact(std::vector<PaperRow>& rows, const RunResult& result) {
  struct Compared {
    const char *name, *hertz, *what, *unit;
    double factor;
  };
  static constexpr Compared compared[] = {
      {"half_axis_rolling", "hertz_half_axis_rolling", "contact patch, semi-axis along the rail", "mm", 1e3},
      {"half_axis_lateral", "hertz_half_axis_lateral", "contact patch, semi-axis across the rail", "mm", 1e3},
      {"peak_pressure", "hertz_peak_pressure", "peak pressure", "GPa", 1e-9},
      {"approach", "hertz_approach", "approach of wheel and rail", "mm", 1e3},
  };
  if (const auto force = scalarNamed(result.equilibrium, "contact_force")) {
    const auto weight = scalarNamed(result.equilibrium, "weight");
    rows.push_back({"contact force at equilibrium", number(1e-3 * *force, "kN"),
                    weight ? "weight " + number(1e-3 * *weight, "kN") : "", ""});
  }
  for (const auto& item : compared) {
    const auto ours = scalarNamed(result.equilibrium, item.name);
    if (!ours) continue;
    PaperRow row{item.what, number(item.factor * *ours, item.unit), "", ""};
    if (const auto hertz = scalarNamed(result.equilibrium, item.hertz); hertz && *hertz > 0) {
      row.paper = "Hertz " + number(item.factor * *hertz, item.unit);
      if (std::string(item.name) == "approach") {  // of the mean rail section less the hub: web and foot give as well
        rows.push_back({row.what, row.ours, row.paper + ", local contact only", ""});
        continue;
      }
      char text[32];
      std::snprintf(text, sizeof text, "%+.1f %%", 100 * (*ours / *hertz - 1));
      row.verdict = text;
    }
    rows.push_back(row);
  }
}

const char* passed(bool isPassed) { return isPassed ? "passed" : "failed"; }

// Where the rail is no longer smooth, at most 40 mm before the deepest point of the defect.
double defectBegins(const RunResult& result) {
  double from = -0.04;
  for (std::size_t i = 0; i < result.profileHeight.size(); ++i)
    if (result.profileHeight[i] != 0) return std::min(from, result.profilePosition[i]);
  return from;
}

// Maximum deviation from the mean over the last 0.2 m (or what there is) before the defect.
void addQuietness(std::vector<PaperRow>& rows, const RunResult& result) {
  const double end = defectBegins(result), begin = end - 0.2;
  const auto* values = result.signal("aba_filtered");
  if (!values || values->size() != result.position.size()) return;
  std::vector<double> window;
  double first = end;
  for (std::size_t i = 0; i < values->size(); ++i)
    if (result.position[i] >= begin && result.position[i] <= end) {
      first = std::min(first, result.position[i]);
      window.push_back((*values)[i]);
    }
  if (window.size() < 2) return;
  double mean = 0, largest = 0;
  for (const double value : window) mean += value / static_cast<double>(window.size());
  for (const double value : window) largest = std::max(largest, std::abs(value - mean));
  constexpr double limit = 5;  // [m/s2]
  char what[64];
  std::snprintf(what, sizeof what, "residual vibration before the defect (%.2f m)", end - first);
  rows.push_back({what, number(largest, "m/s2"), "limit " + number(limit, "m/s2"), passed(largest < limit)});
}

// Maximum error of the energy balance, relative to the strain energy at equilibrium plus all dissipation.
void addEnergy(std::vector<PaperRow>& rows, const RunResult& result) {
  const auto residual = scalarNamed(result.performance, "energy_residual");
  if (!residual) return;
  rows.push_back({"energy balance error, maximum", number(100 * *residual, "%"), "limit 0.1 %",
                  passed(std::abs(*residual) < 0.001)});
}

// Only where the rail may yield.
void addPlasticity(std::vector<PaperRow>& rows, const RunResult& result) {
  if (const auto strain = scalarNamed(result.plasticity, "largest_equivalent_strain"))
    rows.push_back({"plastic strain, maximum", number(100 * *strain, "%"), "", ""});
  if (const auto deepest = scalarNamed(result.plasticity, "deepest_change"))
    rows.push_back({"permanent surface deformation, maximum", number(1e6 * *deepest, "um"), "", ""});
}

void addCost(std::vector<PaperRow>& rows, const RunResult& result) {
  const auto add = [&](const std::vector<results::Scalar>& list, const char* name, const char* what, double factor,
                       const char* unit) {
    if (const auto value = scalarNamed(list, name)) rows.push_back({what, number(factor * *value, unit), "", ""});
  };
  add(result.meshFigures, "elements", "elements", 1, "");
  add(result.performance, "steps", "time steps", 1, "");
  add(result.meshFigures, "stable_step", "stable time step", 1e6, "us");
  add(result.performance, "element_updates_per_second", "element updates per second", 1e-6, "million");
  add(result.performance, "seconds", "wall time", 1, "s");
  add(result.performance, "peak_memory", "peak memory of the simulation", 1.0 / (1 << 20), "MiB");
}

}  // namespace

std::optional<double> scalarNamed(const std::vector<results::Scalar>& list, const std::string& name) {
  for (const auto& scalar : list)
    if (scalar.name == name) return scalar.value;
  return std::nullopt;
}

std::vector<PaperRow> paperRows(const RunResult& result) {
  std::vector<PaperRow> rows;
  const auto nearest = validation::paperCaseOf(result);
  const std::string paper = paperName(nearest);
  if (nearest) addChangedKeys(rows, *nearest);
  addPeak(rows, result, "aba_filtered", "axle box acceleration, maximum / minimum",
          paper == "light-defect" ? "115 m/s² computed, 100 measured" : "");
  addPeak(rows, result, "wheel_acceleration_filtered", "wheel centre acceleration, maximum / minimum", "");
  addAnchor(rows, result);
  addLines(rows, result, paper);
  addWavelength(rows, result, paper);
  addContact(rows, result);
  addQuietness(rows, result);
  addPlasticity(rows, result);
  addEnergy(rows, result);
  addCost(rows, result);
  return rows;
}

std::string paperTable(const RunResult& result) {
  TextTable table({result.stem, "this run", "paper or theory", ""});
  bool missed = false;
  for (const auto& row : paperRows(result)) {
    table.add({row.what, row.ours, row.paper, row.verdict});
    missed = missed || (row.verdict == "not met" && startsWith(row.what, "line "));
  }
  auto text = table.text(kTerminalWidth);
  if (missed && !result.modes.empty())
    text += "\nA spectral line of the paper is not met. Natural modes of the free half wheelset, for comparison:\n" +
            modesTable(result);
  return text;
}

std::string modesTable(const RunResult& result) {
  std::vector<model::HarmonicMode> modes;
  for (const auto& mode : result.modes)
    modes.push_back({mode.frequency, 0, mode.boxShare, mode.wheelShare, mode.contactShare});
  return modesTable(modes);
}

std::string modesTable(const std::vector<model::HarmonicMode>& modes) {
  TextTable table({"mode [Hz]", "axle box", "wheel centre", "contact [1/√kg]"});
  for (const auto& mode : modes)
    table.add({number(mode.frequency), number(mode.boxShare), number(mode.wheelShare), number(mode.contactShare)});
  return table.text();
}

std::string phasesTable(const RunResult& result) {
  const std::string prefix = "seconds_";
  TextTable table({"phase", "wall time [s]"});
  for (const auto& scalar : result.performance)
    if (scalar.name.rfind(prefix, 0) == 0) table.add({scalar.name.substr(prefix.size()), number(scalar.value)});
  return table.empty() ? std::string() : table.text();
}

}  // namespace squat::commands
