// Losses of the frequency domain, which a rolling run does not use.
#include <cmath>

#include "case/CaseRelations.h"
#include "case/DynamicPads.h"
#include "case/Findings.h"
#include "scenario/ComplexStiffness.h"

namespace squat::cases::relations {

namespace {

constexpr const char* elsewhere = "used by receptance and decay rates only; a run uses dashpots";

// Of a loss factor: the dashpot that comes nearest, beside the one of the case.
void checkSupport(const CaseDescription& c, const std::string& group, const scenario::Support& support,
                  std::vector<Finding>& findings) {
  if (support.lossFactor == 0) return;
  const auto near = scenario::viscousEquivalent(
      [&](double) { return support.stiffness * std::complex<double>(1, support.lossFactor); },
      scenario::kEquivalentFrom, scenario::kEquivalentTo);
  add(findings, c, Severity::warning, {group + ".loss_factor", group + ".damping"}, elsewhere,
      "From 100 to 2000 Hz " + rounded(1e-3 * near.damping) + " kN s/m come nearest to it; the case has " + group +
          ".damping = " + rounded(1e-3 * support.damping) + " kN s/m");
}

// Of a measured table: its numbers, and what does not go with it.
void checkDynamicPads(const CaseDescription& c, std::vector<Finding>& findings) {
  const std::string values = "pad.dynamic_values";
  const auto table = parseDynamicStiffness(c.pad.dynamicValues);
  const auto wrong = table && !table->empty() ? dynamicStiffnessMistake(*table) : "it cannot be read";
  if (!wrong.empty()) {
    add(findings, c, Severity::problem, {values, "pad.dynamic"}, "rows of frequency and complex stiffness",
        wrong + ". Rows are like 200: 3863 608, 400: 4100 650 (Hz, then real and imaginary part in MN/m)");
    return;
  }
  if (!c.pad.curve.empty())
    add(findings, c, Severity::problem, {values, "pad.dynamic", "pad.curve"}, "given without pad.curve",
        "A measured dynamic stiffness belongs to one preload: leave out pad.curve or pad.dynamic");
  if (table->front().lateral != 0.0 && c.pad.lateralStiffness == 0)
    add(findings, c, Severity::problem, {"pad.lateral_stiffness", values},
        "above 0, since the table has lateral values",
        "Lateral and longitudinal springs are scaled by measured over stated lateral stiffness");
  const auto near = scenario::viscousEquivalent(
      [&](double f) { return scenario::tabulatedStiffness(*table, f, &scenario::DynamicStiffness::vertical); },
      scenario::kEquivalentFrom, scenario::kEquivalentTo);
  add(findings, c, Severity::warning, {values, "pad.stiffness", "pad.damping"}, elsewhere,
      "From 100 to 2000 Hz " + rounded(1e-6 * near.stiffness) + " MN/m and " + rounded(1e-3 * near.damping) +
          " kN s/m come nearest to it; the case has " + rounded(1e-6 * c.pad.stiffness) + " MN/m and " +
          rounded(1e-3 * c.pad.damping) + " kN s/m");
}

}  // namespace

void checkLosses(const CaseDescription& c, std::vector<Finding>& findings) {
  if (c.pad.dynamicValues.empty())
    checkSupport(c, "pad", c.pad, findings);
  else
    checkDynamicPads(c, findings);
  checkSupport(c, "ballast", c.ballast, findings);
  for (const auto& [key, lossFactor] :
       {std::pair{"rail.loss_factor", c.rail.lossFactor}, std::pair{"sleeper.loss_factor", c.sleeper.lossFactor}})
    if (lossFactor != 0)
      add(findings, c, Severity::warning, {key, "damping.fraction", "damping.beta"}, elsewhere,
          "A run damps its solids by damping.fraction or damping.beta");
}

}  // namespace squat::cases::relations
