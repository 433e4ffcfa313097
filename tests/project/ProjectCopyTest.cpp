// A project that is copied with its data: all of it is there on another machine, and a copy that does not come to its
// end leaves nothing.
#include "case/CaseDescription.h"
#include "project/ProjectCopy.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>

#include "analysis/Folder.h"
#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "core/Errors.h"
#include "core/platform/FileLock.h"
#include "project/FileDigest.h"
#include "project/ProjectFile.h"

namespace squat::project {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::Folder;

const std::string profile = "position [mm],height [mm]\n-20,0\n0,-0.15\n20,0\n";

std::string caseWith(const std::string& file) {
  return "schema = 1\n[defect]\nshape = \"profile\"\nfile = \"" + file + "\"  # drawn by hand\n";
}

// Counts what is reported; stops at the report with this number.
struct Watch : Monitor {
  int stopAt = 0, reports = 0;
  std::function<void()> look;
  void report(const Progress& progress) override {
    EXPECT_GE(progress.fraction, 0);
    EXPECT_LE(progress.fraction, 1);
    ++reports;
    if (look) look();
  }
  bool cancelled() override { return stopAt > 0 && reports >= stopAt; }
};

class CopiedProject : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) const {
    fs::create_directories(fs::path(folder_.path(name)).parent_path());
    folder_.write(name, content);
  }
  // Two runs, a measured signal and a label file of one name each, a passage that is laid over a run, two cases with
  // profiles in other places, records with their list of events. What is in results and records does not matter here.
  Project everything() const {
    write("here/a/dip.h5", std::string(8000000, 'a'));  // more than is copied at once
    write("here/b/dip.h5", std::string("b\0\xff", 3));
    write("here/signals/table.csv", "a signal");
    write("here/records/table.csv", "a record");
    write("here/found/squats.json", "events");
    write("here/found/squats.csv", "the same");
    write("here/found/passages/squat-0001.csv", "a passage");
    write("here/found/passages/squat-0002.csv", "another");
    write("here/found/overview.png", "a picture");
    write("here/profiles/drawn.csv", profile);
    write("here/cases/dip.toml", caseWith("../profiles/drawn.csv"));
    write("far/drawn.csv", profile);
    write("here/cases/other.toml", caseWith(folder_.path("far/drawn.csv")));
    Project project;
    const auto description = cases::readCase(folder_.path("here/cases/other.toml"));
    project.open = {"other", folder_.path("here/cases/other.toml"), false, cases::writeCase(description)};
    project.cases = {project.open.path, folder_.path("here/cases/dip.toml")};
    project.entries.resize(4);
    const char* files[] = {"here/a/dip.h5", "here/b/dip.h5", "here/signals/table.csv",
                           "here/found/passages/squat-0001.csv"};
    for (std::size_t i = 0; i < 4; ++i) {
      project.entries[i].path = folder_.path(files[i]);
      if (i >= 2) project.entries[i].kind = Kind::measured;
    }
    project.records.files = {folder_.path("here/records/table.csv")};
    project.records.digests = {fileDigest(project.records.files[0])};
    project.records.labels = folder_.path("here/found/squats.csv");  // corrected by hand
    project.records.events = folder_.path("here/found/squats.json");
    project.current = 0;
    project.notes = "a note\n";
    return project;
  }
  std::string target() const { return folder_.path("stick/copy.squat-project"); }
  std::vector<std::string> namesIn(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(folder_.path(name))) names.push_back(each.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
  void SetUp() override { fs::create_directories(folder_.path("stick")); }

  Folder folder_;
};

