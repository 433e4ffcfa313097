// solver/model/WheelsetModes.h - natural modes of the free half wheelset, by harmonics around the axis.
//
// A wheelset swept in equal sectors couples no two harmonics cos(n alpha): each is a problem of the size of one
// section. Only the first harmonic (bending, translation) moves the axle box up and down; an axle box on a bearing
// spring is one unknown more there. Rail, suspension and rotation about the axle are left out, bearing damper and other
// damping as well.
#pragma once

#include <vector>

#include "geometry/SectionMesh.h"
#include "model/Centre.h"
#include "scenario/ScenarioDeclaration.h"

namespace squat::model {

struct HarmonicMode {
  double frequency = 0;  // [Hz]
  int harmonic = 1;
  double boxAmplitude = 0;      // vertical mass-normalised amplitude at the axle box [1/sqrt(kg)]
  double wheelAmplitude = 0;    // at the wheel centre
  double contactAmplitude = 0;  // at the tread, upwards
  double lateralAmplitude = 0;  // at the tread where it meets the rail, outwards
  Centre centre = Centre::symmetric;
  // Share of the wheelset's rotation with which a pair of such modes turns in the material, against the rotation
  // (Bryan 1890): 1 of a translation, whose direction stays in space; 0 of a tilt; 2 n / (n^2 + 1) of a thin ring.
  double stays = 0;
};

// Modes up to `highest` [Hz] of harmonics 0 to `lastHarmonic`, ascending; rigid motions are left out.
std::vector<HarmonicMode> wheelsetModes(const scenario::Scenario& scenario, double highest, int lastHarmonic,
                                        Centre centre = Centre::symmetric);

// Those of the whole wheelset: symmetric and antisymmetric ones, ascending; amplitudes are those of the left side,
// mass-normalised over one half.
std::vector<HarmonicMode> allWheelsetModes(const scenario::Scenario& scenario, double highest, int lastHarmonic);

// A mode with its shape, mass-normalised over the half wheelset: u_r and u_y ~ cos(n alpha), u_alpha ~ sin(n alpha) (n
// = 0: all constant); the other mode of the pair: u_r and u_y ~ sin(n alpha), u_alpha ~ -cos(n alpha).
struct ModeShape {
  HarmonicMode mode;
  std::vector<double> shape;  // per section node: alpha, r, y
  double box = 0;             // of an axle box on a bearing spring, upwards where alpha = 0 is the lowest point
};
struct WheelsetShapes {
  geometry::SectionMesh section;  // (r, y) of the whole half wheelset
  std::vector<double> mass;       // [kg] per section node, all around; without an axle box on a bearing spring
  std::vector<ModeShape> modes;   // ascending
};
WheelsetShapes wheelsetShapes(const scenario::Scenario& scenario, double highest, int lastHarmonic,
                              Centre centre = Centre::symmetric);

}  // namespace squat::model
