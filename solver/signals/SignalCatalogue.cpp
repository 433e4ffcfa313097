#include "signals/SignalCatalogue.h"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>

#include "signals/Butterworth.h"
#include "signals/Record.h"

namespace squat::signals {

namespace {

std::vector<CatalogueRow> rowsOfOneSide() {
  return {{.name = names::axleBox,
           .unit = "m/s2",
           .description = "vertical acceleration of the axle box, up positive, anti-aliased",
           .filteredName = names::axleBoxFiltered},
          {.name = names::axleBoxLongitudinal,
           .unit = "m/s2",
           .description = "longitudinal acceleration of the axle box, rolling direction positive"},
          {.name = names::axleBoxLateral,
           .unit = "m/s2",
           .description = "lateral acceleration of the axle box, outwards positive; of a whole model"},
          {.name = names::wheel,
           .unit = "m/s2",
           .description = "vertical acceleration of the wheel centre, up positive",
           .filteredName = names::wheelFiltered},
          {.name = names::contactForce,
           .unit = "N",
           .description = "vertical force of the wheel on the rail, down positive",
           .curve = {.figure = "contact_force",
                     .label = "vertical",
                     .front = true,
                     .tab = "Force",
                     .title = "Contact force",
                     .axis = "Force on the rail [kN]",
                     .factor = 1e-3,
                     .withZero = true}},  // so that a loss of contact shows
          {.name = names::creepForce,
           .unit = "N",
           .description = "longitudinal force of the wheel on the rail, rolling direction positive",
           .curve = {.figure = "contact_force", .label = "longitudinal", .factor = 1e-3}},
          {.name = names::wheelSpeed, .unit = "rad/s", .description = "angular velocity of the wheelset"},
          {.name = names::patchLength, .unit = "m", .description = "2 sqrt(5 <x2>) of the pressure"},
          {.name = names::patchWidth, .unit = "m", .description = "2 sqrt(5 <y2>) of the pressure"},
          {.name = names::rail,
           .unit = "m/s2",
           .description = "vertical acceleration of the rail foot at output.rail_accelerometer, up positive",
           .curve = {.figure = "trackside",
                     .label = "rail foot",
                     .tab = "Track",
                     .title = "Acceleration of rail and sleeper beside the track",
                     .axis = "Vertical acceleration [m/s\u00b2]"}},
          {.name = names::sleeper,
           .unit = "m/s2",
           .description =
               "vertical acceleration of the sleeper nearest to output.rail_accelerometer, below the rail, up positive",
           .curve = {.figure = "trackside", .label = "nearest sleeper", .front = true}},
          {.name = names::irregularity,
           .unit = "m",
           .description = "height of the rail's irregularity below the wheel centre, up positive"},
          {.name = names::secondAxleBox,
           .unit = "m/s2",
           .description = "vertical acceleration of the axle box of the bogie's second wheelset, up positive, "
                          "anti-aliased",
           .filteredName = names::secondAxleBoxFiltered},
          {.name = names::secondContactForce,
           .unit = "N",
           .description = "vertical force of the second wheelset's wheel on the rail, down positive",
           .curve = {.figure = "contact_force", .label = "second wheelset", .factor = 1e-3}}};
}

// Of the right side, each drawn in the figure of the left one.
class RightRows {
 public:
  std::vector<CatalogueRow> rows;

  RightRows() {
    for (const auto& left : rowsOfOneSide()) {
      CatalogueRow right = left;
      right.left = left.name;
      right.name = keep(std::string(left.name) + "_right");
      right.description = keep(std::string(left.description) + "; right side");
      if (left.filteredName) right.filteredName = keep(std::string(right.name) + "_filtered");
      if (left.curve.figure)
        right.curve = {.figure = left.curve.figure,
                       .label = keep(std::string(left.curve.label) + ", right"),
                       .factor = left.curve.factor};
      rows.push_back(right);
    }
  }

 private:
  const char* keep(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }
  std::deque<std::string> texts_;  // where they are, they stay
};

}  // namespace

const std::vector<CatalogueRow>& signalCatalogue() {
  static const RightRows right;
  static const std::vector<CatalogueRow> rows = [] {
    auto all = rowsOfOneSide();
    all.insert(all.end(), right.rows.begin(), right.rows.end());
    all.push_back({.name = names::wheelsetRoll,
                   .unit = "rad/s2",
                   .description = "roll of the wheelset, from both wheel centres, left side up positive; of a whole "
                                  "model"});
    all.push_back({.name = names::position,
                   .unit = "m",
                   .description = "wheel centre relative to the deepest point of the defect"});
    return all;
  }();
  return rows;
}

const char* filteredNameOnRight(std::string_view left) {
  for (const auto& row : signalCatalogue())
    if (row.left && row.left == left && row.filteredName) return row.filteredName;
  throw std::out_of_range("no filtered signal of the right side: " + std::string(left));
}

bool hasRightSide(const Record& record) {
  const auto& rows = signalCatalogue();
  return std::any_of(rows.begin(), rows.end(), [&](const CatalogueRow& row) {
    return row.left && (record.channel(row.name) || (row.filteredName && record.channel(row.filteredName)));
  });
}

bool carriesFilter(const TimeSeries& series, double cutoff) {
  constexpr std::size_t shortest = 31;   // samples: the filter continues the record over 27 at both ends
  constexpr double largestShare = 0.49;  // of the sampling rate
  return series.values.size() >= shortest && cutoff < largestShare * series.rate();
}

TimeSeries filteredPartner(const TimeSeries& series, double cutoff) {
  return carriesFilter(series, cutoff) ? lowPass(series, cutoff) : series;
}

}  // namespace squat::signals
