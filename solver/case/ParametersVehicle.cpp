// Rows of the parameter table: wheelset, suspension, bogie.
#include "case/ParameterRows.h"

namespace squat::cases::rows {

using Case = CaseDescription;

namespace {

constexpr const char* steps = "assumed: common passenger wheelset; no drawing of the paper's wheelset is public";

void addWheel(Rows& rows) {
  rows.push_back(inputPreset(
      "wheelset.preset", [](Case& c) -> std::string& { return c.wheelsetPreset; },
      "set of values for wheelset and suspension; keys that the case states override it",
      "values with their sources: resources/presets/wheelset"));
  rows.push_back(number(
      "wheelset.young_modulus", gigapascal, 210, {10, 2000},
      [](Case& c) -> double& { return c.wheelset.material.young; }, "Young's modulus of the wheelset", table1));
  rows.push_back(number(
      "wheelset.poisson_ratio", none, 0.3, {0, 0.45}, [](Case& c) -> double& { return c.wheelset.material.poisson; },
      "Poisson's ratio of the wheelset", table1));
  rows.push_back(number(
      "wheelset.density", density, 7800, {1000, 20000}, [](Case& c) -> double& { return c.wheelset.material.density; },
      "mass density of the wheelset", table1));
  rows.push_back(number(
      "wheelset.radius", metre, 0.46, {0.25, 0.7}, [](Case& c) -> double& { return c.wheelset.radius; },
      "nominal rolling radius", "paper, section 2"));
  rows.push_back(number(
      "wheelset.cone", none, 0, {-0.05, 0.15}, [](Case& c) -> double& { return c.wheelset.cone; },
      "conicity of the tread, its radius decreasing outwards; it touches the rail where the slopes agree",
      "assumed: as rail.inclination; paper, section 2: 0.025"));
  rows.push_back(number(
      "wheelset.rim_width", millimetre, 135, {60, 200}, [](Case& c) -> double& { return c.wheelset.rimWidth; },
      "width of the rim", steps));
  rows.push_back(number(
      "wheelset.rim_inner_radius", millimetre, 395, {150, 660},
      [](Case& c) -> double& { return c.wheelset.rimInnerRadius; }, "inner radius of the rim", steps));
  rows.push_back(number(
      "wheelset.web_thickness", millimetre, 28, {10, 100}, [](Case& c) -> double& { return c.wheelset.webThickness; },
      "thickness of the web, at the rim", steps));
  rows.push_back(number(
      "wheelset.web_hub_thickness", millimetre, 0, {0, 100},
      [](Case& c) -> double& { return c.wheelset.webHubThickness; },
      "thickness of the web at the hub, linear in between; 0: as at the rim", steps));
  rows.push_back(number(
      "wheelset.web_offset", millimetre, 0, {-100, 100}, [](Case& c) -> double& { return c.wheelset.webOffset; },
      "offset of the web at the hub from that at the rim, outwards positive (conical web)", steps));
  rows.push_back(number(
      "wheelset.hub_radius", millimetre, 140, {80, 300}, [](Case& c) -> double& { return c.wheelset.hubRadius; },
      "outer radius of the hub", steps));
  rows.push_back(number(
      "wheelset.hub_width", millimetre, 175, {80, 300}, [](Case& c) -> double& { return c.wheelset.hubWidth; },
      "width of the hub along the axle, centred on the wheel plane", steps));
}

// A tread that is not round: what its deviation was read from, and where it meets the rail.
void addTread(Rows& rows) {
  using Relation = Requirement::Relation;
  rows.push_back(text(
      "wheelset.tread_deviation", [](Case& c) -> std::string& { return c.tread.file; },
      "CSV file of the tread's deviation from round: angle (rad, deg) or length of arc, and radial deviation, negative "
      "where material is missing, or deviations at several lateral positions; relative to the case file; not read if "
      "the case contains wheelset.tread_points or wheelset.tread_lines",
      "none: a round wheel"));
  rows.push_back(
      appliesIf("wheelset.tread_lines", {"[]"},
                points(
                    "wheelset.tread_points", [](Case& c) -> std::vector<ProfilePoint>& { return c.tread.points; },
                    "pairs of arc length along the tread, in the order in which it meets the rail, and "
                    "radial deviation from wheelset.radius, negative where material is missing",
                    "none: a round wheel")));
  rows.push_back(lines(
      "wheelset.tread_lines", [](Case& c) -> std::vector<ProfileLine>& { return c.tread.lines; },
      "several such lines side by side, each with its lateral position, from the wheel plane outwards",
      "none: a round wheel"));
  Parameter position = number(
      "wheelset.tread_position", metre, 0, {-10, 10}, [](Case& c) -> double& { return c.tread.position; },
      "where along the track the deepest point of the tread's deviation meets the rail, from the deepest point of the "
      "defect; negative: before it",
      "0: where the defect would be");
  position.condition = {{{"wheelset.tread_points", Relation::isNot, {"[]"}}},
                        {{"wheelset.tread_lines", Relation::isNot, {"[]"}}}};
  rows.push_back(std::move(position));
}

void addBrakeDiscs(Rows& rows) {
  const auto withDiscs = [&](Parameter parameter) {
    rows.push_back(appliesUnless("wheelset.brake_discs", {"0"}, std::move(parameter)));
  };
  rows.push_back(wholeNumber(
      "wheelset.brake_discs", 0, {0, 3}, +[](Case& c) -> int& { return c.wheelset.brakeDiscs; },
      "brake discs between the wheel and the track centre, half of those of the axle",
      "assumed: the paper does not say; passenger coaches have two or three an axle (unverified)"));
  withDiscs(number(
      "wheelset.brake_disc_mass", kilogram, 90, {0, 500}, [](Case& c) -> double& { return c.wheelset.brakeDiscMass; },
      "mass of each brake disc with its hub, a ring on the surface of the axle",
      "assumed: 85 to 100 kg are usual (unverified)"));
  withDiscs(number(
      "wheelset.brake_disc_position", millimetre, 350, {40, 1200},
      [](Case& c) -> double& { return c.wheelset.brakeDiscPosition; },
      "middle of the disc nearest to the wheel, from the wheel plane towards the track centre; several stand evenly "
      "along the whole axle, the last one half a distance from the track centre",
      "assumed: about half way to the track centre"));
}

void addAxle(Rows& rows) {
  rows.push_back(number(
      "wheelset.seat_radius", millimetre, 92.5, {50, 200}, [](Case& c) -> double& { return c.wheelset.seatRadius; },
      "radius of the wheel seat; hub and seat are one solid, which this radius only divides", steps));
  rows.push_back(number(
      "wheelset.axle_radius", millimetre, 80, {40, 200}, [](Case& c) -> double& { return c.wheelset.axleRadius; },
      "radius of the axle body between the wheels", steps));
  rows.push_back(number(
      "wheelset.bore_radius", millimetre, 25, {5, 60}, [](Case& c) -> double& { return c.wheelset.boreRadius; },
      "radius of the bore along the axle; meshed at least 0.3 of the thinnest radius wide, up to 25 mm",
      "assumed: hollow axle"));
  rows.push_back(number(
      "wheelset.shoulder_radius", millimetre, 80, {40, 200},
      [](Case& c) -> double& { return c.wheelset.shoulderRadius; }, "radius of the step outside the hub", steps));
  rows.push_back(number(
      "wheelset.shoulder_end", millimetre, 150, {60, 500}, [](Case& c) -> double& { return c.wheelset.shoulderEnd; },
      "outer end of that step, from the wheel plane; a step below 12 mm is left out", steps));
  rows.push_back(number(
      "wheelset.journal_radius", millimetre, 65, {30, 150}, [](Case& c) -> double& { return c.wheelset.journalRadius; },
      "radius of the journal", steps));
  rows.push_back(number(
      "wheelset.journal_end", millimetre, 330, {100, 700}, [](Case& c) -> double& { return c.wheelset.journalEnd; },
      "outer end of the journal, from the wheel plane", steps));
  rows.push_back(number(
      "wheelset.bearing_centre", millimetre, 250, {80, 600},
      [](Case& c) -> double& { return c.wheelset.bearingCentre; },
      "middle of the bearing (spring, axle box), from the wheel plane", steps));
  rows.push_back(number(
      "wheelset.bearing_width", millimetre, 160, {20, 400}, [](Case& c) -> double& { return c.wheelset.bearingWidth; },
      "length of the bearing seat over which the axle box is spread", "assumed: two-row roller bearing"));
  rows.push_back(number(
      "wheelset.bearing_stiffness", stiffness, 0, {0, 100000},
      [](Case& c) -> double& { return c.wheelset.bearingStiffness; },
      "radial stiffness of the bearing between journal and axle box; 0: rigid, with the box spread over the bearing "
      "seat",
      "no evidence for the paper's; roller bearings have about 500 to 2000 MN/m (unverified)"));
  rows.push_back(appliesUnless("wheelset.bearing_stiffness", {"0"},
                               number(
                                   "wheelset.bearing_damping", damping, 0, {0, 1000},
                                   [](Case& c) -> double& { return c.wheelset.bearingDamping; },
                                   "radial damping of the bearing", "no evidence")));
  rows.push_back(number(
      "wheelset.axle_box_mass", kilogram, 150, {0, 1000}, [](Case& c) -> double& { return c.wheelset.axleBoxMass; },
      "mass of axle box and bearing", "literature: 100 to 150 kg"));
  rows.push_back(number(
      "wheelset.total_mass", kilogram, 950, {0, 5000}, [](Case& c) -> double& { return c.wheelset.totalMass; },
      "mass of the half wheelset; the mass beyond solid parts, axle box and stated brake discs is spread over the axle "
      "like discs; 0: what these parts weigh",
      "literature: heavy passenger wheelset"));
  addBrakeDiscs(rows);
  rows.push_back(number(
      "wheelset.track_centre", metre, 0.75, {0.5, 1.2}, [](Case& c) -> double& { return c.wheelset.trackCentre; },
      "distance from the wheel plane to the symmetry plane of the track", "literature: contact points 1.5 m apart"));
}

void addWheelsetDamping(Rows& rows) {
  rows.push_back(number(
      "wheelset.damping_ratio", none, 0, {0, 0.2}, [](Case& c) -> double& { return c.wheelset.dampingRatio; },
      "damping ratio of every flexible mode of the half wheelset below wheelset.damping_limit",
      "no evidence; 0: undamped steel, as in the paper's material data"));
  rows.push_back(appliesUnless(
      "wheelset.damping_ratio", {"0"},
      number(
          "wheelset.damping_limit", hertz, 2000, {50, 5000}, [](Case& c) -> double& { return c.wheelset.dampingLimit; },
          "frequency up to which modes of the half wheelset are damped",
          "paper, section 3: upper limit of the band studied")));
}

void addSuspension(Rows& rows) {
  rows.push_back(number(
      "suspension.sprung_mass", kilogram, 8000, {1, 50000}, [](Case& c) -> double& { return c.suspension.sprungMass; },
      "mass above the primary suspension, per wheel (M)", table1));
  rows.push_back(number(
      "suspension.stiffness", stiffness, 1.15, {0.01, 100}, [](Case& c) -> double& { return c.suspension.stiffness; },
      "vertical stiffness of the primary suspension (K1)", table1));
  rows.push_back(number(
      "suspension.damping", damping, 2.5, {0, 1000}, [](Case& c) -> double& { return c.suspension.damping; },
      "vertical damping of the primary suspension (C1)", table1));
  rows.push_back(number(
      "suspension.longitudinal_stiffness", stiffness, 20, {0.01, 1000},
      [](Case& c) -> double& { return c.suspension.longitudinalStiffness; },
      "longitudinal stiffness of the axle guidance, which transmits the traction to the sprung mass",
      "assumed: usual order of axle guidance"));
  rows.push_back(number(
      "suspension.longitudinal_damping", damping, 20, {0, 1000},
      [](Case& c) -> double& { return c.suspension.longitudinalDamping; }, "longitudinal damping of the axle guidance",
      "assumed"));
  rows.push_back(appliesIf("model.extent", {"whole"},
                           number(
                               "suspension.lateral_stiffness", stiffness, 4, {0.01, 100},
                               [](Case& c) -> double& { return c.suspension.lateralStiffness; },
                               "lateral stiffness of the axle guidance, which holds the wheelset across the track",
                               "assumed: usual order of axle guidance")));
  rows.push_back(appliesIf("model.extent", {"whole"},
                           number(
                               "suspension.lateral_damping", damping, 20, {0, 1000},
                               [](Case& c) -> double& { return c.suspension.lateralDamping; },
                               "lateral damping of the axle guidance", "assumed")));
}

void addBogie(Rows& rows) {
  const auto ofSecond = [&](Parameter parameter) {
    rows.push_back(appliesUnless("bogie.wheelbase", {"0"}, std::move(parameter)));
  };
  rows.push_back(number(
      "bogie.wheelbase", metre, 0, {0, 4}, [](Case& c) -> double& { return c.bogie.wheelbase; },
      "distance between the two wheelsets of the bogie; 0: a single wheelset",
      "assumed: a single wheelset, as in the paper; passenger bogies have 2.4 to 2.6 m (unverified)"));
  ofSecond(choice(
      "bogie.second_wheelset", {"behind", "ahead"}, SecondPlace::behind,
      +[](Case& c) -> SecondPlace& { return c.bogie.second; },
      "where the second wheelset runs, seen from the one that rolls over the defect; it is made of its modes of "
      "vibration "
      "and stands on Hertz's springs",
      "assumed"));
  ofSecond(number(
      "bogie.pitch_radius", metre, 0.9, {0.1, 5}, [](Case& c) -> double& { return c.bogie.pitchRadius; },
      "radius of gyration of the sprung mass of both wheelsets in pitch, about its lateral axis midway between them",
      "assumed: usual order of bogie frames"));
}

}  // namespace

Rows vehicleRows() {
  Rows rows;
  addWheel(rows);
  addTread(rows);
  addAxle(rows);
  addWheelsetDamping(rows);
  addSuspension(rows);
  addBogie(rows);
  return rows;
}

}  // namespace squat::cases::rows
