#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "calibration/Calibration.h"
#include "calibration/Derivatives.h"
#include "calibration/EvaluationTable.h"
#include "calibration/Knowledge.h"
#include "calibration/LocalSearch.h"
#include "calibration/PointRunner.h"
#include "calibration/SpaceFilling.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"

namespace squat::calibration {

namespace {

// How many points each stage takes, from the number of all.
struct Budget {
  std::size_t global = 0, starts = 2, derivatives = 0, spread = 0, confirm = 4;
  int local = 0;  // for each start

  std::size_t total() const {
    return 1 + global + starts * static_cast<std::size_t>(local) + derivatives + spread + confirm;
  }
};

Budget budgetFor(const CalibrationDefinition& definition) {
  const std::size_t n = definition.inputs.size();
  const double all = definition.evaluations > 0 ? definition.evaluations : 20 + 40 * static_cast<double>(n);
  Budget budget;
  budget.derivatives = 2 * (2 * n + 3);
  budget.spread = 4 * n;
  const double rest = std::max(8.0, all - static_cast<double>(budget.derivatives + budget.spread));
  budget.global = static_cast<std::size_t>(0.5 * rest);
  budget.local = static_cast<int>(0.5 * rest / static_cast<double>(budget.starts));
  return budget;
}

bool isBetter(const Evaluation& a, const Evaluation& b) { return !a.hasFailed && (b.hasFailed || a.misfit < b.misfit); }

constexpr int kRounds = 3;  // of steps by derivatives

class Search {
 public:
  Search(Calibration& calibration, EvaluationTable& table, const MeasuredData& data, const CalibrationOptions& options,
         Monitor& monitor)
      : calibration_(calibration),
        definition_(calibration.definition),
        table_(table),
        budget_(budgetFor(definition_)),
        part_(options.part),
        runner_(table, definition_, data, options, part_ ? sharePoints().size() : budget_.total(), monitor) {}

  void computeShare() {
    runner_.all(Stage::global, mesh(), valuesOf(sharePoints()));
    runner_.rethrow();
    calibration_.evaluations = table_.rows();
    calibration_.complete = !runner_.isCancelled();
  }

  void run() {
    const bool isComplete = searchGlobally() && searchLocally() && refine() && explore() && confirm();
    runner_.rethrow();
    calibration_.complete = isComplete && !runner_.isCancelled();
  }

  // From the rows of the table, whether the search has ended or not.
  void conclude() {
    calibration_.evaluations = table_.rows();
    const auto best = [&](const std::string& mesh) {
      std::optional<std::size_t> found;
      const auto& rows = calibration_.evaluations;
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].mesh == mesh && !rows[i].hasFailed && (!found || isBetter(rows[i], rows[*found]))) found = i;
      return found;
    };
    const auto ofSearch = best(mesh());
    if (!ofSearch) return;
    calibration_.bestOfSearch = *ofSearch;
    const auto confirmed = best(definition_.confirmMesh);
    calibration_.best = confirmed.value_or(*ofSearch);
    if (!confirmed && calibration_.complete)
      calibration_.definition.targets.notes.push_back("no point could be run on mesh " + definition_.confirmMesh +
                                                      ": the values are those of mesh " + mesh());
    const auto& row = calibration_.evaluations[*ofSearch];
    summarise(calibration_, EquallyGood(definition_.targets, row, definition_.inputs.size()), model_, byModel_);
  }

 private:
  const std::string& mesh() const { return definition_.searchMesh; }

  std::vector<Values> valuesOf(const std::vector<UnitPoint>& points) const {
    std::vector<Values> all;
    for (const auto& point : points) all.push_back(valuesAt(definition_.inputs, point));
    return all;
  }

  // The case's own values, moved to the limits where they lie outside.
  UnitPoint ownPoint() const {
    const auto description = cases::loadCase(definition_.caseName, definition_.overrides);
    Values own;
    for (const auto& input : definition_.inputs) own.push_back(input.valueIn(description));
    auto start = pointOf(definition_.inputs, own);
    for (double& coordinate : start) coordinate = std::clamp(coordinate, 0.0, 1.0);
    return start;
  }

  std::vector<UnitPoint> fillingPoints() const {
    std::vector<UnitPoint> points;
    for (std::size_t i = 0; i < budget_.global; ++i) points.push_back(spaceFillingPoint(i, definition_.inputs.size()));
    return points;
  }

  // The part's share of the points that depend on no other.
  std::vector<UnitPoint> sharePoints() const {
    auto all = fillingPoints();
    all.insert(all.begin(), ownPoint());
    std::vector<UnitPoint> own;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (studies::partOf(*part_, i, std::to_string(i)) == part_->part) own.push_back(all[i]);
    return own;
  }

  bool searchGlobally() {
    if (!runner_.at(Stage::start, mesh(), valuesAt(definition_.inputs, ownPoint()))) return false;
    runner_.all(Stage::global, mesh(), valuesOf(fillingPoints()));
    if (runner_.isCancelled()) return false;
    requireOne();
    return true;
  }

  void requireOne() const {
    for (const auto& row : table_.rows())
      if (!row.hasFailed) return;
    throw CaseError({{"--free", "a set of limits in which no point can be run", "limits within which the case is valid",
                      "The first point says: " + table_.rows().front().message}});
  }

