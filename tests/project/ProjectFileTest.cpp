// The project file: what is written is read, wherever its folder has gone, and damage is named or harmless.
#include "case/CaseDescription.h"
#include "project/ProjectFile.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "analysis/Folder.h"
#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "core/Errors.h"

namespace squat::project {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using tests::Folder;

Project everything(const std::string& folder) {
  Project project;
  project.open = {"dip \"of\" Assen", folder + "/cases/dip.toml", true, cases::writeCase(cases::defaultCase())};
  project.cases = {folder + "/cases/dip.toml", "/elsewhere/other.toml"};
  Entry run;
  run.path = folder + "/results/dip.h5";
  run.digest = "0123abcd";
  run.name = "Tiefe 0,15 – neu";
  run.named = false;
  run.overlaid = true;
  run.colour = "#0072b2";
  Entry measured;
  measured.kind = Kind::measured;
  measured.path = folder + "/measured.csv";
  measured.name = "Train 4, axle 1";
  measured.signal = "ABA links, run 2";
  measured.impact = 0.0123456789012345;
  measured.gain = 1.25;
  measured.reading.column = "ABA links";
  measured.reading.rate = 25600;
  measured.reading.speed = 27.77777777777778;
  measured.reading.delimiter = ';';
  measured.reading.decimal = ',';
  project.entries = {run, measured};
  project.current = 0;
  project.reference = 1;
  project.notes = "First line\n\tsecond: µm, \\, \"quoted\"\n";
  project.views = {"profile", "psd"};
  project.figures =
      FigureViews{{1250, "hamming", {{-0.15, 0.3}}, analysis::SpectrumScale::thirdOctaves, 2, 256, 8, "magma"}, {}};
  project.figures->ranges = {{"aba_position", {}, AxisRange{-50.5, 80, "m/s²"}},
                             {"psd", AxisRange{100, 2500, "Hz"}, AxisRange{1e-6, 0.25, "(m/s²)²/Hz"}}};
  project.runOrder = {"defect.depth", false, "mesh.preset", "Tiefe"};
  auto& records = project.records;
  records.files = {folder + "/records/day 1.csv", "/elsewhere/day 2.h5"};
  records.channels = "left, right", records.chainage = "12+300";
  records.speed = 33.3333333333333;
  records.ownVehicle = true;
  records.axles = "\"box, left\",right; a,b";
  records.labels = folder + "/labels.csv", records.events = folder + "/found/squats.json";
  records.seen = {{12345.678, "left", "severe squat"}, {-3, "right", "weld"}};
  records.digests = {"89abcdef", ""};  // the second one could not be read
  records.order = {"peak", true, "", "squat"};
  return project;
}

// What the text holds is all that a project is.
std::string written(const Project& project) { return projectText(project, "/"); }

FileError refusalOf(const std::string& text) {
  try {
    parseProject(text, "day.squat-project", "/home/somebody");
  } catch (const FileError& error) {
    return error;
  }
  ADD_FAILURE() << "was read: " << text.substr(0, 300);
  return FileError("", "", "");
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ProjectFile, whatIsWrittenIsRead) {
  const Folder folder;
  const auto project = everything(std::filesystem::path(folder.path()).parent_path().string());
  writeProject(folder.path("day.squat-project"), project);
  const auto read = readProject(folder.path("day.squat-project"));
  EXPECT_EQ(written(read), written(project));
  EXPECT_EQ(read.entries[1].impact, project.entries[1].impact);  // bit for bit
  EXPECT_EQ(read.entries[1].gain, 1.25);
  EXPECT_EQ(read.entries[1].reading.speed, project.entries[1].reading.speed);
  EXPECT_EQ(read.entries[1].reading.delimiter, ';');
  EXPECT_EQ(read.notes, project.notes);
  ASSERT_TRUE(read.figures);
  EXPECT_EQ(read.figures->settings.section->from, -0.15);
  EXPECT_EQ(read.figures->settings.spectrum, analysis::SpectrumScale::thirdOctaves);
  EXPECT_EQ(read.figures->settings.moment, 2);
  ASSERT_EQ(read.figures->ranges.size(), 2U);
  EXPECT_FALSE(read.figures->ranges[0].x);
  EXPECT_EQ(read.figures->ranges[0].y->low, -50.5);
  EXPECT_EQ(read.figures->ranges[1].figure, "psd");
  EXPECT_EQ(read.figures->ranges[1].x->high, 2500);
  EXPECT_EQ(read.figures->ranges[1].y->unit, "(m/s²)²/Hz");
  EXPECT_EQ(read.runOrder, project.runOrder);
  EXPECT_EQ(read.records.order, project.records.order);
  EXPECT_EQ(read.records.digests, project.records.digests);
  EXPECT_EQ(read.records.files, project.records.files);
  EXPECT_EQ(read.records.speed, project.records.speed);
  EXPECT_EQ(read.records.events, project.records.events);
  EXPECT_EQ(read.records.axles, project.records.axles);
  ASSERT_EQ(read.records.seen.size(), 2U);
  EXPECT_EQ(read.records.seen[0].position, 12345.678);
  EXPECT_EQ(read.records.seen[1].seenAs, "weld");
  EXPECT_EQ(folder.files(), 1U);  // nothing is left beside it
}

TEST(ProjectFile, anEmptyProjectIsRead) {
  const Folder folder;
  Project project;
  project.open.toml = cases::writeCase(cases::defaultCase());
  writeProject(folder.path("empty.squat-project"), project);
  EXPECT_EQ(written(readProject(folder.path("empty.squat-project"))), written(project));
}

TEST(ProjectFile, linksGoWithTheirFolder) {
  const Folder folder;
  const std::filesystem::path first(folder.path("first")), second(folder.path("second/place"));
  std::filesystem::create_directories(first);
  std::filesystem::create_directories(second.parent_path());
  writeProject((first / "day.squat-project").string(), everything(first.string()));
  EXPECT_THAT(folder.read("first/day.squat-project"),
              AllOf(HasSubstr("\"results/dip.h5\""), HasSubstr("\"/elsewhere/other.toml\"")));
  std::filesystem::rename(first, second);
  const auto moved = readProject((second / "day.squat-project").string());
  EXPECT_EQ(moved.entries[0].path, (second / "results/dip.h5").string());
  EXPECT_EQ(moved.open.path, (second / "cases/dip.toml").string());
  EXPECT_EQ(moved.cases[1], "/elsewhere/other.toml");
  EXPECT_EQ(moved.records.files[0], (second / "records/day 1.csv").string());
  EXPECT_EQ(moved.records.files[1], "/elsewhere/day 2.h5");
  EXPECT_EQ(moved.records.labels, (second / "labels.csv").string());
  EXPECT_EQ(moved.records.events, (second / "found/squats.json").string());
}

TEST(ProjectFile, saysWhatIsWrongAndWhere) {
  const std::string good = projectText(everything("/home/somebody"), "/home/somebody");
  ASSERT_NO_THROW(parseProject(good, "day.squat-project", "/home/somebody"));
  const auto place = [&](const std::string& from, const std::string& to) {
    return refusalOf(with(good, from, to)).location();
  };
  EXPECT_EQ(place("\"squat-project\"", "\"squat-result\""), "/schema");
  EXPECT_EQ(place("\"kind\": \"measured\"", "\"kind\": \"measurement\""), "/runs/1/kind");
  EXPECT_EQ(place("\"0123abcd\"", "\"0123abcg\""), "/runs/0/digest");
  EXPECT_EQ(place("\"#0072b2\"", "\"blue\""), "/runs/0/colour");
  EXPECT_EQ(place("\"overlaid\": true", "\"overlaid\": 1"), "/runs/0/overlaid");
  EXPECT_EQ(place("\"rate\": 25600.0", "\"rate\": -1"), "/runs/1/reading/rate");
  EXPECT_EQ(place("\"gain\": 1.25", "\"gain\": 0"), "/runs/1/gain");
  EXPECT_EQ(place("\"current\": 0", "\"current\": 1"), "/current");
  EXPECT_EQ(place("\"reference\": 1", "\"reference\": 2"), "/reference");
  EXPECT_EQ(place("\"results/dip.h5\"", "\"\""), "/runs/0/path");
  EXPECT_EQ(place("\"cutoff\": 1250.0", "\"cutoff\": \"low\""), "/figures/cutoff");
  EXPECT_THAT(refusalOf(with(good, "\"third-octaves\"", "\"sixth-octaves\"")).what(),
              AllOf(HasSubstr("/figures/scale"), HasSubstr("linear, log, dB, third-octaves")));
  EXPECT_EQ(place("\"moment\": 2", "\"moment\": -2"), "/figures/moment");
  EXPECT_EQ(place("\"segment\": 256", "\"segment\": 0"), "/figures/segment");
  EXPECT_EQ(place("\"hop\": 8", "\"hop\": 0.5"), "/figures/hop");
  EXPECT_EQ(place("\"low\": 100.0", "\"low\": \"some\""), "/figures/ranges/1/x/low");
  EXPECT_EQ(place("\"high\": 2500.0", "\"high\": null"), "/figures/ranges/1/x/high");  // as not-a-number is written
  EXPECT_EQ(place("\"high\": 2500.0", "\"high\": 100"), "/figures/ranges/1/x");
  EXPECT_THAT(refusalOf(with(good, "\"high\": 80.0", "\"high\": -60")).what(),
              AllOf(HasSubstr("/figures/ranges/0/y"), HasSubstr("low end that is not below the high one")));
  EXPECT_EQ(place("\"unit\": \"Hz\"", "\"unit\": 1"), "/figures/ranges/1/x/unit");
  EXPECT_EQ(place("\"figure\": \"psd\"", "\"tab\": \"psd\""), "/figures/ranges/1");
  EXPECT_EQ(place("\"sort\": \"defect.depth\"", "\"sort\": []"), "/run_order/sort");
  EXPECT_EQ(place("\"descending\": false", "\"descending\": 0"), "/run_order/descending");
  EXPECT_EQ(place("\"filter\": \"squat\"", "\"filter\": 1"), "/records/order/filter");
  EXPECT_EQ(place("\"89abcdef\"", "\"89abcdeg\""), "/records/digests/0");
  EXPECT_EQ(place("\"89abcdef\",", ""), "/records/digests");  // one for two files
  EXPECT_EQ(place("\"/elsewhere/day 2.h5\"", "\"\""), "/records/files/1");
  EXPECT_EQ(place("\"own_vehicle\": true", "\"own_vehicle\": 1"), "/records/own_vehicle");
  EXPECT_EQ(place("\"speed\": 33.3333333333333", "\"speed\": -1"), "/records/speed");
  EXPECT_EQ(place(R"("axles": "\"box, left\",right; a,b")", R"("axles": 1)"), "/records/axles");
  EXPECT_EQ(place("\"labels.csv\"", "\"labels\\u0000.csv\""), "/records/labels");
  EXPECT_EQ(place("\"found/squats.json\"", "[]"), "/records/events");
  EXPECT_EQ(place("\"position\": 12345.678", "\"position\": 1e13"), "/records/seen/0/position");
  EXPECT_EQ(place("\"seen_as\": \"weld\"", "\"seen_as\": 3"), "/records/seen/1/seen_as");
  EXPECT_EQ(place("\"notes\":", "\"nodes\":"), "the whole file");
  EXPECT_THAT(refusalOf(with(good, "\"notes\":", "\"nodes\":")).what(), HasSubstr("lacks the key 'notes'"));
  EXPECT_THAT(refusalOf(with(good, "[motion]", "[motoin]")).what(),
              AllOf(HasSubstr("/open_case/toml"), HasSubstr("motoin")));
  EXPECT_THAT(refusalOf(with(good, "\"schema_version\": 3", "\"schema_version\": 4")).what(),
              AllOf(HasSubstr("day.squat-project"), HasSubstr("/schema_version"), HasSubstr("use a newer one")));
  // The third line is ' "schema_version": 3,'; without its colon the number comes as a surprise, in column 20.
  EXPECT_EQ(refusalOf(with(good, "\"schema_version\": 3", "\"schema_version\"  3")).location(), "line 3, column 20");
}

// A file is of the lowest version whose readers lose nothing of it.
TEST(ProjectFile, theVersionIsThatOfWhatItHolds) {
  const auto version = [](const Project& project) {
    const std::string text = written(project);
    return text.substr(text.find("\"schema_version\": ") + 18, 1);
  };
  auto project = everything("/home/somebody");
  EXPECT_EQ(version(project), "3");
  project.records = {};  // figures and the order of tables raise nothing
  EXPECT_EQ(version(project), "2");
  project.entries[1].gain = 1;
  EXPECT_EQ(version(project), "1");
  project.figures->ranges.clear(), project.runOrder = {};
  for (const char* key : {"\"records\"", "\"ranges\"", "\"run_order\""})
    EXPECT_EQ(written(project).find(key), std::string::npos) << key;
}

TEST(ProjectFile, whatIsCutOffIsRefused) {
  const std::string good = projectText(everything("/home/somebody"), "/home/somebody");
  // All but the line break at the end is needed. Every byte near the ends, every 37th between: some hundred places.
  for (std::size_t size = 0; size + 1 < good.size(); size += size < 200 || size + 200 > good.size() ? 1 : 37)
    EXPECT_THAT(refusalOf(good.substr(0, size)).location(), HasSubstr("line "));
}

// A changed byte is found, or it has changed a text or a number to another one that a project can have.
TEST(ProjectFile, damageIsNamedOrHarmless) {
  const std::string good = projectText(everything("/home/somebody"), "/home/somebody");
  const auto caseText = good.find("\"toml\""), behind = good.find("\"cases\"");
  int refused = 0, read = 0;
  for (std::size_t at = 0; at<good.size(); at += at> caseText && at < behind ? 61 : 1)
    for (const char byte : {'\0', '"', '9', '\xff'}) {
      std::string damaged = good;
      if (damaged[at] == byte) continue;
      damaged[at] = byte;
      try {
        const auto project = parseProject(damaged, "day.squat-project", "/home/somebody");
        ASSERT_EQ(project.entries.size(), 2U);
        ++read;
      } catch (const FileError& error) {
        EXPECT_FALSE(error.location().empty()) << error.what();
        ++refused;
      }
    }
  EXPECT_GT(refused, 2 * read);  // most of the file is structure
  EXPECT_GT(read, 0);
}

TEST(ProjectFile, otherFilesAreRefused) {
  EXPECT_THAT(refusalOf("").location(), HasSubstr("line 1"));
  EXPECT_THAT(refusalOf("[]").what(), HasSubstr("not a table"));
  EXPECT_THAT(refusalOf("[1e999]").what(), HasSubstr("beyond 1.8e308"));  // the largest double; found by the fuzzer
  EXPECT_EQ(refusalOf("[1,\n 1e999]").location(), "line 2, column 2");
  EXPECT_THAT(refusalOf(std::string(1U << 20U, '[')).location(), HasSubstr("line 1"));
  const Folder folder;
  EXPECT_THROW(readProject(folder.path("none.squat-project")), FileError);
  EXPECT_THROW(readProject(folder.path()), FileError);  // a folder
}

TEST(ProjectFile, aPlaceThatCannotBeWrittenLeavesWhatIsThere) {
  const Folder folder;
  const auto path = folder.path("day.squat-project");
  writeProject(path, everything(folder.path()));
  const auto before = folder.read("day.squat-project");
  auto broken = everything(folder.path());
  broken.open.toml = "not a case";  // cannot be read back
  EXPECT_THROW(writeProject(path, broken), FileError);
  EXPECT_EQ(folder.read("day.squat-project"), before);
  EXPECT_THROW(writeProject(folder.path("missing/day.squat-project"), everything(folder.path())), FileError);
}

}  // namespace
}  // namespace squat::project
