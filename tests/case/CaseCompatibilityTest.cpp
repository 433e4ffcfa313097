// A case file of every released schema version, and a shipped one of every released version, frozen in the tree: each
// must go on being read, with the same numbers.
// Expected: what stands in the file, turned from its units into SI by hand.
#include <gtest/gtest.h>

#include "case/CaseFile.h"
#include "case/Validation.h"

namespace squat::cases {
namespace {

TEST(CaseCompatibility, Schema1) {
  const auto c = loadCase(SQUAT_SOURCE_DIR "/tests/case/frozen/squat-case-1.toml");
  EXPECT_TRUE(validate(c).problems.empty());
  EXPECT_EQ(c.title, "Frozen – Weiche 7, Gleis 2");
  EXPECT_EQ(c.note, "Two lines,\n\"quoted\".");
  EXPECT_EQ(c.defect.shape, DefectShape::profile);
  EXPECT_EQ(c.defect.lateral, LateralShape::parabolic);
  EXPECT_FALSE(c.defect.level);
  EXPECT_EQ(c.defect.heightScale, 0.8);
  EXPECT_DOUBLE_EQ(c.defect.halfWidth, 0.0185);
  EXPECT_DOUBLE_EQ(c.defect.lateralCentre, -0.003);
  ASSERT_EQ(c.defect.points.size(), 5U);
  EXPECT_DOUBLE_EQ(c.defect.points[1].position, -0.0125);
  EXPECT_DOUBLE_EQ(c.defect.points[2].height, -150e-6);
  EXPECT_EQ(c.motion.speed, 28.5);
  EXPECT_EQ(c.motion.tractionCoefficient, 0.05);
  EXPECT_DOUBLE_EQ(c.motion.torqueRamp, 0.005);
  EXPECT_EQ(c.motion.runUp, 0.25);
  EXPECT_DOUBLE_EQ(c.motion.lateralOffset, -0.002);
  EXPECT_EQ(c.contact.friction, 0.4);
  EXPECT_DOUBLE_EQ(c.damping.beta, 5e-8);
  EXPECT_EQ(c.track.length, 9);
  EXPECT_EQ(c.track.railEnds, RailEnds::absorbing);
  EXPECT_DOUBLE_EQ(c.rail.material.young, 206e9);
  EXPECT_TRUE(c.rail.plastic);
  EXPECT_DOUBLE_EQ(c.rail.yieldStress, 0.6e9);
  EXPECT_EQ(c.rail.hardening, Hardening::kinematic);
  EXPECT_DOUBLE_EQ(c.pad.stiffness, 900e6);
  EXPECT_DOUBLE_EQ(c.pad.damping, 30e3);
  EXPECT_EQ(c.sleeper.height, 0.2);
  EXPECT_DOUBLE_EQ(c.ballast.stiffness, 60e6);
  EXPECT_EQ(c.wheelset.radius, 0.45);
  EXPECT_DOUBLE_EQ(c.wheelset.rimInnerRadius, 0.385);
  EXPECT_EQ(c.wheelset.axleBoxMass, 120);
  EXPECT_DOUBLE_EQ(c.wheelset.bearingStiffness, 1.5e9);
  EXPECT_EQ(c.suspension.sprungMass, 6500);
  EXPECT_EQ(c.mesh.preset, MeshPreset::tiny);
  EXPECT_EQ(c.mesh.wheelSectors, 64);
  EXPECT_EQ(c.mesh.precision, ElementPrecision::full);
  EXPECT_DOUBLE_EQ(c.output.rate, 50e3);
  EXPECT_DOUBLE_EQ(c.output.filterCutoff, 3e3);
  // What the file leaves out has the defaults of its day: the paper's.
  EXPECT_EQ(c.rail.section, RailSection::rail54E1);
  EXPECT_DOUBLE_EQ(c.pad.lateralStiffness, 130e6);
  EXPECT_EQ(c.motion.gravity, 9.81);
  EXPECT_DOUBLE_EQ(c.suspension.stiffness, 1.15e6);
}

// A shipped case of 0.2.0: its own numbers count, although the preset that it names has other ones since.
TEST(CaseCompatibility, ShippedCaseOfVersion020) {
  const auto c = loadCase(SQUAT_SOURCE_DIR "/tests/case/frozen/0.2.0/light-defect.toml");
  EXPECT_TRUE(validate(c).problems.empty());
  EXPECT_EQ(c.title, "Light defect");
  EXPECT_EQ(c.wheelsetPreset, "estimated");
  EXPECT_EQ(c.wheelset.axleBoxMass, 139);
  EXPECT_EQ(c.wheelset.totalMass, 907);
  EXPECT_DOUBLE_EQ(c.wheelset.webThickness, 0.0315);
  EXPECT_EQ(c.sleeper.height, 0.191);
  EXPECT_EQ(c.sleeper.width, 0.2069);
  EXPECT_EQ(c.defect.shape, DefectShape::cut);
  EXPECT_DOUBLE_EQ(c.defect.length, 0.024);
  EXPECT_DOUBLE_EQ(c.defect.depth, 1.5e-4);
  EXPECT_DOUBLE_EQ(c.defect.ramp, 4e-3);
  EXPECT_EQ(c.track.defectFromSleeper, 0.203);
  EXPECT_EQ(c.motion.torque, 12450.49);
  // What came later does nothing.
  EXPECT_EQ(c.defect.from, c.defect.to);
  EXPECT_EQ(c.defect.filter, ProfileFilter::none);
}

// The profile that was shipped with 0.2.0, 1 m at 5 mm, as a file of its case and as one named on the command line.
TEST(CaseCompatibility, ProfileOfVersion020) {
  const std::string folder = SQUAT_SOURCE_DIR "/tests/case/frozen/0.2.0/";
  const auto c = loadCase(folder + "light-defect.toml",
                          {"", {{"defect.shape", "profile"}, {"defect.file", folder + "profiles/light-defect.csv"}}});
  EXPECT_TRUE(validate(c).problems.empty());
  ASSERT_EQ(c.defect.points.size(), 201U);
  EXPECT_EQ(c.defect.points.front().position, -0.5);
  EXPECT_EQ(c.defect.points[99].position, -0.005);
  EXPECT_EQ(c.defect.points[99].height, -0.000136);
  EXPECT_EQ(c.defect.points[100].height, -0.00015);
  EXPECT_EQ(c.defect.points[109].height, -3e-5);
}

}  // namespace
}  // namespace squat::cases
