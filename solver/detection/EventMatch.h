// solver/detection/EventMatch.h - how well the energies of an event agree with expected ones.
#pragma once

#include <Eigen/Core>

#include "detection/SizeModel.h"

namespace squat::detection {

// What is believed of the vehicle and track of a record: u of SizeModel.h.
struct Vehicle {
  BandValues mean = BandValues::Zero();
  BandMatrix covariance = BandMatrix::Zero();
};

struct EventMatch {
  BandValues distance = BandValues::Zero();    // log10 of the energies seen by those expected, noise included
  BandValues share = BandValues::Zero();       // of the signal in the expected energy; 0 where a band is not shown
  BandMatrix covariance = BandMatrix::Zero();  // of the distance
};

// `expected`: y of SizeModel.h without u; `scatter`: covariance of y around it. The noise of the event adds to the
// energy, with the scatter that its degrees of freedom bring: for a sum of a signal S and noise N of n degrees of
// freedom, (2 N^2 + 4 S N) / n.
EventMatch matchOf(const EventFeatures& event, const BandValues& expected, const Vehicle& vehicle,
                   const BandMatrix& scatter);

// Of the distance, but for a constant that all events of a record share.
double logDensityOf(const EventMatch& match);

}  // namespace squat::detection