  // The best points of the search so far that lie apart from each other.
  std::vector<UnitPoint> starts() const {
    constexpr double apart = 0.25;
    std::vector<const Evaluation*> rows;
    for (const auto& row : runner_.seen())
      if (row.mesh == mesh() && !row.hasFailed && (row.stage == Stage::start || row.stage == Stage::global))
        rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) {
      return a->misfit < b->misfit || (a->misfit == b->misfit && a->values < b->values);
    });
    std::vector<UnitPoint> chosen;
    for (const auto* row : rows) {
      const auto point = pointOf(definition_.inputs, row->values);
      const bool isNew = std::none_of(chosen.begin(), chosen.end(), [&](const UnitPoint& other) {
        double largest = 0;
        for (std::size_t i = 0; i < point.size(); ++i) largest = std::max(largest, std::abs(point[i] - other[i]));
        return largest < apart;
      });
      if (isNew) chosen.push_back(point);
      if (chosen.size() == budget_.starts) break;
    }
    return chosen;
  }

  bool searchLocally() {
    // Above all misfits so far, so that a case that cannot be run is left again.
    double failed = 100;
    for (const auto& row : runner_.seen())
      if (!row.hasFailed) failed = std::max(failed, 2 * row.misfit);
    const Misfit misfit = [&](const UnitPoint& point) -> std::optional<double> {
      const auto evaluation = runner_.at(Stage::local, mesh(), valuesAt(definition_.inputs, point));
      if (!evaluation) return std::nullopt;
      return evaluation->hasFailed ? failed : std::min(failed, evaluation->misfit);
    };
    LocalSearchOptions options;
    options.evaluations = budget_.local;
    std::vector<std::jthread> searches;
    for (const auto& start : starts()) {
      searches.emplace_back([&misfit, &options, start] { searchFrom(start, misfit, options); });
      if (static_cast<int>(searches.size()) >= runner_.jobs()) searches.clear();  // joins
    }
    searches.clear();
    return !runner_.isCancelled();
  }

  Evaluation bestRow() const {
    const Evaluation* best = nullptr;
    for (const auto& row : runner_.seen())
      if (row.mesh == mesh() && (!best || isBetter(row, *best))) best = &row;
    return *best;
  }

  static bool isApart(const UnitPoint& a, const UnitPoint& b) {
    constexpr double minimum = 0.004;  // nearer points are one: a tenth of the step of the derivatives
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::abs(a[i] - b[i]) > minimum) return true;
    return false;
  }

  // Derivatives about the best point and the steps that they call for, until these lead to no better one.
  bool refine() {
    constexpr double step = 0.04;
    for (int round = 0;; ++round) {
      const auto best = bestRow();
      const auto centre = pointOf(definition_.inputs, best.values);
      const auto about = runner_.all(Stage::derivatives, mesh(), valuesOf(pointsAbout(centre, step)));
      if (runner_.isCancelled()) return false;
      model_ = linearModel(definition_.inputs, best, about);
      if (bestRow().values != best.values && round < kRounds) continue;  // one of them is better already
      std::vector<UnitPoint> next;
      for (const double damping : {0.0, 0.01, 0.1}) {
        auto point = newtonPoint(model_, definition_.targets.weights(), damping);
        if (isApart(point, centre)) next.push_back(std::move(point));
      }
      if (round < kRounds) runner_.all(Stage::derivatives, mesh(), valuesOf(next));
      if (runner_.isCancelled()) return false;
      if (bestRow().values == best.values || round >= 3 * kRounds) return true;
    }
  }

  // Points that should be as good as the best one, as different from it as they can be.
  bool explore() {
    constexpr std::size_t walk = 400;
    const auto best = bestRow();
    const EquallyGood isEquallyGood(definition_.targets, best, definition_.inputs.size());
    byModel_ = equallyGoodByModel(isEquallyGood, model_, walk);
    runner_.all(Stage::spread, mesh(), valuesOf(spreadOut(byModel_, budget_.spread)));
    return !runner_.isCancelled();
  }

  bool confirm() {
    if (definition_.confirmMesh == mesh()) return true;
    const EquallyGood isEquallyGood(definition_.targets, bestRow(), definition_.inputs.size());
    std::vector<UnitPoint> good{pointOf(definition_.inputs, bestRow().values)};
    for (const auto& row : table_.rows())
      if (row.mesh == mesh() && isEquallyGood(row)) good.push_back(pointOf(definition_.inputs, row.values));
    const auto chosen = spreadOut(good, budget_.confirm);  // the first is the best
    runner_.all(Stage::confirm, definition_.confirmMesh, valuesOf(chosen));
    return !runner_.isCancelled();
  }

  Calibration& calibration_;
  const CalibrationDefinition& definition_;
  EvaluationTable& table_;
  Budget budget_;
  std::optional<studies::Partition> part_;
  PointRunner runner_;
  LinearModel model_;
  std::vector<UnitPoint> byModel_;
};

}  // namespace

Calibration calibrate(const CalibrationDefinition& definition, const CalibrationOptions& options, Monitor& monitor) {
  Calibration calibration;
  calibration.definition = definition;
  calibration.definition.caseHash = cases::caseHash(cases::loadCase(definition.caseName, definition.overrides));
  EvaluationTable table(calibration.definition,
                        options.part ? partFolder(options.folder, *options.part) : options.folder);
  if (!options.part) table.takeParts();
  const auto data = readMeasuredData(calibration.definition.targets);
  for (const auto& signal : data.signals)
    for (const auto& note : signal.notes) monitor.message(note);
  Search search(calibration, table, data, options, monitor);
  if (options.part) {
    search.computeShare();
    return calibration;
  }
  search.run();
  search.conclude();
  return calibration;
}

}  // namespace squat::calibration
