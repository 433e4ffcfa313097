// Parameters files in Dakota's two formats and the answers to them. The files are made by hand, from memory of Dakota's
// manual: the program itself was not at hand.
#include "studies/EvaluationFiles.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"

namespace squat::studies {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

const std::string kStandard = R"(                                          3 variables
                      1.500000000000000e-01 defect.depth
                      8.000000000000000e+02 pad__stiffness
                                  parabolic defect.lateral
                                          2 functions
                                          1 ASV_1:peak
                                          1 ASV_2:largest_contact_force
                                          2 derivative_variables
                                          1 DVV_1:defect.depth
                                          2 DVV_2:pad__stiffness
                                          0 analysis_components
                                          1 eval_id
)";
const std::string kAprepro = R"(                    { DAKOTA_VARS = 2 }
                    { defect__depth = 1.500000000000000e-01 }
                    { right__defect__lateral = "parabolic" }
                    { DAKOTA_FNS = 1 }
                    { ASV_1:peak = 1 }
                    { DAKOTA_DER_VARS = 0 }
                    { DAKOTA_AN_COMPS = 0 }
                    { DAKOTA_EVAL_ID = 1 }
)";

class EvaluationFiles : public ::testing::Test {
 protected:
  EvaluationRequest read(const std::string& text) const {
    writeDurably(folder_ / "params.in", std::string_view(text));
    return readRequest(folder_ / "params.in");
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const FileError& error) {
      return error.what();
    }
    return "accepted";
  }
  const TemporaryFolder folder_;
};

TEST_F(EvaluationFiles, bothFormsAreRead) {
  const auto standard = read(kStandard);
  EXPECT_THAT(standard.values,
              ElementsAre(Pair("defect.depth", "1.500000000000000e-01"), Pair("pad.stiffness", "8.000000000000000e+02"),
                          Pair("defect.lateral", "parabolic")));
  EXPECT_THAT(standard.features, ElementsAre("peak", "largest_contact_force"));
  const auto aprepro = read(kAprepro);
  EXPECT_THAT(aprepro.values,
              ElementsAre(Pair("defect.depth", "1.500000000000000e-01"), Pair("right.defect.lateral", "parabolic")));
  EXPECT_THAT(aprepro.features, ElementsAre("peak"));
}

TEST_F(EvaluationFiles, whatIsNoneIsNamed) {
  EXPECT_THAT(refusal(""), HasSubstr("how many variables"));
  EXPECT_THAT(refusal("x variables\n"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("2 variables\n1 a\n"), HasSubstr("cut off"));
  EXPECT_THAT(refusal("1 variables\n1 a\n2 functions\n1 ASV_1:f\n"), HasSubstr("cut off"));
  EXPECT_THAT(refusal("1 variables\n1\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("1 variables\n1 a\n1 functions\n3 ASV_1:f\n"), HasSubstr("derivatives"));
  EXPECT_THAT(refusal("{ DAKOTA_VARS = 1 }\n{ broken\n"), HasSubstr("line 2"));
}

TEST(EvaluationAnswer, namesAreWordsOrWhole) {
  const FeatureRow row{
      {"peak [m/s2]", 97.988}, {"peak 2 frequency [Hz]", std::nan("")}, {"wavelength, mean [m]", 0.03}};
  EXPECT_EQ(answerText(row, {"peak", "wavelength_mean"}),
            "9.7988000000000000e+01 peak\n2.9999999999999999e-02 wavelength_mean\n");
  EXPECT_EQ(answerText(row, {"peak [m/s2]"}), "9.7988000000000000e+01 peak\n");
  EXPECT_THROW(answerText(row, {"peak_2_frequency"}), RunError);
  try {
    answerText(row, {"peek"});
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--features is peek, must be one of peak, peak_2_frequency, wavelength_mean"));
  }
}

}  // namespace
}  // namespace squat::studies
