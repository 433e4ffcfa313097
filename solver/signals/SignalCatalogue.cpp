#include "signals/SignalCatalogue.h"

#include "signals/Butterworth.h"

namespace squat::signals {

const std::vector<CatalogueRow>& signalCatalogue() {
  static const std::vector<CatalogueRow> rows{
      {.name = names::axleBox,
       .unit = "m/s2",
       .description = "vertical acceleration of the axle box, up positive, anti-aliased",
       .filteredName = names::axleBoxFiltered},
      {.name = names::axleBoxLongitudinal,
       .unit = "m/s2",
       .description = "longitudinal acceleration of the axle box, rolling direction positive"},
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
      {.name = names::position,
       .unit = "m",
       .description = "wheel centre relative to the deepest point of the defect"}};
  return rows;
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
