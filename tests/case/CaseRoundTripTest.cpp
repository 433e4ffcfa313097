// What is written reads back the same, bit for bit, whatever the values and whatever the locale.
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <locale>
#include <random>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "case/DecimalNumber.h"
#include "case/ParameterValue.h"
#include "core/Errors.h"

namespace squat::cases {
namespace {

std::string randomText(std::mt19937_64& random) {
  const std::vector<std::string> letters{"a", " ", "\"", "\\", "\n", "\t", "#", "=", "[", "'", "ü", "µ", "€", "𝛼"};
  std::string text;
  for (auto count = random() % 30; count > 0; --count) text += letters[random() % letters.size()];
  return text;
}

// Any value within the range of its parameter; relations may be violated.
void randomise(CaseDescription& description, const Parameter& parameter, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  std::string text;
  switch (parameter.kind) {
    case Kind::number: {
      const double value = parameter.minimum + share(random) * (parameter.maximum - parameter.minimum);
      text = formatDecimal(parameter.integer ? std::floor(value) : value);
      break;
    }
    case Kind::choice:
      text = parameter.choices[random() % parameter.choices.size()];
      break;
    case Kind::boolean:
      text = random() % 2 ? "true" : "false";
      break;
    case Kind::text:
      text = randomText(random);
      break;
    case Kind::points: {
      double position = -share(random);
      text = "[";
      for (int i = 0; i < 20; ++i) {
        position += 0.1 + share(random);
        text += (i ? ",[" : "[") + formatDecimal(position) + "," + formatDecimal(share(random) - 0.5) + "]";
      }
      text += "]";
      break;
    }
    case Kind::lines: {
      double lateral = -20;
      text = "[";
      for (int i = 0; i < 4; ++i) {
        lateral += 0.1 + 5 * share(random);
        text += (i ? ",[" : "[") + formatDecimal(lateral) + ",[[-" + formatDecimal(share(random) + 0.1) + ",0],[0," +
                formatDecimal(share(random) - 0.5) + "],[7,0]]]";
      }
      text += "]";
      break;
    }
    case Kind::forceCurve: {
      double compression = -0.1 * share(random), force = -share(random);
      text = "[";
      for (int i = 0; i < 5; ++i) {
        compression += 0.1 + share(random), force += 1 + 20 * share(random);
        text += (i ? ",[" : "[") + formatDecimal(compression) + "," + formatDecimal(force) + "]";
      }
      text += "]";
      break;
    }
    case Kind::seats:
      text = "[{ sleeper = -1, pad_stiffness = " + formatDecimal(1 + 1000 * share(random)) +
             ", pad_damping = " + formatDecimal(100 * share(random)) +
             " }, { sleeper = 0, ballast_stiffness = " + formatDecimal(1 + 100 * share(random)) +
             ", ballast_damping = " + formatDecimal(100 * share(random)) +
             " }, { sleeper = 2, gap = " + formatDecimal(20 * share(random)) + " }]";
      break;
  }
  const auto problem = trySetValue(description, parameter, text);
  ASSERT_FALSE(problem) << toText(*problem);
}

// Reads a written case key by key, so that relations among random values do not matter.
CaseDescription readBack(const std::string& text) {
  try {
    return parseCase(text, "x.toml");
  } catch (const CaseError& error) {
    for (const auto& problem : error.problems())
      EXPECT_EQ(problem.advice.find("Write"), std::string::npos) << toText(problem);
    throw;
  }
}

TEST(CaseRoundTrip, EveryValueComesBackBitForBit) {
  std::mt19937_64 random(20260102);
  for (int round = 0; round < 100; ++round) {
    for (const auto& parameter : parameterTable()) {
      // One random parameter at a time on a valid case, kept where the case stays valid.
      CaseDescription description = defaultCase();
      if (random() % 10 != 0) continue;
      randomise(description, parameter, random);
      // A case that names a table carries it.
      if (!description.tread.file.empty()) description.tread.points = {{0, 0}, {0.02, -0.5e-3}, {0.04, 0}};
      if (!description.pad.dynamicFile.empty()) description.pad.dynamicValues = "200: 300 30, 400: 310 31";
      try {
        const CaseDescription back = readBack(writeCase(description));
        ASSERT_EQ(valueText(back, parameter), valueText(description, parameter)) << parameter.key;
        ASSERT_EQ(writeCase(back), writeCase(description)) << parameter.key;
        ASSERT_EQ(caseHash(back), caseHash(description)) << parameter.key;
      } catch (const CaseError&) {
        // the random value does not go with the others; its own form was checked above
      }
    }
  }
}

// Values of the same decimal text are equal in every bit; here also the SI values, for a number of every unit.
TEST(CaseRoundTrip, SiValuesKeepTheirBits) {
  std::mt19937_64 random(20260103);
  std::uniform_real_distribution<double> share(0.9, 1.1);
  for (int round = 0; round < 500; ++round) {
    CaseDescription description = defaultCase();
    description.pad.stiffness *= share(random);
    description.pad.damping *= share(random);
    description.rail.material.young *= share(random);
    description.motion.torque *= share(random);
    description.mesh.contactSize *= share(random);
    description.damping.beta = 1e-6 * share(random);
    description.output.rate *= share(random);
    const CaseDescription back = parseCase(writeCase(description), "x.toml");
    ASSERT_EQ(back.pad.stiffness, description.pad.stiffness);
    ASSERT_EQ(back.pad.damping, description.pad.damping);
    ASSERT_EQ(back.rail.material.young, description.rail.material.young);
    ASSERT_EQ(back.motion.torque, description.motion.torque);
    ASSERT_EQ(back.mesh.contactSize, description.mesh.contactSize);
    ASSERT_EQ(back.damping.beta, description.damping.beta);
    ASSERT_EQ(back.output.rate, description.output.rate);
  }
}

TEST(CaseRoundTrip, WrittenFileNamesUnitAndDocumentation) {
  const std::string text = writeCase(defaultCase());
  EXPECT_NE(text.find("stiffness = 1300  # MN/m: vertical stiffness of a rail pad"), std::string::npos);
  EXPECT_NE(text.find("schema = 1"), std::string::npos);
  for (const auto& parameter : parameterTable())
    EXPECT_NE(text.find("\n" + parameter.key.substr(parameter.key.rfind('.') + 1) + " = "), std::string::npos)
        << parameter.key;
}

// A locale with a decimal comma and dots between thousands, as de_DE has; built here, so that it need not be installed.
class GermanNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(CaseRoundTrip, LocaleChangesNothing) {
  const std::string expected = writeCase(defaultCase()), hash = caseHash(defaultCase());
  const std::string cLocale = std::setlocale(LC_ALL, nullptr);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name)) break;
  const auto restore = [&] {
    std::locale::global(before);
    std::setlocale(LC_ALL, cLocale.c_str());
  };
  const std::string text = writeCase(defaultCase());
  const CaseDescription back = parseCase("[motion]\ntorque = 12450.49\n[defect]\ndepth = 0.15\n", "x.toml");
  const std::string backHash = caseHash(defaultCase());
  restore();
  EXPECT_EQ(text, expected);
  EXPECT_EQ(backHash, hash);
  EXPECT_EQ(back.motion.torque, 12450.49);
  EXPECT_EQ(back.defect.depth, 0.15e-3);
}