std::string contentOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(CopiedProject, isWholeOnAnotherMachine) {
  const auto project = everything();
  Watch watch;
  watch.look = [this] {  // nothing has its name before all is there
    EXPECT_FALSE(fs::exists(target()));
    EXPECT_FALSE(fs::exists(dataFolder(target())));
  };
  const auto copy = copyWithData(project, target(), watch);
  EXPECT_TRUE(copy.complete);
  EXPECT_THAT(copy.problems, IsEmpty());
  EXPECT_EQ(copy.files, 12U);
  EXPECT_GT(watch.reports, 12);
  EXPECT_THAT(namesIn("stick"), ElementsAre("copy.data", "copy.squat-project"));
  // Another machine: another folder, and nothing else.
  std::vector<std::string> before;
  for (const auto& entry : project.entries) before.push_back(contentOf(entry.path));
  const auto hash = cases::caseHash(cases::readCase(project.cases[1]));
  fs::remove_all(folder_.path("here"));
  fs::remove_all(folder_.path("far"));
  fs::rename(folder_.path("stick"), folder_.path("there"));
  const auto moved = readProject(folder_.path("there/copy.squat-project"));
  const std::string data = folder_.path("there/copy.data");
  ASSERT_EQ(moved.entries.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(contentOf(moved.entries[i].path), before[i]) << moved.entries[i].path;
  EXPECT_EQ(moved.entries[0].path, data + "/runs/dip.h5");
  EXPECT_EQ(moved.entries[1].path, data + "/runs/2/dip.h5");
  EXPECT_EQ(moved.entries[3].path, data + "/events/passages/squat-0001.csv");
  EXPECT_EQ(contentOf(moved.records.files.at(0)), "a record");
  EXPECT_EQ(moved.records.digests.at(0), fileDigest(moved.records.files.at(0)));  // it has not changed
  EXPECT_EQ(contentOf(moved.records.events), "events");
  EXPECT_EQ(contentOf(moved.records.labels), "the same");
  EXPECT_EQ(contentOf(data + "/events/passages/squat-0002.csv"), "another");
  EXPECT_FALSE(fs::exists(data + "/events/overview.png"));  // nothing links to it
  EXPECT_EQ(moved.notes, "a note\n");
  // Cases find their profiles: one beside its folder, one that was named by its full path.
  EXPECT_EQ(contentOf(moved.cases.at(1)), caseWith("../profiles/drawn.csv"));
  EXPECT_EQ(cases::caseHash(cases::readCase(moved.cases.at(1))), hash);
  EXPECT_EQ(moved.cases.at(0), moved.open.path);
  EXPECT_EQ(contentOf(moved.open.path), caseWith("drawn.csv"));
  EXPECT_EQ(cases::writeCase(cases::readCase(moved.open.path)), moved.open.toml);  // as the studio compares them
}

// A case of two rails names a profile of each: both come along, beside the case or by their full paths.
TEST_F(CopiedProject, takesAlongTheProfileOfTheRightRail) {
  const auto twoRails = [](const std::string& left, const std::string& right) {
    return caseWith(left) + "[model]\nextent = \"whole\"\n[right.defect]\nfile = \"" + right + "\"\n";
  };
  write("here/left.csv", profile), write("here/right.csv", "position [mm],height [mm]\n-30,0\n0,-0.2\n30,0\n");
  write("here/beside.toml", twoRails("left.csv", "right.csv"));
  write("far/both.csv", profile);
  write("here/far.toml", twoRails(folder_.path("far/both.csv"), folder_.path("far/both.csv")));
  Project project;
  project.cases = {folder_.path("here/beside.toml"), folder_.path("here/far.toml")};
  std::vector<std::string> hashes;
  for (const auto& path : project.cases) hashes.push_back(cases::caseHash(cases::readCase(path)));
  Watch watch;
  EXPECT_THAT(copyWithData(project, target(), watch).problems, IsEmpty());
  fs::remove_all(folder_.path("here")), fs::remove_all(folder_.path("far"));
  const auto copy = readProject(target());
  ASSERT_EQ(copy.cases.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(cases::caseHash(cases::readCase(copy.cases[i])), hashes[i]);
}

TEST_F(CopiedProject, saysWhatIsMissingAndKeepsItsLink) {
  auto project = everything();
  fs::remove(project.entries[1].path);
  fs::remove(project.records.files[0]);
  ASSERT_EQ(::mkfifo(project.records.files[0].c_str(), 0600), 0);  // no file, and nothing to wait for
  Monitor nobody;
  const auto copy = copyWithData(project, target(), nobody);
  EXPECT_TRUE(copy.complete);
  EXPECT_THAT(copy.problems, ElementsAre(HasSubstr("here/b/dip.h5"), HasSubstr("here/records/table.csv")));
  const auto read = readProject(target());
  EXPECT_EQ(read.entries[1].path, project.entries[1].path);
  EXPECT_EQ(read.records.files, project.records.files);
  EXPECT_EQ(read.records.digests, project.records.digests);
  EXPECT_EQ(contentOf(read.entries[0].path), std::string(8000000, 'a'));
}

TEST_F(CopiedProject, withoutFilesIsAFile) {
  Project project;
  project.open.toml = cases::writeCase(cases::defaultCase());
  Monitor nobody;
  EXPECT_TRUE(copyWithData(project, target(), nobody).complete);
  EXPECT_THAT(namesIn("stick"), ElementsAre("copy.squat-project"));
}

TEST_F(CopiedProject, thatIsCancelledLeavesNothing) {
  const auto project = everything();
  folder_.write("stick/copy.squat-project", "an earlier one");
  for (const int report : {1, 2, 10, 11}) {  // the last two in the middle of the first result
    Watch watch;
    watch.stopAt = report;
    const auto copy = copyWithData(project, target(), watch);
    EXPECT_FALSE(copy.complete);
    EXPECT_THAT(namesIn("stick"), ElementsAre("copy.squat-project"));
  }
  EXPECT_EQ(folder_.read("stick/copy.squat-project"), "an earlier one");
}

// In a process of its own; returns what it threw.
std::string inChild(const std::function<void()>& work) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    std::string text = "no error";
    try {
      work();
    } catch (const std::exception& error) {
      text = error.what();
    }
    const bool sent = ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::_exit(sent ? 0 : 1);
  }
  ::close(ends[1]);
  std::string text(4096, '\0');
  const auto size = ::read(ends[0], text.data(), text.size());
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? "died of signal " + std::to_string(WTERMSIG(status)) : text;
}

