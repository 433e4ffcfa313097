#include "case/CaseDescription.h"
#include "statements/Reference.h"

#include <gmock/gmock.h>

#include <map>

#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"
#include "statements/Judge.h"

namespace squat::statements {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::TemporaryFolder;

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  writeDurably(folder / "paper.json", text);
  try {
    readReference(folder / "paper.json");
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

std::string with(const std::string& statement) {
  return R"({"schema": "squat-reference", "schema_version": 1, "source": "s", "runs": [{"name": "a", "case": "a",
          "set": []}], "statements": [)" +
         statement + "]}";
}

TEST(Reference, EveryRunOfThePapersStatementsIsACaseThatCanBeRead) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  EXPECT_GE(reference.statements.size(), 20U);
  for (const auto& run : reference.runs)
    for (const char* preset : {"tiny", "draft", "standard", "paper"}) {
      cases::CaseOverrides overrides;
      overrides.preset = preset;
      overrides.values = run.sets;
      EXPECT_NO_THROW(cases::loadCase(run.caseName, overrides)) << run.name << " " << preset;
    }
  for (const auto& statement : reference.statements) EXPECT_FALSE(statement.reason.empty()) << statement.text;
}

// What the paper states of its model, on the mesh preset of that name: all 29 parameters, yielding layer and 1 m of
// run-up among them.
TEST(Reference, TheModelOnThePapersMeshIsThePapers) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  EXPECT_EQ(reference.parameters.size(), 29U);
  results::RunResult result;
  results::setCase(result, reference.run("light-defect")->caseOn("paper"));
  for (const auto& each : compareParameters(reference, result))
    EXPECT_TRUE(each.same) << each.parameter.key << " is " << each.ours;
}

// The cases stay within adhesion, but the statements are judged on runs with the torque that the paper states.
TEST(Reference, EveryRunHasThePapersTorque) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  for (const auto& run : reference.runs)
    for (const char* preset : {"tiny", "draft", "standard", "paper"})
      EXPECT_EQ(run.caseOn(preset).motion.torque, 12450.49) << run.name << " " << preset;
}

TEST(Reference, MeasuresNeedWhatTheyMeasure) {
  const auto statement = [](const std::string& measure) {
    return with(R"({"section": "1", "statement": "x", "run": "a", "unit": "Hz", "reason": "r", "low": 1, )" + measure +
                "}");
  };
  EXPECT_THAT(refusal(statement(R"("measure": "band_power")")), HasSubstr("needs a band"));
  EXPECT_THAT(refusal(statement(R"("measure": "line")")), HasSubstr("needs a frequency"));
  EXPECT_EQ(refusal(statement(R"("measure": "line", "near": 300)")), "accepted");
  EXPECT_THAT(refusal(R"({"schema": "squat-reference", "schema_version": 1, "source": "s", "runs": [],
                          "statements": []})"),
              HasSubstr("lists no run"));
}

// 0.1 m takes a period of 300 Hz at 30 m/s: a window that parts lines there needs 0.6 m behind the defect.
TEST(Reference, RunsThatJudgeLowLinesGoFarEnough) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  for (const auto& s : reference.statements) {
    const bool low = (s.near > 0 && s.near <= 320) || (s.band.second > 0 && s.band.second <= 320);
    if (!low) continue;
    for (const auto& name : {s.run, s.against}) {
      if (name.empty()) continue;
      const auto& sets = reference.run(name)->sets;
      EXPECT_THAT(sets, ::testing::Contains(std::make_pair(std::string("motion.beyond"), std::string("0.6"))))
          << s.text;
    }
  }
}

