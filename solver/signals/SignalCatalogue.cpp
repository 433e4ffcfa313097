#include "signals/SignalCatalogue.h"

#include "signals/Butterworth.h"

namespace squat::signals {

const std::vector<CatalogueRow>& signalCatalogue() {
  static const std::vector<CatalogueRow> rows{
      {names::axleBox, "m/s2", "vertical acceleration of the axle box, up positive, anti-aliased",
       names::axleBoxFiltered},
      {names::axleBoxLongitudinal, "m/s2", "longitudinal acceleration of the axle box, rolling direction positive"},
      {names::wheel, "m/s2", "vertical acceleration of the wheel centre, up positive", names::wheelFiltered},
      {names::contactForce, "N", "vertical force of the wheel on the rail, down positive"},
      {names::creepForce, "N", "longitudinal force of the wheel on the rail, rolling direction positive"},
      {names::wheelSpeed, "rad/s", "angular velocity of the wheelset"},
      {names::patchLength, "m", "2 sqrt(5 <x2>) of the pressure"},
      {names::patchWidth, "m", "2 sqrt(5 <y2>) of the pressure"},
      {names::rail, "m/s2", "vertical acceleration of the rail foot at output.rail_accelerometer, up positive"},
      {names::sleeper, "m/s2",
       "vertical acceleration of the sleeper nearest to output.rail_accelerometer, below the rail, up positive"},
      {names::irregularity, "m", "height of the rail's irregularity below the wheel centre, up positive"},
      {names::position, "m", "wheel centre relative to the deepest point of the defect"}};
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
