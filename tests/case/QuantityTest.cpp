// Numbers with a unit. Expected values: 1 km/h = 1/3.6 m/s, 1 rpm = 2 pi / 60 rad/s, powers of ten for the others.
#include "case/CaseDescription.h"
#include "case/Quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "case/CaseFile.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

using testing::HasSubstr;

double si(const char* key, const char* text) {
  const auto value = parseQuantity(text, *findParameter(key));
  EXPECT_TRUE(value) << key << " = " << text;
  return value.value_or(-1);
}

TEST(Quantity, UnitsOfTheSameQuantityGiveTheSameValue) {
  EXPECT_DOUBLE_EQ(si("motion.speed", "108 km/h"), 30);
  EXPECT_DOUBLE_EQ(si("motion.speed", "108km/h"), 30);
  EXPECT_EQ(si("motion.speed", "30 m/s"), 30);
  EXPECT_DOUBLE_EQ(si("motion.angular_velocity", "60 rpm"), 2 * std::numbers::pi);
  EXPECT_EQ(si("motion.torque", "12.45049 kN m"), 12450.49);
  EXPECT_EQ(si("defect.depth", "150 um"), 150e-6);
  EXPECT_EQ(si("defect.depth", "150 µm"), 150e-6);
  EXPECT_EQ(si("defect.depth", "0.015 cm"), 150e-6);
  EXPECT_EQ(si("track.length", "10000 mm"), 10);
  EXPECT_EQ(si("pad.stiffness", "1300 kN/mm"), 1300e6);
  EXPECT_EQ(si("pad.damping", "45000 N s/m"), 45e3);
  EXPECT_EQ(si("rail.yield_stress", "800 MPa"), 0.8e9);
  EXPECT_EQ(si("rail.density", "7.8 t/m3"), 7800);
  EXPECT_EQ(si("wheelset.total_mass", "0.95 t"), 950);
  EXPECT_EQ(si("output.rate", "25000 Hz"), 25e3);
  EXPECT_EQ(si("motion.torque_ramp", "0.004 s"), 0.004);
  EXPECT_EQ(si("contact.friction", "30 %"), 0.3);
}

TEST(Quantity, EveryUnitOfTheTableIsKnown) {
  for (const auto& parameter : parameterTable()) {
    if (parameter.kind != Kind::number || parameter.integer) continue;
    EXPECT_FALSE(knownUnits(parameter).empty()) << parameter.key << " [" << parameter.unit << "]";
    if (parameter.unit == "-") continue;
    EXPECT_EQ(parseQuantity("3 " + parameter.unit, parameter), parseQuantity("3", parameter)) << parameter.key;
  }
}

TEST(Quantity, AUnitOfAnotherQuantityIsRefused) {
  for (const char* text : {"30 m", "30 km", "30 mph", "m/s", "30 m/s m/s", "3 0 m/s", "", " "})
    EXPECT_FALSE(parseQuantity(text, *findParameter("motion.speed"))) << text;
  EXPECT_FALSE(parseQuantity("2 %", *findParameter("defect.wave_count")));
  CaseDescription description = defaultCase();
  const auto problem = trySetValue(description, *findParameter("motion.speed"), "60 mph");
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->advice, HasSubstr("m/s, km/h"));
}

TEST(Quantity, StandsInCaseFilesBetweenQuotes) {
  const auto description = parseCase("[motion]\nspeed = \"90 km/h\"\n[defect]\ndepth = \"200 um\"", "x.toml");
  EXPECT_DOUBLE_EQ(description.motion.speed, 25);
  EXPECT_EQ(description.defect.depth, 200e-6);
  EXPECT_DOUBLE_EQ(parseCase("", "x.toml", {}, {"", {{"motion.speed", "90 km/h"}}}).motion.speed, 25);
  // The range holds whatever the unit.
  EXPECT_THROW(parseCase("[motion]\nspeed = \"900 km/h\"", "x.toml"), CaseError);
}

std::string refusalOfCase(const std::string& text) {
  try {
    parseCase(text, "x.toml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return {};
}

TEST(Quantity, DecimalCommasAndUnquotedUnitsAreExplained) {
  EXPECT_THAT(refusalOfCase("[defect]\ndepth = 0,15\n"),
              testing::AllOf(HasSubstr("line 2"), HasSubstr("decimal point: 0.15")));
  EXPECT_THAT(refusalOfCase("[defect]\ndepth = \"0,15\"\n"), HasSubstr("decimal point instead of the comma: 0.15"));
  EXPECT_THAT(refusalOfCase("[defect]\ndepth = \"0,15 mm\"\n"),
              HasSubstr("decimal point instead of the comma: 0.15 mm"));
  EXPECT_THAT(refusalOfCase("[motion]\nspeed = 108 km/h # fast\n"), HasSubstr("between quotes: \"108 km/h\""));
}

}  // namespace
}  // namespace squat::cases