TEST(CaseHash, IsEightHexadecimalDigits) {
  const std::string hash = caseHash(defaultCase());
  EXPECT_EQ(hash.size(), 8u);
  EXPECT_TRUE(
      std::all_of(hash.begin(), hash.end(), [](char c) { return std::string("0123456789abcdef").find(c) < 16; }));
}

TEST(CaseHash, StandsForWhatThePhysicsSees) {
  CaseDescription other = defaultCase();
  other.title = "another name";
  other.note = "another note";
  other.defect.file = "elsewhere.csv";
  EXPECT_EQ(caseHash(other), caseHash(defaultCase()));
  for (const auto& parameter : parameterTable()) {
    if (parameter.kind != Kind::number) continue;
    CaseDescription plain = defaultCase();
    // Seen with these keys only.
    if (parameter.key == "pad.preload") setValue(plain, "pad.curve", "[[0, 0], [0.1, 20]]");
    if (parameter.key == "sleeper.middle_half_length") setValue(plain, "sleeper.middle_height", "0.1");
    if (parameter.key.rfind("wheelset.brake_disc_", 0) == 0) setValue(plain, "wheelset.brake_discs", "1");
    if (parameter.key.rfind("rail.irregularity_", 0) == 0) setValue(plain, "rail.irregularity", "iso-3095");
    if (parameter.key.rfind("suspension.lateral_", 0) == 0) setValue(plain, "model.extent", "whole");
    if (parameter.key == "bogie.pitch_radius") setValue(plain, "bogie.wheelbase", "2.5");
    if (parameter.key == "defect.filter_width") setValue(plain, "defect.filter", "median");
    CaseDescription changed = plain;
    setValue(changed, parameter.key,
             formatDecimal(parameter.defaultValue == parameter.maximum ? parameter.minimum : parameter.maximum));
    EXPECT_NE(caseHash(changed), caseHash(plain)) << parameter.key;
  }
}

}  // namespace
}  // namespace squat::cases
