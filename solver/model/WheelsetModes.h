// solver/model/WheelsetModes.h - natural modes of the free half wheelset, by harmonics around the axis.
//
// A wheelset swept in equal sectors couples no two harmonics cos(n alpha): each is a problem of the size of one
// section. Only the first harmonic (bending, translation) moves the axle box up and down. Rail, suspension and spin are
// left out.
#pragma once

#include <vector>

#include "case/CaseDescription.h"

namespace squat::model {

struct HarmonicMode {
  double frequency = 0;  // [Hz]
  int harmonic = 1;
  double boxShare = 0;      // vertical mass-normalised amplitude at the axle box [1/sqrt(kg)]
  double wheelShare = 0;    // at the wheel centre
  double contactShare = 0;  // at the tread, downwards
};

// Modes up to `highest` [Hz] of harmonics 0 to `lastHarmonic`, ascending; rigid motions are left out.
std::vector<HarmonicMode> wheelsetModes(const cases::CaseDescription& description, double highest, int lastHarmonic);

}  // namespace squat::model