// Table 1 and section 2 of the paper, typed once more: the file must hold them, in the units of the case file.
TEST(Reference, HoldsTheParametersOfThePaper) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  const std::map<std::string, double> paper{
      {"pad.stiffness", 1300},        {"pad.damping", 45},         {"track.sleeper_spacing", 0.6},
      {"ballast.stiffness", 45},      {"ballast.damping", 32},     {"suspension.sprung_mass", 8000},
      {"suspension.stiffness", 1.15}, {"suspension.damping", 2.5}, {"rail.young_modulus", 210},
      {"rail.poisson_ratio", 0.3},    {"rail.density", 7800},      {"rail.yield_stress", 0.8},
      {"rail.tangent_modulus", 21},   {"motion.torque", 12450.49}, {"motion.run_up", 1},
      {"contact.friction", 0.3},      {"mesh.contact_size", 1.3},  {"mesh.far_size", 75}};
  std::map<std::string, double> fixed;
  for (const auto& parameter : reference.parameters)
    if (parameter.key != "rail.plastic") fixed[parameter.key] = std::stod(parameter.value);
  for (const auto& [key, value] : paper) EXPECT_EQ(fixed[key], value) << key;
}

TEST(Reference, AToleranceIsAShareOfTheExpectedValue) {
  const auto reference = readReference(SQUAT_SOURCE_DIR "/resources/reference/paper.json");
  for (const auto& s : reference.statements)
    if (s.name == "peak, calculated in the paper") {
      EXPECT_DOUBLE_EQ(s.low, 115 * 0.72);
      EXPECT_DOUBLE_EQ(s.high, 115 * 1.28);
      return;
    }
  FAIL() << "the statement about the peak is missing";
}

TEST(Reference, MistakesAreNamed) {
  EXPECT_THAT(refusal("{"), HasSubstr("paper.json"));
  EXPECT_THAT(refusal(R"({"schema": "other"})"), HasSubstr("not a reference file"));
  EXPECT_THAT(refusal("{}"), AllOf(HasSubstr("key 'schema' not found"), Not(HasSubstr("exception"))));
  EXPECT_THAT(refusal(R"({"schema": "squat-reference", "schema_version": 3})"), HasSubstr("newer"));
  const std::string head = R"({"section": "1", "statement": "t", "unit": "1", "reason": "r", )";
  EXPECT_EQ(refusal(with(head + R"("run": "a", "measure": "maximum", "low": 1, "high": 2})")), "accepted");
  EXPECT_THAT(refusal(with(head + R"("run": "b", "measure": "maximum", "low": 1, "high": 2})")),
              HasSubstr("statement 1: run 'b' is not listed"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "beauty", "low": 1, "high": 2})")), HasSubstr("'beauty'"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "maximum", "low": 3, "high": 2})")),
              HasSubstr("lower limit not below upper limit"));
  EXPECT_EQ(refusal(with(head + R"("run": "a", "measure": "maximum", "high": 2})")), "accepted");
  EXPECT_EQ(refusal(with(head + R"("run": "a", "measure": "quiet", "high": 2})")), "accepted") << "a name of before";
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "maximum"})")), HasSubstr("has no range"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "maximum", "tolerance": 0.1})")),
              HasSubstr("needs an expected value"));
  EXPECT_THAT(refusal(with(head + R"("run": "a", "measure": "maximum", "high": 2, "point": "roof"})")),
              HasSubstr("'roof'"));
  const std::string whole = with(head + R"("run": "a", "measure": "maximum", "high": 2})");
  const auto adding = [&](const std::string& more) { return refusal(whole.substr(0, whole.size() - 1) + more + "}"); };
  EXPECT_THAT(adding(R"(, "parameters": [{"section": "1", "statement": "t", "key": "pad.bounce", "value": "1"}])"),
              HasSubstr("parameter 1: key 'pad.bounce' is unknown"));
  EXPECT_THAT(adding(R"(, "sensitivity": {"run": "b", "keys": []})"), HasSubstr("run 'b' is not listed"));
  EXPECT_THAT(adding(R"(, "sensitivity": {"run": "a", "keys": [{"key": "pad.stiffness", "text": "t", "values": []}]})"),
              HasSubstr("has no values"));
}

}  // namespace
}  // namespace squat::statements
