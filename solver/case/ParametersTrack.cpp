// Rows of the parameter table: track, rail, pad, sleeper, ballast.
#include "case/ParameterRows.h"

namespace squat::cases::rows {

using Case = CaseDescription;

namespace {

void addTrack(Rows& rows) {
  rows.push_back(inputPreset(
      "track.preset", [](Case& c) -> std::string& { return c.trackPreset; },
      "set of values for pads, sleepers and ballast; keys that the case states override it",
      "values with their sources: resources/presets/track"));
  rows.push_back(number(
      "track.length", metre, 10, {2, 60}, [](Case& c) -> double& { return c.track.length; },
      "length of the rail in the model; its middle lies near that of the run", section2));
  rows.push_back(number(
      "track.sleeper_spacing", metre, 0.6, {0.4, 1}, [](Case& c) -> double& { return c.track.sleeperSpacing; },
      "distance between sleepers", table1));
  rows.push_back(number(
      "track.defect_from_sleeper", metre, 0, {-0.5, 0.5}, [](Case& c) -> double& { return c.track.defectFromSleeper; },
      "distance from the nearest sleeper centre to the deepest point of the defect, in rolling direction (the paper's "
      "L)",
      "assumed: over a sleeper; the paper gives no value"));
  rows.push_back(choice(
      "track.rail_ends", {"free", "clamped", "absorbing"}, RailEnds::free,
      +[](Case& c) -> RailEnds& { return c.track.railEnds; }, "boundary condition of both ends of the rail",
      "assumed: the paper does not say"));
  rows.push_back(seats(
      "track.seats", [](Case& c) -> std::vector<Seat>& { return c.track.seats; },
      "rail seats that differ, each a table [[track.seats]]: sleeper (0 the one nearest to the defect, positive in "
      "rolling direction), and any of pad_stiffness [MN/m], pad_damping [kN s/m] (vertical, a linear pad), "
      "ballast_stiffness, ballast_damping (vertical, per half sleeper), gap [mm] (void under the sleeper: the ballast "
      "carries once the gap has closed, and never pulls)",
      "assumed: all seats are alike"));
}

void addRail(Rows& rows) {
  rows.push_back(choice(
      "rail.section", {"54E1", "60E1"}, RailSection::rail54E1, +[](Case& c) -> RailSection& { return c.rail.section; },
      "section of the rail after EN 13674-1: 54E1 (UIC 54) or 60E1 (UIC 60)",
      "assumed: the usual rail of Dutch lines, where the paper measured"));
  rows.push_back(number(
      "rail.young_modulus", gigapascal, 210, {10, 2000}, [](Case& c) -> double& { return c.rail.material.young; },
      "Young's modulus of the rail", table1));
  rows.push_back(number(
      "rail.poisson_ratio", none, 0.3, {0, 0.45}, [](Case& c) -> double& { return c.rail.material.poisson; },
      "Poisson's ratio of the rail", table1));
  rows.push_back(number(
      "rail.density", density, 7800, {1000, 20000}, [](Case& c) -> double& { return c.rail.material.density; },
      "mass density of the rail", table1));
  rows.push_back(number(
      "rail.inclination", none, 0, {0, 0.1}, [](Case& c) -> double& { return c.rail.inclination; },
      "inclination of the rail towards the track centre",
      "assumed: upright, which changes little but the lateral load if wheelset.cone is the same; paper, section 2: "
      "0.025"));
  rows.push_back(number(
      "rail.loss_factor", none, 0, {0, 1}, [](Case& c) -> double& { return c.rail.lossFactor; },
      "loss factor of the rail's steel in the frequency domain (receptance, decay rates): stiffness times 1 + i times "
      "it; a rolling run does not know it",
      "assumed: none; literature: 0.01 to 0.02 stands for all that a rail on its track loses besides the pads"));
}

Parameter ofPlasticRail(Parameter row) { return appliesIf("rail.plastic", {"true"}, std::move(row)); }
Parameter ofChaboche(Parameter row) { return ofPlasticRail(appliesIf("rail.hardening", {"chaboche"}, std::move(row))); }

constexpr const char* fitted =
    "R260, fitted: yields first at 336 MPa in torsion and tension (Meyer and others, Eur. J. Mech. A 2020), 0.2 % "
    "limit 490 MPa, 690 MPa at 2 %; no set published for this law could be read";

template <int I>
void addBackstress(Rows& rows, const char* modulus, double gigapascals, const char* recovery, double perStrain) {
  rows.push_back(ofChaboche(number(
      modulus, gigapascal, gigapascals, {0, 2000}, +[](Case& c) -> double& { return c.rail.backstresses[I].modulus; },
      I == 0   ? "plastic modulus at which the first back-stress starts to grow"
      : I == 1 ? "plastic modulus of the second back-stress"
               : "plastic modulus of the third back-stress",
      fitted)));
  rows.push_back(ofChaboche(number(
      recovery, none, perStrain, {0, 100000}, +[](Case& c) -> double& { return c.rail.backstresses[I].recovery; },
      I == 0   ? "rate at which the first back-stress recovers, per plastic strain; it grows to modulus over rate"
      : I == 1 ? "rate at which the second back-stress recovers"
               : "rate at which the third back-stress recovers; 0: it grows without limit, and ratchetting ends",
      fitted)));
}

void addPlasticity(Rows& rows) {
  rows.push_back(inputPreset(
      "rail.preset", [](Case& c) -> std::string& { return c.railPreset; },
      "set of values for the steel of the rail, which yields; keys that the case states override it",
      "values with their sources: resources/presets/rail"));
  rows.push_back(boolean(
      "rail.plastic", false, [](Case& c) -> bool& { return c.rail.plastic; },
      "elastoplastic surface layer of the rail head; false: elastic",
      "assumed: elastic, which holds at rest but not where the contact slips under full traction or at a defect; "
      "paper, "
      "section 2: elastoplastic"));
  rows.push_back(ofPlasticRail(number(
      "rail.yield_stress", gigapascal, 0.8, {0.05, 10}, [](Case& c) -> double& { return c.rail.yieldStress; },
      "yield stress of the surface layer", table1)));
  rows.push_back(ofPlasticRail(number(
      "rail.plastic_depth", millimetre, 5, {0.5, 20}, [](Case& c) -> double& { return c.rail.plasticDepth; },
      "depth of the elastoplastic surface layer", "assumed: the paper does not say")));
  rows.push_back(ofPlasticRail(choice(
      "rail.hardening", {"isotropic", "kinematic", "chaboche"}, Hardening::isotropic,
      +[](Case& c) -> Hardening& { return c.rail.hardening; },
      "hardening of the surface layer: linear isotropic, linear kinematic, or three back-stresses that recover, which "
      "ratchets",
      "assumed: the paper does not say")));
  rows.push_back(ofPlasticRail(appliesUnless(
      "rail.hardening", {"chaboche"},
      number(
          "rail.tangent_modulus", gigapascal, 21, {0, 2000}, [](Case& c) -> double& { return c.rail.tangentModulus; },
          "tangent modulus of the surface layer beyond yield, below Young's modulus", table1))));
  addBackstress<0>(rows, "rail.backstress_modulus_1", 191, "rail.backstress_recovery_1", 1500);
  addBackstress<1>(rows, "rail.backstress_modulus_2", 8.2, "rail.backstress_recovery_2", 150);
  addBackstress<2>(rows, "rail.backstress_modulus_3", 9.9, "rail.backstress_recovery_3", 12);
  rows.push_back(ofChaboche(number(
      "rail.recovery_exponent", none, 5, {0, 100}, [](Case& c) -> double& { return c.rail.recoveryExponent; },
      "exponent of the recovery (Ohno and Wang): the larger, the less the steel ratchets; 0: Armstrong and Frederick",
      "assumed: 5 to 10 are usual (unverified)")));
  rows.push_back(ofChaboche(number(
      "rail.isotropic_saturation", gigapascal, 0, {-5, 5},
      [](Case& c) -> double& { return c.rail.isotropicSaturation; },
      "growth of the yield stress after much plastic strain; negative: the steel softens", fitted)));
  rows.push_back(ofChaboche(number(
      "rail.isotropic_rate", none, 10, {0, 10000}, [](Case& c) -> double& { return c.rail.isotropicRate; },
      "rate of that growth, per plastic strain", "assumed")));
}

Parameter ofSpectrum(Parameter row) { return appliesIf("rail.irregularity", {"iso-3095", "spectrum"}, std::move(row)); }

void addIrregularity(Rows& rows) {
  rows.push_back(choice(
      "rail.irregularity", {"none", "iso-3095", "spectrum", "heights"}, IrregularityKind::none,
      +[](Case& c) -> IrregularityKind& { return c.rail.irregularity.kind; },
      "unevenness of the rail along the whole rolled length, beside the defect: none, random with the levels of ISO "
      "3095:2013 or of a spectrum, or given heights; it fades in behind the start",
      "assumed: smooth, as in the paper"));
  rows.push_back(
      appliesIf("rail.irregularity", {"spectrum", "heights"},
                text(
                    "rail.irregularity_file", [](Case& c) -> std::string& { return c.rail.irregularity.file; },
                    "CSV file of the spectrum (wavelength and level of third octaves, dB re 1 \u00B5m) or "
                    "of the heights (position and height); relative to the case file; not read if the case "
                    "contains rail.irregularity_levels or rail.irregularity_points",
                    "assumed")));
  rows.push_back(
      appliesIf("rail.irregularity", {"spectrum"},
                text(
                    "rail.irregularity_levels", [](Case& c) -> std::string& { return c.rail.irregularity.levels; },
                    "wavelengths in mm and levels of third octaves in dB re 1 \u00B5m: "
                    "10: -8, 20: -6.2, 40: -3.2; straight over the logarithm of the wavelength in between",
                    "assumed")));
  rows.push_back(appliesIf(
      "rail.irregularity", {"heights"},
      points(
          "rail.irregularity_points", [](Case& c) -> std::vector<ProfilePoint>& { return c.rail.irregularity.points; },
          "pairs of position and height of the rail, up positive", "assumed")));
  rows.push_back(appliesIf("rail.irregularity", {"heights"},
                           number(
                               "rail.irregularity_position", metre, 0, {-1e6, 1e6},
                               [](Case& c) -> double& { return c.rail.irregularity.position; },
                               "position among the heights that lies at the deepest point of the defect", "assumed")));
  rows.push_back(ofSpectrum(wholeNumber(
      "rail.irregularity_seed", 1, {0, 1e9}, [](Case& c) -> double& { return c.rail.irregularity.seed; },
      "of the random phases: another seed gives another rail with the same levels", "any")));
  rows.push_back(ofSpectrum(number(
      "rail.irregularity_shortest", millimetre, 10, {2, 3000},
      [](Case& c) -> double& { return c.rail.irregularity.shortest; },
      "middle of the third octave with the shortest waves",
      "assumed: patches of some 12 mm hardly feel shorter waves")));
  rows.push_back(ofSpectrum(number(
      "rail.irregularity_longest", millimetre, 400, {2, 3000},
      [](Case& c) -> double& { return c.rail.irregularity.longest; },
      "middle of the third octave with the longest waves", "ISO 3095:2013: its limit ends there")));
  rows.push_back(appliesUnless("rail.irregularity", {"none"},
                               number(
                                   "rail.irregularity_offset", decibel, 0, {-60, 40},
                                   [](Case& c) -> double& { return c.rail.irregularity.offset; },
                                   "added to all levels; 20 dB make heights ten times as large", "0: as given")));
}

void addPad(Rows& rows) {
  rows.push_back(number(
      "pad.stiffness", stiffness, 1300, {1, 20000}, [](Case& c) -> double& { return c.pad.stiffness; },
      "vertical stiffness of a rail pad, per rail seat (K2)", table1));
  rows.push_back(number(
      "pad.damping", damping, 45, {0, 2000}, [](Case& c) -> double& { return c.pad.damping; },
      "vertical damping of a rail pad, per rail seat (C2)", table1));
  rows.push_back(forceCurve(
      "pad.curve", [](Case& c) -> std::vector<ForcePoint>& { return c.pad.curve; },
      "vertical force of a whole rail pad against its compression, rising, straight between the points and beyond; "
      "replaces pad.stiffness; [] for a linear pad",
      "assumed: linear"));
  rows.push_back(number(
      "pad.preload", kilonewton, 0, {0, 100}, [](Case& c) -> double& { return c.pad.preload; },
      "clamping force of the fastening: the point of pad.curve at which the unloaded track stands and at which the "
      "receptance takes the tangent",
      "assumed: none; it has no effect without pad.curve"));
  rows.push_back(number(
      "pad.longitudinal_stiffness", stiffness, 130, {0, 20000},
      [](Case& c) -> double& { return c.pad.longitudinalStiffness; },
      "stiffness of a rail pad along the rail, per rail seat", "assumed: one tenth of the vertical"));
  rows.push_back(number(
      "pad.longitudinal_damping", damping, 4.5, {0, 2000}, [](Case& c) -> double& { return c.pad.longitudinalDamping; },
      "damping of a rail pad along the rail, per rail seat", "assumed: one tenth of the vertical"));
  rows.push_back(number(
      "pad.lateral_stiffness", stiffness, 130, {0, 20000}, [](Case& c) -> double& { return c.pad.lateralStiffness; },
      "stiffness of a rail pad across the rail, per rail seat", "assumed: one tenth of the vertical"));
  rows.push_back(number(
      "pad.lateral_damping", damping, 4.5, {0, 2000}, [](Case& c) -> double& { return c.pad.lateralDamping; },
      "damping of a rail pad across the rail, per rail seat", "assumed: one tenth of the vertical"));
  rows.push_back(number(
      "pad.loss_factor", none, 0, {0, 2}, [](Case& c) -> double& { return c.pad.lossFactor; },
      "loss factor of a rail pad in the frequency domain (receptance, decay rates), in all directions: stiffness times "
      "1 + i times it, without dashpots; a rolling run has the dashpots and does not know it; 0: dashpots everywhere",
      "assumed: dashpots; literature: 0.1 to 0.25"));
  rows.push_back(text(
      "pad.dynamic", [](Case& c) -> std::string& { return c.pad.dynamicFile; },
      "table of the complex stiffness of a whole pad against the frequency (real and imaginary part, vertical and, if "
      "it has that, lateral), used in place of stiffness, damping and loss factor by receptance and decay rates only; "
      "relative to the case file; not read if the case contains pad.dynamic_values",
      "assumed: none"));
  rows.push_back(text(
      "pad.dynamic_values", [](Case& c) -> std::string& { return c.pad.dynamicValues; },
      "numbers of pad.dynamic: frequency in Hz, real and imaginary part of the vertical and, if measured, of the "
      "lateral stiffness in MN/m: 200: 3863 608 155 24, 400: 4100 650 164 26",
      "assumed: none"));
  rows.push_back(number(
      "pad.length", metre, 0.16, {0.02, 0.4}, [](Case& c) -> double& { return c.pad.length; },
      "length of the pad along the rail", "literature: 0.14 to 0.18 m"));
  rows.push_back(number(
      "pad.width", metre, 0.14, {0.02, 0.15}, [](Case& c) -> double& { return c.pad.width; },
      "width of the pad across the rail, at most that of the rail's foot", "literature: width of the foot"));
}

void addSleeper(Rows& rows) {
  rows.push_back(number(
      "sleeper.young_modulus", gigapascal, 38.4, {1, 2000}, [](Case& c) -> double& { return c.sleeper.material.young; },
      "Young's modulus of the sleeper",
      "literature: concrete sleepers in models of this line; the paper does not say"));
  rows.push_back(number(
      "sleeper.poisson_ratio", none, 0.2, {0, 0.45}, [](Case& c) -> double& { return c.sleeper.material.poisson; },
      "Poisson's ratio of the sleeper", "literature: concrete"));
  rows.push_back(number(
      "sleeper.density", density, 2450, {200, 20000}, [](Case& c) -> double& { return c.sleeper.material.density; },
      "mass density of the sleeper; times its volume it gives the mass",
      "paper, Table 1: 244 kg a sleeper, 122 kg in the half track"));
  rows.push_back(number(
      "sleeper.loss_factor", none, 0, {0, 1}, [](Case& c) -> double& { return c.sleeper.lossFactor; },
      "loss factor of the sleeper in the frequency domain (receptance, decay rates); a rolling run does not know it",
      "assumed: none; literature: concrete 0.01 to 0.03"));
  rows.push_back(boolean(
      "sleeper.fixed", false, [](Case& c) -> bool& { return c.sleeper.fixed; },
      "sleepers that do not move: the pads stand on the ground, and sleeper and ballast have no effect",
      "assumed: sleepers on ballast"));
  rows.push_back(number(
      "sleeper.half_length", metre, 1.26, {0.9, 1.5}, [](Case& c) -> double& { return c.sleeper.halfLength; },
      "from the track centre to the end of the sleeper", "assumed: concrete sleeper of 2.52 m"));
  rows.push_back(number(
      "sleeper.width", metre, 0.26, {0.1, 0.4}, [](Case& c) -> double& { return c.sleeper.width; },
      "width of the sleeper, along the rail", "assumed: block with the paper's mass"));
  rows.push_back(number(
      "sleeper.height", metre, 0.152, {0.08, 0.35}, [](Case& c) -> double& { return c.sleeper.height; },
      "height of the sleeper, under the rail", "assumed: block with the paper's mass"));
  rows.push_back(number(
      "sleeper.middle_height", metre, 0, {0, 0.35}, [](Case& c) -> double& { return c.sleeper.middleHeight; },
      "height of the sleeper in the middle of the track, on the same flat base: its top rises in a straight line to "
      "the inner edge of the rail pad; 0: as under the rail",
      "assumed: a uniform block; concrete sleepers of one piece have about 0.8 of the height under the rail "
      "(unverified: B70 0.175 m and 0.214 m)"));
  rows.push_back(appliesUnless("sleeper.middle_height", {"0"},
                               number(
                                   "sleeper.middle_half_length", metre, 0.3, {0, 1},
                                   [](Case& c) -> double& { return c.sleeper.middleHalfLength; },
                                   "from the track centre to where the height of the middle ends",
                                   "assumed: no drawing at hand; the rise ends at the pad in any case")));
}

void addBallast(Rows& rows) {
  rows.push_back(number(
      "ballast.stiffness", stiffness, 45, {1, 10000}, [](Case& c) -> double& { return c.ballast.stiffness; },
      "vertical stiffness of the ballast, per half sleeper (K3)", table1));
  rows.push_back(number(
      "ballast.damping", damping, 32, {0, 2000}, [](Case& c) -> double& { return c.ballast.damping; },
      "vertical damping of the ballast, per half sleeper (C3)", table1));
  rows.push_back(number(
      "ballast.longitudinal_stiffness", stiffness, 20, {0.1, 10000},
      [](Case& c) -> double& { return c.ballast.longitudinalStiffness; },
      "stiffness of the ballast along the rail, per half sleeper", "assumed: about half the vertical"));
  rows.push_back(number(
      "ballast.longitudinal_damping", damping, 14, {0, 2000},
      [](Case& c) -> double& { return c.ballast.longitudinalDamping; },
      "damping of the ballast along the rail, per half sleeper", "assumed: in proportion to the stiffness"));
  rows.push_back(number(
      "ballast.lateral_stiffness", stiffness, 20, {0.1, 10000},
      [](Case& c) -> double& { return c.ballast.lateralStiffness; },
      "stiffness of the ballast across the rail, per half sleeper", "assumed: about half the vertical"));
  rows.push_back(number(
      "ballast.lateral_damping", damping, 14, {0, 2000}, [](Case& c) -> double& { return c.ballast.lateralDamping; },
      "damping of the ballast across the rail, per half sleeper", "assumed: in proportion to the stiffness"));
  rows.push_back(number(
      "ballast.loss_factor", none, 0, {0, 5}, [](Case& c) -> double& { return c.ballast.lossFactor; },
      "loss factor of the ballast in the frequency domain (receptance, decay rates), in all directions, without "
      "dashpots; a rolling run has the dashpots and does not know it; 0: dashpots everywhere",
      "assumed: dashpots; literature: 0.6 to 2"));
}

}  // namespace

Rows trackRows() {
  Rows rows;
  addTrack(rows);
  addRail(rows);
  addPlasticity(rows);
  addIrregularity(rows);
  addPad(rows);
  addSleeper(rows);
  addBallast(rows);
  return rows;
}

}  // namespace squat::cases::rows
