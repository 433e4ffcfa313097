// squat run --json: stdout is one JSON object and nothing else, and its numbers are those of the result file.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/FilesPage.h"
#include "commands/RunReport.h"
#include "core/DurableFile.h"
#include "core/ProgramVersion.h"
#include "results/SampleResult.h"

namespace squat {
namespace {

using Json = nlohmann::json;

// Exit code of `squat WORDS`; its stdout alone.
int callForOutput(const std::string& words, const tests::TemporaryFolder& folder, std::string& output) {
  const auto path = folder / "stdout";
  const int status =
      std::system((std::string("'") + SQUAT_PROGRAM + "' " + words + " > '" + path + "' 2> /dev/null").c_str());
  output = readWholeFile(path, 1000000);
  return WEXITSTATUS(status);
}

TEST(RunReport, HasTheNumbersOfTheResultFile) {
  const tests::TemporaryFolder folder;
  const std::string words =
      "run light-defect --mesh tiny --no-figures --name dip --json -o '" + folder.path() + "/out'";
  std::string output;
  ASSERT_EQ(callForOutput(words, folder, output), 0);
  const auto report = Json::parse(output);  // throws for anything ahead of the object or behind it
  ASSERT_EQ(report.at("files").size(), 2U);
  EXPECT_EQ(report["files"][0], folder.path() + "/out/dip.h5");
  EXPECT_EQ(report["files"][1], folder.path() + "/out/dip.csv");
  const auto result = results::readResult(report["files"][0].get<std::string>());
  EXPECT_EQ(result.codeVersion, programVersion());
  EXPECT_EQ(result.commit, programCommit());
  EXPECT_EQ(report.at("commit"), result.commit);
  EXPECT_EQ(report.at("case_hash"), result.caseHash);
  EXPECT_EQ(report.at("complete"), true);
  EXPECT_EQ(report.at("stem"), "dip");
  double largest = 0;
  for (const double force : *result.signal("contact_force")) largest = std::max(largest, force);
  EXPECT_EQ(report.at("features").at("largest_contact_force"), (Json{{"value", largest}, {"unit", "N"}}));
  EXPECT_EQ(report["features"].at("peak").at("unit"), "m/s2");
  EXPECT_EQ(report["features"].size(), result.features.size());
  EXPECT_GT(result.features.size(), 20U);
  for (const auto& feature : result.features) {
    const auto& value = report["features"].at(feature.name).at("value");
    EXPECT_EQ(value.is_null(), std::isnan(feature.value)) << feature.name;
    if (!value.is_null()) {
      EXPECT_EQ(value, feature.value) << feature.name;
    }
    EXPECT_NE(feature.description, "") << feature.name;
    EXPECT_NE(feature.unit, "") << feature.name;
  }
  EXPECT_EQ(report.at("energy").size(), result.energy.size());
  FilesPage page(SQUAT_SOURCE_DIR "/resources/manual/files.md");
  EXPECT_THAT(page.notSaidOfJson("run --json", output), ::testing::IsEmpty());
  EXPECT_EQ(report["energy"].at("friction").at("value"), result.energy.at(3).values.back());
  EXPECT_GT(report.at("wall_time").at("value"), 0.0);

  ASSERT_EQ(callForOutput(words + " --resume", folder, output), 0);  // is complete: reported again, from the file
  EXPECT_EQ(Json::parse(output).at("features"), report["features"]);
  EXPECT_EQ(callForOutput(words + " --set motion.speed=0", folder, output), 2);
  EXPECT_EQ(output, "");
}

TEST(RunReport, ShortRecordsHaveNoFeaturesAndNotANumberIsNull) {
  auto result = tests::sampleResult(5);
  result.features.clear();  // as in a file of 0.2.0
  result.equilibrium[0].value = std::numeric_limits<double>::quiet_NaN();
  const auto report = Json::parse(commands::runReport(result, {}));
  EXPECT_TRUE(report.at("features").empty());
  EXPECT_TRUE(report.at("equilibrium").at("contact_force").at("value").is_null());
  EXPECT_EQ(report.at("title"), "Länge 20 mm");
}

}  // namespace
}  // namespace squat
