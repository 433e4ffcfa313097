// Relations between the keys of an irregular rail and those of run and mesh.
#include <algorithm>
#include <cmath>
#include <utility>

#include "case/CaseRelations.h"
#include "case/Findings.h"
#include "case/LevelsText.h"
#include "case/Resolve.h"

namespace squat::cases::relations {

namespace {

constexpr double elementsInWave = 4;  // with two contact points each: eight points a wave

class IrregularityChecks {
 public:
  IrregularityChecks(const CaseDescription& description, std::vector<Finding>& findings)
      : case_(description), rail_(description.rail.irregularity), findings_(findings) {}

  void check() {
    if (rail_.kind == IrregularityKind::none) return;
    if (rail_.kind == IrregularityKind::heights)
      checkHeights();
    else
      checkSpectrum();
  }

 private:
  void add(Severity severity, Keys keys, std::string allowed, std::string advice) {
    relations::add(findings_, case_, severity, std::move(keys), std::move(allowed), std::move(advice));
  }

  double longestElement() const { return std::max(case_.mesh.contactSize, case_.mesh.rollingSize); }

  // True where there is a table that can be used.
  bool checkLevels() {
    const auto levels = parseLevels(rail_.levels);
    const char* example = "Write wavelengths in mm and levels in dB: 10: -8, 20: -6.2, 40: -3.2";
    if (!levels) {
      add(Severity::problem, {"rail.irregularity_levels"}, "pairs of wavelength and level", example);
    } else if (levels->empty()) {
      add(Severity::problem, {"rail.irregularity_levels", "rail.irregularity_file", "rail.irregularity"},
          "at least one level", "Give a CSV file as rail.irregularity_file, or write the levels into the case");
    } else if (const auto wrong = levelsMistake(*levels); !wrong.empty()) {
      add(Severity::problem, {"rail.irregularity_levels"}, "wavelengths ascending", "Correct the table: " + wrong);
    } else {
      return true;
    }
    return false;
  }

  void checkSpectrum() {
    if (rail_.kind == IrregularityKind::spectrum && !checkLevels()) return;
    const auto middles = scenario::thirdOctaveWavelengths(rail_.shortest, rail_.longest);
    if (middles.empty()) {
      add(Severity::problem, {"rail.irregularity_longest", "rail.irregularity_shortest"},
          "at least rail.irregularity_shortest = " + millimetres(rail_.shortest),
          "Choose limits with a third octave between them");
      return;
    }
    const auto levels = levelsOf(rail_);
    const auto has = [&](double middle) { return std::isfinite(scenario::levelAt(levels, middle)); };
    const auto missing = middles.size() - static_cast<std::size_t>(std::count_if(middles.begin(), middles.end(), has));
    const std::string range = millimetres(levels.front().wavelength) + " to " + millimetres(levels.back().wavelength);
    const bool above = rail_.longest > levels.back().wavelength;
    const std::string key = above ? "rail.irregularity_longest" : "rail.irregularity_shortest";
    if (missing == middles.size())
      add(Severity::problem, {key, "rail.irregularity_levels", "rail.irregularity_file"}, range,
          "The spectrum has no level there: choose wavelengths within it");
    else if (missing > 0)
      add(Severity::warning, {key, "rail.irregularity_levels", "rail.irregularity_file"}, range,
          "The spectrum ends there; third octaves beyond it are smooth");
    checkShortest(middles.front(), {"rail.irregularity_shortest", "mesh.rolling_size", "mesh.contact_size"});
  }

  void checkShortest(double wavelength, std::vector<std::string> keys) {
    const double size = longestElement();
    if (wavelength >= elementsInWave * size * (1 - 1e-9)) return;
    add(Severity::warning, std::move(keys), "at least " + millimetres(elementsInWave * size),
        "Elements of " + millimetres(size) + " are too coarse for the shortest waves, " + rounded(wavelength / size) +
            " elements a wave, where " + rounded(elementsInWave) +
            " are needed: refine mesh.rolling_size or leave shorter waves out");
  }

  void checkHeights() {
    const auto& points = rail_.points;
    if (points.size() < 2) {
      add(Severity::problem, {"rail.irregularity_points", "rail.irregularity_file", "rail.irregularity"},
          "at least two points", "Give a CSV file as rail.irregularity_file, or write the points into the case");
      return;
    }
    const double first = points.front().position - rail_.position, last = points.back().position - rail_.position;
    const double from = -case_.motion.runUp, to = case_.motion.beyond;
    const std::vector<std::string> keys{"rail.irregularity_position", "rail.irregularity_points",
                                        "rail.irregularity_file", "motion.run_up", "motion.beyond"};
    const std::string rolled = rounded(from) + " to " + rounded(to) + " m",
                      there = rounded(first) + " to " + rounded(last) + " m";
    if (last <= from || first >= to)
      add(Severity::problem, keys, "such that the heights lie where the wheel rolls, " + rolled,
          "They lie at " + there + ": set it to the position among the heights that lies at x = 0");
    else if (first > from || last < to)
      add(Severity::warning, keys, "such that the heights cover " + rolled,
          "They cover " + there + "; beyond, the rail is smooth");
    if (case_.bogie.hasSecond()) {
      const double behind = case_.bogie.offset() + from, ahead = case_.bogie.offset() + to;
      if (first > behind || last < ahead)
        add(Severity::warning, {"bogie.wheelbase", "rail.irregularity_points", "rail.irregularity_file"},
            "such that the heights cover " + rounded(behind) + " to " + rounded(ahead) + " m",
            "They cover " + there + "; beyond, the second wheelset rolls on a smooth rail");
    }
    const double steepest = irregularityOf(case_).steepest();
    constexpr double steepestPossible = 0.5;
    if (steepest > steepestPossible)
      add(Severity::problem, {"rail.irregularity_points", "rail.irregularity_file"}, "such that no slope is above 0.5",
          "The heights are too steep (slope " + rounded(steepest) + "): check their unit");
    // Between two contact points of an element, finer heights would be skipped.
    const double spacing = (points.back().position - points.front().position) / static_cast<double>(points.size() - 1);
    if (spacing < 0.25 * longestElement())
      add(Severity::warning, {"rail.irregularity_points", "mesh.rolling_size", "mesh.contact_size"},
          "at least " + millimetres(0.25 * longestElement()) + " apart",
          "Heights are " + millimetres(spacing) + " apart, the mesh sees them every " +
              millimetres(0.5 * longestElement()) + ": waves shorter than " +
              millimetres(elementsInWave * longestElement()) +
              " come out wrong; smooth the heights or refine the mesh");
  }

  const CaseDescription& case_;
  const Irregularity& rail_;
  std::vector<Finding>& findings_;
};

}  // namespace

void checkIrregularity(const CaseDescription& description, std::vector<Finding>& findings) {
  IrregularityChecks(description, findings).check();
}

}  // namespace squat::cases::relations