// Files of a megabyte at most: the first result does not fit.
TEST_F(CopiedProject, onAFullDiskIsReportedAndLeavesNothing) {
  const auto project = everything();
  folder_.write("stick/copy.squat-project", "an earlier one");
  const auto text = inChild([&] {
    const rlimit limit{1000000, 1000000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Monitor nobody;
    copyWithData(project, target(), nobody);
  });
  EXPECT_THAT(text, HasSubstr("copy.data/runs/dip.h5"));
  EXPECT_THAT(text, HasSubstr("cannot be written"));
  EXPECT_THAT(namesIn("stick"), ElementsAre("copy.squat-project"));
  EXPECT_EQ(folder_.read("stick/copy.squat-project"), "an earlier one");
}

TEST_F(CopiedProject, thatIsKilledHasNoNameAndGoesWithTheNextOne) {
  const auto project = everything();
  const auto text = inChild([&] {
    Watch watch;
    watch.look = [&] {
      if (watch.reports == 10) ::raise(SIGKILL);
    };
    copyWithData(project, target(), watch);
  });
  EXPECT_EQ(text, "died of signal 9");
  EXPECT_FALSE(fs::exists(target()));
  EXPECT_FALSE(fs::exists(dataFolder(target())));
  Monitor nobody;
  EXPECT_TRUE(copyWithData(project, target(), nobody).complete);
  EXPECT_THAT(namesIn("stick"), ElementsAre("copy.data", "copy.squat-project"));
}

TEST_F(CopiedProject, replacesNoDataAndNoOpenProject) {
  const auto project = everything();
  Monitor nobody;
  const auto refusal = [&] {
    try {
      copyWithData(project, target(), nobody);
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  write("stick/copy.data/letter.txt", "mine");
  EXPECT_THAT(refusal(), HasSubstr("copy.data"));
  EXPECT_EQ(folder_.read("stick/copy.data/letter.txt"), "mine");
  fs::remove_all(folder_.path("stick/copy.data"));
  {
    platform::FileLock window(folder_.path("stick/.copy.squat-project.lock"));
    window.write("squat-studio (process 7)");
    EXPECT_THAT(refusal(), HasSubstr("squat-studio (process 7)"));
  }
  EXPECT_THAT(namesIn("stick"), IsEmpty());
  EXPECT_THROW(copyWithData(project, folder_.path("none/copy.squat-project"), nobody), FileError);
  EXPECT_FALSE(fs::exists(folder_.path("none")));
}

// What would be one name on a memory stick gets two.
TEST_F(CopiedProject, namesThatDifferByTheirCaseAreKeptApart) {
  Project project;
  project.open.toml = cases::writeCase(cases::defaultCase());
  project.entries.resize(2);
  write("here/dip.h5", "small"), write("here/Dip.h5", "large");
  project.entries[0].path = folder_.path("here/dip.h5"), project.entries[1].path = folder_.path("here/Dip.h5");
  Monitor nobody;
  copyWithData(project, target(), nobody);
  const auto read = readProject(target());
  EXPECT_EQ(read.entries[1].path, dataFolder(target()) + "/runs/2/Dip.h5");
  EXPECT_EQ(contentOf(read.entries[1].path), "large");
}

}  // namespace
}  // namespace squat::project
