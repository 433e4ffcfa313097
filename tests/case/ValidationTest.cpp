// Relations between keys: what is refused and what brings a warning.
#include "case/Validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/MeshPresets.h"
#include "case/ParameterValue.h"
#include "scenario/DefectSurface.h"

namespace squat::cases {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using Settings = std::vector<std::pair<const char*, const char*>>;

CaseDescription caseWith(const Settings& settings) {
  CaseDescription description = defaultCase();
  setValue(description, "motion.traction_coefficient", "0.2");  // far from slipping: no warning from the start
  for (const auto& [key, text] : settings) setValue(description, key, text);
  return description;
}

void expectProblem(const Settings& settings, const std::string& key) {
  const Validation validation = validate(caseWith(settings));
  EXPECT_THAT(validation.problems, Contains(Field(&CaseProblem::key, key)));
  for (const auto& problem : validation.problems) {
    EXPECT_FALSE(problem.allowed.empty() || problem.advice.empty()) << toText(problem);
    EXPECT_EQ(problem.value.empty(), isList(*findParameter(problem.key))) << toText(problem);
  }
}

void expectWarning(const Settings& settings, const std::string& key) {
  const Validation validation = validate(caseWith(settings));
  for (const auto& problem : validation.problems) ADD_FAILURE() << toText(problem);
  EXPECT_THAT(validation.warnings, Contains(Field(&CaseProblem::key, key)));
}

TEST(Validation, AGoodCaseHasNothingToSay) {
  const Validation validation = validate(caseWith({}));
  for (const auto& problem : validation.problems) ADD_FAILURE() << toText(problem);
  for (const auto& warning : validation.warnings) ADD_FAILURE() << toText(warning);
}

TEST(Validation, FindsValuesOutOfRangeInADescription) {
  CaseDescription description = defaultCase();
  description.motion.speed = std::numeric_limits<double>::quiet_NaN();
  description.rail.yieldStress = -1;
  description.contact.friction = -0.1;
  const auto problems = validate(description).problems;
  EXPECT_THAT(problems, Contains(Field(&CaseProblem::key, "motion.speed")));
  EXPECT_THAT(problems, Contains(Field(&CaseProblem::key, "rail.yield_stress")));
  EXPECT_THAT(problems, Contains(Field(&CaseProblem::key, "contact.friction")));
  EXPECT_EQ(problems.size(), 3u);
}

TEST(Validation, AZeroedDescriptionIsRefusedNotCrashed) { EXPECT_GT(validate(CaseDescription{}).problems.size(), 30u); }

TEST(Validation, Plasticity) {
  expectProblem({{"rail.tangent_modulus", "210"}}, "rail.tangent_modulus");
  expectProblem({{"rail.young_modulus", "20"}}, "rail.tangent_modulus");
  expectProblem({{"rail.plastic", "true"}, {"rail.plastic_depth", "0.5"}, {"defect.depth", "0.6"}}, "defect.depth");
}

TEST(Validation, StepsOfTheWheelset) {
  expectProblem({{"wheelset.rim_inner_radius", "460"}}, "wheelset.rim_inner_radius");
  expectProblem({{"wheelset.hub_radius", "90"}}, "wheelset.seat_radius");
  expectProblem({{"wheelset.journal_radius", "95"}}, "wheelset.journal_radius");
  expectProblem({{"wheelset.shoulder_end", "80"}}, "wheelset.hub_width");
  expectProblem({{"wheelset.journal_end", "150"}}, "wheelset.shoulder_end");
  expectProblem({{"wheelset.web_thickness", "100"}, {"wheelset.hub_width", "90"}}, "wheelset.web_thickness");
  expectProblem({{"wheelset.web_hub_thickness", "100"}, {"wheelset.hub_width", "80"}}, "wheelset.web_hub_thickness");
  expectProblem({{"wheelset.bore_radius", "50"}, {"wheelset.shoulder_radius", "45"}}, "wheelset.bore_radius");
}

TEST(Validation, BearingWithinTheJournal) {
  expectProblem({{"wheelset.bearing_width", "170"}}, "wheelset.bearing_centre");
  expectProblem({{"wheelset.bearing_centre", "220"}}, "wheelset.bearing_centre");
  EXPECT_TRUE(validate(caseWith({{"wheelset.bearing_width", "160"}})).problems.empty());
}

// Rim, web, hub, axle of the default wheelset weigh about 480 kg as rings, the axle box 150 kg.
TEST(Validation, MassesOfTheWheelset) {
  expectProblem({{"wheelset.total_mass", "500"}}, "wheelset.total_mass");
  expectProblem({{"wheelset.total_mass", "640"}, {"wheelset.brake_discs", "1"}}, "wheelset.total_mass");
  expectProblem({{"wheelset.brake_discs", "1"}, {"wheelset.brake_disc_position", "60"}},
                "wheelset.brake_disc_position");
  EXPECT_TRUE(validate(caseWith({{"wheelset.total_mass", "0"}, {"wheelset.brake_discs", "2"}})).problems.empty());
  expectProblem({{"wheelset.web_offset", "80"}}, "wheelset.web_offset");
  expectProblem({{"wheelset.axle_box_mass", "0"}, {"wheelset.bearing_stiffness", "1000"}}, "wheelset.axle_box_mass");
  EXPECT_TRUE(validate(caseWith({{"wheelset.total_mass", "700"}})).problems.empty());
}

// Solids by the closed form: 480 kg and some; the message names what each part weighs.
TEST(Validation, AMassBelowThatOfThePartsNamesThem) {
  const auto problems =
      validate(
          caseWith({{"wheelset.total_mass", "600"}, {"wheelset.brake_discs", "2"}, {"wheelset.brake_disc_mass", "70"}}))
          .problems;
  ASSERT_EQ(problems.size(), 1u);
  const auto text = toText(problems.front());
  for (const char* part : {"600", "solid parts 4", "axle box 150 kg", "brake discs 140 kg"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(Validation, HeightOfTheSleeper) {
  expectProblem({{"sleeper.middle_height", "0.16"}}, "sleeper.middle_height");
  expectProblem({{"sleeper.middle_height", "0.03"}}, "sleeper.middle_height");
  expectProblem({{"sleeper.middle_height", "0.1"}, {"sleeper.middle_half_length", "0.67"}},
                "sleeper.middle_half_length");
  expectWarning({{"sleeper.middle_half_length", "0.4"}}, "sleeper.middle_half_length");
  EXPECT_TRUE(validate(caseWith({{"sleeper.middle_height", "0.1"}})).problems.empty());
}

TEST(Validation, RunWithinTheTrack) {
  for (const char* key : {"motion.run_up", "motion.beyond"})
    expectProblem({{"track.length", "3"}, {"motion.run_up", "1.3"}, {"motion.beyond", "1.3"}}, key);
  expectProblem({{"motion.run_up", "0.03"}}, "motion.run_up");
  expectProblem({{"track.length", "2.4"}}, "track.length");
  expectWarning({{"motion.beyond", "0.02"}}, "motion.beyond");
}

TEST(Validation, TrackParts) {
  expectProblem({{"track.defect_from_sleeper", "0.31"}}, "track.defect_from_sleeper");
  expectProblem({{"pad.length", "0.3"}}, "pad.length");
  expectProblem({{"pad.longitudinal_stiffness", "0"}}, "pad.longitudinal_stiffness");
  expectProblem({{"pad.longitudinal_stiffness", "0"}, {"track.rail_ends", "absorbing"}}, "pad.longitudinal_stiffness");
  EXPECT_THAT(validate(caseWith({{"pad.longitudinal_stiffness", "0"}, {"track.rail_ends", "clamped"}})).problems,
              testing::IsEmpty());
  expectProblem({{"track.sleeper_spacing", "0.4"}, {"sleeper.width", "0.4"}}, "sleeper.width");
}

// The foot is 140 mm wide, that of a 60E1 150 mm.
TEST(Validation, APadIsAtMostAsWideAsTheFoot) {
  expectProblem({{"pad.width", "0.145"}}, "pad.width");
  EXPECT_THAT(validate(caseWith({{"rail.section", "60E1"}, {"pad.width", "0.15"}})).problems, testing::IsEmpty());
}

TEST(Validation, Defects) {
  expectProblem({{"defect.shape", "cut"}, {"defect.length", "10"}, {"defect.ramp", "6"}}, "defect.ramp");
  expectProblem({{"defect.shape", "cut"}, {"defect.ramp", "0.1"}, {"defect.depth", "0.1"}}, "defect.depth");
  expectWarning({{"defect.shape", "cut"}, {"defect.ramp", "0.5"}, {"defect.depth", "0.1"}}, "defect.depth");
  expectProblem({{"defect.shape", "profile"}}, "defect.points");
  expectProblem({{"mesh.preset", "tiny"},
                 {"defect.move_nodes", "true"},
                 {"mesh.contact_size", "0.5"},
                 {"defect.length", "200"},
                 {"defect.depth", "1.1"}},
                "defect.depth");
}

TEST(Validation, DefectLongerThanTheTrack) {
  expectProblem({{"track.length", "3"},
                 {"motion.run_up", "0.6"},
                 {"defect.shape", "profile"},
                 {"defect.points", "[[0, 0], [500, -0.1], [2500, -0.1], [2600, 0]]"}},
                "track.length");
}

// Each says the key, the value and the limit.
void expectSaid(const Settings& settings, const std::string& key, const std::string& value, const std::string& limit) {
  const Validation validation = validate(caseWith(settings));
  for (const auto* list : {&validation.problems, &validation.warnings})
    for (const auto& problem : *list)
      if (problem.key == key && problem.value.find(value) != std::string::npos &&
          (problem.allowed + " " + problem.advice).find(limit) != std::string::npos)
        return;
  ADD_FAILURE() << key << ", " << value << ", " << limit << " is not said";
  for (const auto* list : {&validation.problems, &validation.warnings})
    for (const auto& problem : *list) ADD_FAILURE() << "but: " << toText(problem);
}

// Out of a key's own range: refused where it is set.
void expectRefused(const char* key, const char* value, const char* limit) {
  CaseDescription description = defaultCase();
  const auto problem = trySetValue(description, *findParameter(key), value);
  ASSERT_TRUE(problem) << key << " = " << value;
  EXPECT_EQ(problem->key, key);
  EXPECT_EQ(problem->value, value);
  EXPECT_THAT(problem->allowed, HasSubstr(limit));
}

TEST(Validation, BadInputSaysKeyValueAndLimit) {
  expectRefused("rail.yield_stress", "0", "0.05 to 10 GPa");
  expectRefused("rail.yield_stress", "-0.8", "0.05 to 10 GPa");
  expectRefused("contact.friction", "-0.1", "0 to 1");
  expectSaid({{"rail.tangent_modulus", "210"}}, "rail.tangent_modulus", "210 GPa",
             "below rail.young_modulus = 210 GPa");
  expectSaid({{"rail.tangent_modulus", "250"}}, "rail.tangent_modulus", "250 GPa",
             "below rail.young_modulus = 210 GPa");
  // 50 mm dip, 30 mm rolled beyond its middle are 5 mm beyond its end; 20 mm are not.
  expectSaid({{"motion.beyond", "0.02"}}, "motion.beyond", "0.02 m", "at least 0.025 m");
  expectSaid({{"rail.plastic", "true"}, {"rail.plastic_depth", "0.5"}, {"defect.depth", "0.6"}}, "defect.depth",
             "0.6 mm", "at most rail.plastic_depth = 0.5 mm");
  expectSaid(
      {{"defect.move_nodes", "true"}, {"mesh.contact_size", "1.3"}, {"defect.depth", "3"}, {"defect.length", "400"}},
      "defect.depth", "3 mm", "at most twice mesh.contact_size = 2.6 mm");
  // A cosine of 4 mm depth over 20 mm drops by pi times 4 / 20.
  expectSaid({{"defect.depth", "4"}, {"defect.length", "20"}}, "defect.depth", "4 mm",
             "such that no slope is above 0.5");
  expectSaid({{"defect.shape", "profile"}, {"defect.points", "[[0, 0], [15, -0.1], [30, -0.2], [45, -0.1], [60, 0]]"}},
             "defect.points", "", "15 mm apart, more than an eighth of the dip");
  expectSaid({{"track.length", "3"},
              {"motion.run_up", "0.6"},
              {"defect.shape", "profile"},
              {"defect.points", "[[0, 0], [500, -0.1], [2500, -0.1], [2600, 0]]"}},
             "track.length", "3 m", "at least 4.2 m");
  expectSaid({{"motion.traction_coefficient", "0.35"}}, "motion.traction_coefficient", "0.35",
             "at most contact.friction = 0.3");
}

// Crown R300, patch 5.2 mm half wide under 87.8 kN, fine band 7.8 mm (draft): the middle of the patch up to 2.6 mm off.
TEST(Validation, TheFineBandHoldsThePatch) {
  EXPECT_TRUE(validate(caseWith({{"motion.lateral_offset", "2.5"}})).problems.empty());
  expectSaid({{"motion.lateral_offset", "4"}}, "motion.lateral_offset", "4 mm", "-2.64 to 2.64 mm");
  expectSaid({{"motion.lateral_offset", "4"}}, "motion.lateral_offset", "4 mm", "mesh.band_half_width = 7.8 mm");
  EXPECT_TRUE(validate(caseWith({{"motion.lateral_offset", "4"}, {"mesh.band_half_width", "10.4"}})).problems.empty());
  // Slopes that differ by 0.04 would meet 12 mm beside the middle, on R80.
  expectProblem({{"wheelset.cone", "0.04"}, {"mesh.band_half_width", "20.8"}}, "wheelset.cone");
  EXPECT_TRUE(validate(caseWith({{"wheelset.cone", "0.025"}, {"rail.inclination", "0.025"}})).problems.empty());
}

TEST(Validation, LinesSideBySide) {
  const char* lines =
      "[[-10, [[0, 0], [5, -0.1], [10, -0.2], [15, -0.1], [20, 0]]], [10, [[0, 0], [5, -0.05], [10, -0.1], [20, 0]]]]";
  const auto good = validate(caseWith({{"defect.shape", "profile"}, {"defect.lines", lines}}));
  EXPECT_TRUE(good.problems.empty());
  expectProblem({{"defect.shape", "profile"}, {"defect.lines", lines}, {"defect.lateral", "parabolic"}},
                "defect.lateral");
  expectRefused("defect.lines", "[[0, [[0, 0], [1, 0]]]]", "lateral position");
  expectRefused("defect.lines", "[[5, [[0, 0], [1, 0]]], [5, [[0, 0], [1, 0]]]]", "ascending");
  expectRefused("defect.lines", "[[5, [[0, 0], [1, 0]]], [50, [[0, 0], [1, 0]]]]", "lateral position");
  expectRefused("defect.lines", "[[5, [[0, 0], [0, 1]]], [8, [[0, 0], [1, 0]]]]", "lateral position");
  expectRefused("defect.lines", "[[5, []], [8, [[0, 0], [1, 0]]]]", "lateral position");
}

// 60 mm dip: an eighth is 7.5 mm of the whole, less of the part below 5 % of the depth.
TEST(Validation, CoarseProfiles) {
  expectWarning(
      {{"defect.shape", "profile"}, {"defect.points", "[[0, 0], [15, -0.1], [30, -0.2], [45, -0.1], [60, 0]]"}},
      "defect.points");
  expectWarning({{"defect.shape", "profile"}, {"defect.points", "[[0, 0], [30, 0.1], [60, 0]]"}}, "defect.points");
  expectWarning({{"defect.points", "[[0, 0], [30, -0.1], [60, 0]]"}}, "defect.points");  // no effect
  expectWarning({{"defect.shape", "profile"},
                 {"defect.level", "false"},
                 {"defect.points", "[[0, 0.01], [5, -0.05], [10, -0.1], [15, -0.05], [20, 0]]"}},
                "defect.level");
}

TEST(Validation, Meshes) {
  expectProblem({{"mesh.rolling_size", "2"}}, "mesh.rolling_size");
  expectProblem({{"mesh.rolling_size", "40"}, {"mesh.far_size", "30"}}, "mesh.far_size");
  expectProblem({{"mesh.far_size", "300"}, {"track.sleeper_spacing", "0.4"}, {"sleeper.width", "0.2"}},
                "mesh.far_size");
  expectProblem({{"mesh.rim_depth", "65"}}, "mesh.rim_depth");
  expectWarning({{"mesh.contact_size", "5"}, {"defect.length", "15"}, {"defect.depth", "0.05"}}, "mesh.contact_size");
}

// The default follows the speed; an angular velocity that does not makes the wheel slide all the way.
TEST(Validation, AWheelThatSlidesFromTheStartBringsAWarning) {
  EXPECT_TRUE(validate(caseWith({{"motion.speed", "25"}, {"motion.torque", "0"}})).warnings.empty());
  const auto sliding = validate(caseWith({{"motion.speed", "25"}, {"motion.angular_velocity", "65.2"}}));
  ASSERT_FALSE(sliding.warnings.empty());
  EXPECT_EQ(sliding.warnings.front().key, "motion.angular_velocity");
}

// 8000 kg on a lever of 250 mm: 19.6 kNm. A solid axle of 50 mm has a section modulus of pi r^3 / 4 = 98.2 cm3, which
// makes 200 MPa; with a bore of 40 mm 98.2 (1 - 0.8^4) = 58 cm3 and 338 MPa, beyond the 320 MPa of axle steel.
TEST(Validation, AnAxleThatWouldYieldBringsAWarning) {
  const auto with = [](const char* bore) {
    return validate(caseWith({{"wheelset.axle_radius", "50"}, {"wheelset.bore_radius", bore}, {"motion.torque", "0"}}));
  };
  EXPECT_TRUE(with("10").warnings.empty());
  const auto weak = with("40");
  ASSERT_FALSE(weak.warnings.empty());
  EXPECT_EQ(weak.warnings.front().key, "wheelset.axle_radius");
  EXPECT_THAT(weak.warnings.front().advice, ::testing::HasSubstr("to 338."));
}

TEST(Validation, WavesAreNotDeeperThanTheDip) {
  expectProblem({{"defect.shape", "dip-with-wave"},
                 {"defect.depth", "0.05"},
                 {"defect.wave_depth", "0.2"},
                 {"defect.wave_count", "2"}},
                "defect.wave_depth");
}

// The rail is centred on a sleeper, up to 0.3 m beside the middle of the run.
TEST(Validation, RailIsLeftAtBothEndsOfTheRun) {
  expectProblem(
      {{"track.length", "3"}, {"track.defect_from_sleeper", "0.3"}, {"motion.run_up", "1.2"}, {"motion.beyond", "1.1"}},
      "motion.beyond");
}

TEST(Validation, FilterBelowHalfTheRate) {
  expectProblem({{"output.rate", "16"}, {"output.filter_cutoff", "7"}}, "output.filter_cutoff");
}

// Full slip: torque / radius, less the share that spins up the wheelset, against friction times load
// (8950 kg * 9.81 m/s2 * 0.3 = 26.34 kN). 12450.49 N m give 26.42 kN = 0.3009 of the load, just beyond it: with the
// 46.3 kg m2 that the balance of torque, traction and angular velocity of three runs on `tiny` gives, 27.07 kN / (1 +
// 0.0245).
TEST(Validation, TorqueBeyondTheAdhesionLimitBringsAWarning) {
  const char *torque = "motion.torque", *coefficient = "motion.traction_coefficient";
  expectWarning({{coefficient, "0.35"}}, coefficient);
  const auto slipping = validate(caseWith({{coefficient, "0"}, {torque, "14000"}}));
  const auto paper = validate(caseWith({{coefficient, "0"}, {torque, "12450.49"}}));
  const auto nearly = validate(caseWith({{coefficient, "0"}, {torque, "12300"}}));
  ASSERT_EQ(paper.warnings.size(), 1u);
  EXPECT_EQ(paper.warnings[0].key, torque);
  EXPECT_THAT(paper.warnings[0].advice, HasSubstr("0.301 of the wheel load"));
  EXPECT_THAT(paper.warnings[0].advice, HasSubstr("exceeds the adhesion limit"));
  ASSERT_EQ(slipping.warnings.size(), 1u);
  EXPECT_THAT(slipping.warnings[0].advice, HasSubstr("exceeds the adhesion limit"));
  ASSERT_EQ(nearly.warnings.size(), 1u);
  EXPECT_THAT(nearly.warnings[0].advice, HasSubstr("nearly reaches the adhesion limit"));
  EXPECT_TRUE(validate(caseWith({{"motion.traction_coefficient", "0"}, {"motion.torque", "11000"}})).warnings.empty());
  EXPECT_TRUE(validate(caseWith({{"contact.friction", "0.25"}})).warnings.empty());
}

// The same dips, sampled as finely as the message about their first points asks for.
TEST(Validation, ASpacingThatAMessageNamesIsAccepted) {
  const std::vector<std::string> sampled{"[[-20, 0], [-10, -0.06], [0, -0.1], [10, -0.06], [20, 0]]",
                                         "[[-20, 0], [-10, -0.03], [0, -0.1], [10, -0.03], [20, 0]]",
                                         "[[-30, 0], [-15, -0.05], [0, -0.15], [15, -0.05], [30, 0]]",
                                         "[[0, 0], [7, -0.02], [14, -0.1], [21, -0.06], [40, 0]]"};
  const auto named = [](const CaseDescription& description) {  // [m]; 0: no warning
    const std::string words = "sampled with points at most ";
    for (const auto& warning : validate(description).warnings)
      if (warning.allowed.starts_with(words)) return 1e-3 * std::stod(warning.allowed.substr(words.size()));
    return 0.0;
  };
  for (const auto& points : sampled) {
    auto description = caseWith({{"defect.shape", "profile"}, {"defect.points", points.c_str()}});
    const double step = named(description);
    ASSERT_GT(step, 0) << points;
    const scenario::DefectSurface coarse(description.defect);
    description.defect.points = {{coarse.first(), 0}};
    for (double x = std::floor(coarse.first() / step) * step; x < coarse.last() - 0.01 * step; x += step)
      if (x > coarse.first() + 0.01 * step) description.defect.points.push_back({x, coarse.height(x)});
    description.defect.points.push_back({coarse.last(), 0});
    EXPECT_EQ(named(description), 0) << points;
  }
}

// A newcomer's first case, and what the studio opens with: defaults, on any mesh.
TEST(Validation, TheDefaultCaseBringsNoWarning) {
  for (const auto preset : {MeshPreset::tiny, MeshPreset::draft, MeshPreset::standard, MeshPreset::paper}) {
    CaseDescription description = defaultCase();
    applyPreset(description, preset);
    for (const auto& warning : validate(description).warnings) ADD_FAILURE() << toText(warning);
  }
}

// A profile of 40 mm, its positions taken for metres: 40 m of track would be needed.
TEST(Validation, AProfileInTheWrongUnitIsRecognised) {
  const auto problems =
      validate(caseWith({{"defect.shape", "profile"},
                         {"defect.points", "[[0, 0], [5000, -0.1], [20000, -0.2], [35000, -0.1], [40000, 0]]"}}))
          .problems;
  for (const char* key : {"track.length", "motion.run_up"}) {
    const auto problem = std::find_if(problems.begin(), problems.end(), [&](const auto& p) { return p.key == key; });
    ASSERT_NE(problem, problems.end()) << key;
    EXPECT_THAT(problem->advice, HasSubstr("40 m long: check the unit"));
  }
  const auto inRange = validate(caseWith({{"track.length", "3"}, {"motion.run_up", "1"}})).problems;
  for (const auto& problem : inRange) EXPECT_THAT(problem.advice, testing::Not(HasSubstr("unit"))) << toText(problem);
}

}  // namespace
}  // namespace squat::cases
