#include "commands/PaperTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/RunFeatures.h"
#include "analysis/WheelForces.h"
#include "commands/ValidationText.h"
#include "receptance/ReceptanceSummary.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "statements/JudgeRun.h"
#include "statements/Measures.h"
#include "statements/RunChecks.h"
#include "text/Numbers.h"
#include "text/TextTable.h"
#include "text/Units.h"

namespace squat::commands {

namespace {

using text::kTerminalWidth;
using text::roundedText;
using text::TextTable;

using results::RunResult;

constexpr const char* kNone = "not available";

using statements::PaperCase;

// Why the paper's statements are not judged, for a case that is nearly the paper's.
void addChangedKeys(std::vector<PaperRow>& rows, const PaperCase& nearest, const std::vector<std::string>& setByHand) {
  constexpr std::size_t listed = 3;
  auto changed = nearest.changed;
  std::stable_partition(changed.begin(), changed.end(), [&](const auto& one) {
    return std::find(setByHand.begin(), setByHand.end(), one.key) != setByHand.end();
  });
  for (std::size_t i = 0; i < std::min(listed, changed.size()); ++i) {
    const auto& one = changed[i];
    rows.push_back(
        {"differs from " + nearest.name, one.key + " = " + one.ours, "paper's case: " + one.paper, "not judged"});
  }
  if (const auto more = changed.size() - std::min(listed, changed.size()); more > 0)
    rows.push_back({"differs from " + nearest.name,
                    "and " + std::to_string(more) + (more == 1 ? " more key" : " more keys"), "", "not judged"});
}

void addPeak(std::vector<PaperRow>& rows, const RunResult& result, const char* channel, const char* what) {
  const auto* values = result.signal(channel);
  if (!values || values->empty()) {
    rows.push_back({what, kNone, "", ""});
    return;
  }
  const auto [low, high] = std::minmax_element(values->begin(), values->end());
  rows.push_back({what, roundedText(*high) + " / " + roundedText(*low) + " m/s²", "", ""});
}

// Where there are several wheels: one alone has the features' smallest_contact_force.
void addForces(std::vector<PaperRow>& rows, const RunResult& result) {
  const auto wheels = analysis::wheelForces(result);
  if (wheels.size() < 2) return;
  for (const auto& one : wheels) {
    PaperRow row{"contact force of the " + one.wheel + ", minimum", roundedText(1e-3 * one.smallest, "kN"), "", ""};
    if (one.liftOff)
      row.ours += ", lifts off at " + roundedText(1e3 * *one.liftOff, "ms") + ", in the air for " +
                  roundedText(1e3 * one.aloft, "ms");
    rows.push_back(row);
  }
}

void addLines(std::vector<PaperRow>& rows, const RunResult& result) {
  constexpr std::size_t maximum = 6;
  const auto lines = statements::strongLines(result, {});
  std::string text;
  for (std::size_t i = 0; lines && i < std::min(maximum, lines->frequencies.size()); ++i)
    text += (text.empty() ? "" : ", ") + std::to_string(std::lround(lines->frequencies[i]));
  rows.push_back({"strongest lines of the PSD", text.empty() ? kNone : text + " Hz",
                  text.empty() ? "" : "resolution " + roundedText(std::round(lines->resolution), "Hz"), ""});
}

// What lines, wavelength and band powers refer to.
void addAnchor(std::vector<PaperRow>& rows, const RunResult& result) {
  try {
    const auto features = analysis::runFeatures(result);
    rows.push_back(
        {"features anchored at", roundedText(1e3 * features.impactTime, "ms"), signals::toText(features.anchor), ""});
  } catch (const signals::SignalError&) {  // too short: no features
  }
}

void addWavelength(std::vector<PaperRow>& rows, const RunResult& result) {
  statements::Statement wanted;
  wanted.measure = "wavelength";
  const auto length = statements::measure(result, wanted);
  rows.push_back({"mean wavelength after the impact", length ? roundedText(*length, "mm") : kNone, "", ""});
}

// As `squat validate` prints them.
void addStatements(std::vector<PaperRow>& rows, const std::vector<statements::Judged>& judged) {
  for (const auto& one : judged)
    rows.push_back({one.statement.name, valueText(one), rangeText(one.statement), toText(one.verdict)});
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
    rows.push_back({"contact force at equilibrium", roundedText(1e-3 * *force, "kN"),
                    weight ? "weight " + roundedText(1e-3 * *weight, "kN") : "", ""});
  }
  for (const auto& item : compared) {
    const auto ours = scalarNamed(result.equilibrium, item.name);
    if (!ours) continue;
    PaperRow row{item.what, roundedText(item.factor * *ours, item.unit), "", ""};
    if (const auto hertz = scalarNamed(result.equilibrium, item.hertz); hertz && *hertz > 0) {
      row.paper = "Hertz " + roundedText(item.factor * *hertz, item.unit);
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

void addResidualVibration(std::vector<PaperRow>& rows, const RunResult& result,
                          const statements::Reference& reference) {
  const auto seen = statements::residualVibration(result);
  if (!seen) return;
  char what[64];
  std::snprintf(what, sizeof what, "residual vibration before the defect (%.2f m)", seen->length);
  PaperRow row{what, roundedText(seen->largest, "m/s2"), "", ""};
  if (const auto limit = statements::residualVibrationLimit(reference)) {
    row.paper = "limit " + roundedText(*limit, "m/s2");
    row.verdict = passed(seen->largest <= *limit);
  }
  rows.push_back(row);
}

void addEnergy(std::vector<PaperRow>& rows, const RunResult& result) {
  if (const auto error = statements::energyError(result))
    rows.push_back({"energy balance error, maximum", roundedText(100 * *error, "%"),
                    "limit " + roundedText(100 * statements::energyErrorLimit, "%"),
                    passed(*error < statements::energyErrorLimit)});
}

// Only where the rail may yield.
void addPlasticity(std::vector<PaperRow>& rows, const RunResult& result) {
  if (const auto strain = scalarNamed(result.plasticity, "largest_equivalent_strain"))
    rows.push_back({"plastic strain, maximum", roundedText(100 * *strain, "%"), "", ""});
  if (const auto deepest = scalarNamed(result.plasticity, "deepest_change"))
    rows.push_back({"permanent surface deformation, maximum", roundedText(1e6 * *deepest, "um"), "", ""});
}

void addCost(std::vector<PaperRow>& rows, const RunResult& result) {
  const auto add = [&](const std::vector<results::Scalar>& list, const char* name, const char* what, double factor,
                       const char* unit) {
    if (const auto value = scalarNamed(list, name)) rows.push_back({what, roundedText(factor * *value, unit), "", ""});
  };
  add(result.meshFigures, "elements", "elements of the mesh", 1, "");
  add(result.performance, "steps", "time steps", 1, "");
  add(result.meshFigures, "stable_step", "stable time step", 1e6, "us");
  for (const auto& scalar : result.meshFigures)
    if (scalar.name == "stable_step")
      rows.back().paper = "set by: " + scalar.description.substr(0, scalar.description.find(';'));
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

namespace {

std::vector<PaperRow> rowsOf(const RunResult& result, const statements::Reference& reference,
                             const statements::RunJudgement& run, const std::vector<std::string>& setByHand) {
  std::vector<PaperRow> rows;
  if (run.nearest) addChangedKeys(rows, *run.nearest, setByHand);
  addPeak(rows, result, signals::names::axleBoxFiltered, "axle box acceleration, maximum / minimum");
  const auto addOther = [&](const char* channel, const char* what) {
    if (result.signal(channel)) addPeak(rows, result, channel, what);
  };
  addOther(signals::filteredNameOnRight(signals::names::axleBox), "right axle box, maximum / minimum");
  addOther(signals::names::secondAxleBoxFiltered, "axle box of the second wheelset, maximum / minimum");
  addOther(signals::filteredNameOnRight(signals::names::secondAxleBox),
           "right axle box of the second wheelset, maximum / minimum");
  addPeak(rows, result, signals::names::wheelFiltered, "wheel centre acceleration, maximum / minimum");
  addForces(rows, result);
  addAnchor(rows, result);
  addLines(rows, result);
  addWavelength(rows, result);
  addStatements(rows, run.judged);
  addContact(rows, result);
  addResidualVibration(rows, result, reference);
  addPlasticity(rows, result);
  addEnergy(rows, result);
  addCost(rows, result);
  return rows;
}

bool missesALine(const std::vector<statements::Judged>& judged) {
  return std::any_of(judged.begin(), judged.end(), [](const auto& one) {
    return one.statement.measure == "line" && one.verdict == statements::Verdict::notMet;
  });
}

}  // namespace

std::vector<PaperRow> paperRows(const RunResult& result, const std::vector<std::string>& setByHand) {
  const auto reference = statements::installedReference();
  return rowsOf(result, reference, statements::judgeRun(reference, result), setByHand);
}

std::string paperTable(const RunResult& result, const std::vector<std::string>& setByHand) {
  const auto reference = statements::installedReference();
  const auto run = statements::judgeRun(reference, result);
  TextTable table({result.stem, "this run", "paper or theory", ""});
  for (const auto& row : rowsOf(result, reference, run, setByHand))
    table.add({row.what, row.ours, row.paper, row.verdict});
  auto text = table.text(kTerminalWidth) + reasonsText(run.judged);
  if (missesALine(run.judged) && !result.modes.empty())
    text += "\nA spectral line of the paper is not met. Natural modes of the free half wheelset, for comparison:\n" +
            modesTable(result);
  return text;
}

std::string modesTable(const RunResult& result) {
  std::vector<model::HarmonicMode> modes;
  for (const auto& mode : result.modes)
    modes.push_back({mode.frequency, 0, mode.boxAmplitude, mode.wheelAmplitude, mode.contactAmplitude});
  return receptance::modesTable(modes);
}

std::string phasesTable(const RunResult& result) {
  const std::string prefix = "seconds_";
  TextTable table({"phase", "wall time [s]"});
  for (const auto& scalar : result.performance)
    if (scalar.name.rfind(prefix, 0) == 0) table.add({scalar.name.substr(prefix.size()), roundedText(scalar.value)});
  return table.empty() ? std::string() : table.text();
}

}  // namespace squat::commands
