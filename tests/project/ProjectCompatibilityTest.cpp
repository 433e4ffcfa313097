// A project file of every earlier schema version, frozen in the tree: each must go on being read. The files are made by
// hand, as the programs of their day wrote them; expected is what stands in them.
#include <gmock/gmock.h>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "core/DurableFile.h"
#include "project/ProjectFile.h"

namespace squat::project {
namespace {

using ::testing::HasSubstr;

const std::string frozen = SQUAT_SOURCE_DIR "/tests/project/frozen";

void expectTheWork(const Project& project) {
  EXPECT_EQ(project.open.name, "dip");
  EXPECT_EQ(project.open.path, frozen + "/cases/dip.toml");
  EXPECT_TRUE(project.open.modified);
  EXPECT_EQ(cases::parseUnfinishedCase(project.open.toml, "dip").motion.speed, 41);
  ASSERT_EQ(project.cases.size(), 2U);
  EXPECT_EQ(project.cases[1], "/elsewhere/other.toml");
  ASSERT_EQ(project.entries.size(), 2U);
  const Entry &run = project.entries[0], &measured = project.entries[1];
  EXPECT_EQ(run.path, frozen + "/day-runs/dip.h5");
  EXPECT_EQ(run.digest, "0123abcd");
  EXPECT_EQ(run.name, "Tiefe 0,15 – neu");
  EXPECT_FALSE(run.named);
  EXPECT_EQ(run.colour, "#0072b2");
  EXPECT_EQ(measured.kind, Kind::measured);
  EXPECT_EQ(measured.signal, "ABA links, run 2");
  EXPECT_EQ(measured.impact, 0.0123456789012345);
  EXPECT_EQ(measured.reading.speed, 27.77777777777778);
  EXPECT_EQ(measured.reading.delimiter, ';');
  EXPECT_EQ(project.current, 0);
  EXPECT_EQ(project.reference, 1);
  EXPECT_EQ(project.notes, "First line\n");
  EXPECT_EQ(project.views, (std::vector<std::string>{"profile", "psd"}));
  // What came later has the values of a new project.
  EXPECT_EQ(project.runOrder, TableOrder());
  EXPECT_TRUE(project.records.digests.empty());
  EXPECT_EQ(project.records.axles, "");
  EXPECT_EQ(project.records.order, TableOrder());
}

void expectNeitherFiguresNorRecords(const Project& project) {
  EXPECT_FALSE(project.figures);
  EXPECT_TRUE(project.records.files.empty());
}

TEST(ProjectCompatibility, Schema1) {
  const auto project = readProject(frozen + "/squat-project-1.squat-project");
  ASSERT_NO_FATAL_FAILURE(expectTheWork(project));
  expectNeitherFiguresNorRecords(project);
  EXPECT_EQ(project.entries[1].gain, 1);
  // Written again, the program of its day reads it.
  EXPECT_THAT(projectText(project, frozen), HasSubstr("\"schema_version\": 1,"));
}

TEST(ProjectCompatibility, Schema2) {
  const auto project = readProject(frozen + "/squat-project-2.squat-project");
  ASSERT_NO_FATAL_FAILURE(expectTheWork(project));
  expectNeitherFiguresNorRecords(project);
  EXPECT_EQ(project.entries[1].gain, 1.25);
  EXPECT_THAT(projectText(project, frozen), HasSubstr("\"schema_version\": 2,"));
}

TEST(ProjectCompatibility, Schema3) {
  const std::string path = frozen + "/squat-project-3.squat-project";
  const auto project = readProject(path);
  ASSERT_NO_FATAL_FAILURE(expectTheWork(project));
  ASSERT_TRUE(project.figures);
  EXPECT_EQ(project.figures->settings.cutoff, 1250);
  EXPECT_TRUE(project.figures->ranges.empty());
  EXPECT_EQ(project.records.files, (std::vector<std::string>{frozen + "/records/day 1.csv", "/elsewhere/day 2.h5"}));
  EXPECT_EQ(project.records.seen.at(1).seenAs, "weld");
  // Written again, all of it is as the program of its day wrote it.
  const auto fromCaseOn = [](const std::string& text) { return text.substr(text.find("\"open_case\"")); };
  EXPECT_THAT(projectText(project, frozen), HasSubstr("\"schema_version\": 3,"));
  EXPECT_EQ(fromCaseOn(projectText(project, frozen)), fromCaseOn(readWholeFile(path, 100000)));
}

// A project that the program of 0.2.0 has written.
TEST(ProjectCompatibility, Version020) {
  const auto project = readProject(frozen + "/version-0.2.0.squat-project");
  EXPECT_EQ(project.open.name, "dip");
  EXPECT_EQ(project.open.path, frozen + "/dip.toml");
  EXPECT_TRUE(project.open.modified);
  EXPECT_NO_THROW(cases::parseUnfinishedCase(project.open.toml, "dip"));
  ASSERT_EQ(project.entries.size(), 2U);
  EXPECT_EQ(project.entries[0].path, "/elsewhere/dip.h5");
  EXPECT_EQ(project.entries[1].kind, Kind::measured);
  EXPECT_EQ(project.entries[1].path, frozen + "/measured.csv");
  EXPECT_EQ(project.entries[1].digest, "0123abcd");
  EXPECT_EQ(project.entries[1].gain, 1.25);
  EXPECT_EQ(project.reference, 1);
  EXPECT_EQ(project.notes, "a note\n");
  EXPECT_EQ(project.views, (std::vector<std::string>{"psd"}));
}

}  // namespace
}  // namespace squat::project
