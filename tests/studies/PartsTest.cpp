// A study in parts: by several processes in one folder, and put together again.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/SampleResult.h"
#include "studies/CollectParts.h"
#include "studies/StubStudy.h"
#include "studies/StudyIdentity.h"

namespace squat::studies {
namespace {

using squat::tests::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string read(const std::string& path) { return readWholeFile(path, 100000000); }

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const CaseError& error) {
    return std::string("call: ") + error.what();
  } catch (const FileError& error) {
    return std::string("file: ") + error.what();
  }
  return "accepted";
}

// Names and bytes of everything in a folder.
std::map<std::string, std::string> contentOf(const std::string& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    content[entry.path().filename().string()] = read(entry.path().string());
  return content;
}

class Parts : public ::testing::Test {
 protected:
  void runPart(const StudyDefinition& study, const std::string& part, const StudyRunner& run = stubRun) {
    runStudy(study, run, partOptions(folder_ / "parts", part), monitor_);
  }
  std::string parts() const { return folder_ / "parts"; }
  const TemporaryFolder folder_;
  const StudyDefinition study_ = stubStudy(3, 3);
  Monitor monitor_;
};

TEST_F(Parts, collectedAreTheBytesOfOneProcess) {
  runStudy(study_, stubRun, {folder_ / "whole", 1, false}, monitor_);
  for (const auto* kind : {"slice:", "hash:"}) {
    for (const auto* part : {"3/4", "1/4", "4/4", "2/4"}) runPart(study_, std::string(kind) + part);
    const auto table = writeCollected(study_, parts());
    EXPECT_EQ(table.count(RowState::done), 8U);
    EXPECT_EQ(table.count(RowState::failed), 1U);
    EXPECT_EQ(read(parts() + "/study.csv"), read(folder_ / "whole" + "/study.csv"));
    EXPECT_EQ(read(parts() + "/study.json"), read(folder_ / "whole" + "/study.json"));
    const auto once = contentOf(parts());
    writeCollected(study_, parts());
    EXPECT_EQ(contentOf(parts()), once) << "collected again";
    std::filesystem::remove_all(parts());
  }
}

TEST_F(Parts, whatIsMissingIsNamedByPart) {
  EXPECT_THAT(refusal([&] { writeCollected(study_, parts()); }), HasSubstr("no part of a study was started"));
  runPart(study_, "slice:1/4");
  struct Impatient : Monitor {
    bool cancelled() override { return ended >= 1; }
    void message(const std::string&) override { ++ended; }
    int ended = 0;
  } impatient;
  runStudy(study_, stubRun, partOptions(parts(), "slice:2/4"), impatient);
  const auto before = contentOf(parts());
  EXPECT_THAT(refusal([&] { writeCollected(study_, parts()); }),
              AllOf(HasSubstr("file: "), HasSubstr("5 of 9 points are missing"),
                    HasSubstr("part slice:2/4: 1 point (defect.length=40, defect.depth=0.3)"),
                    HasSubstr("part slice:3/4 was not started: 2 points")));
  EXPECT_EQ(contentOf(parts()), before);
  const auto collected = collectParts(study_, parts());
  EXPECT_TRUE(collected.parts[0].isComplete());
  EXPECT_FALSE(collected.parts[3].hasStarted);
}

TEST_F(Parts, wrongCallsAreNamedAndNothingIsOverwritten) {
  runPart(study_, "slice:1/4");
  auto otherCase = study_, otherValues = stubStudy(3, 4), otherVersion = study_;
  otherCase.caseHash = "87654321";
  otherVersion.program = "1.1";
  const auto before = contentOf(parts());
  for (const bool isCollecting : {false, true}) {
    const auto call = [&](const StudyDefinition& study) {
      return refusal(
          [&] { isCollecting ? static_cast<void>(writeCollected(study, parts())) : runPart(study, "slice:2/4"); });
    };
    EXPECT_THAT(call(otherCase), AllOf(HasSubstr("call: "), HasSubstr("another study")));
    EXPECT_THAT(call(otherValues), AllOf(HasSubstr("call: "), HasSubstr("another study")));
    EXPECT_THAT(call(otherVersion), AllOf(HasSubstr("call: "), HasSubstr("of version 1.0"), HasSubstr("(1.1)")));
  }
  EXPECT_THAT(refusal([&] { runPart(study_, "slice:2/5"); }), HasSubstr("computed twice"));
  EXPECT_THAT(refusal([&] { runPart(study_, "hash:2/4"); }), HasSubstr("computed twice"));
  EXPECT_THAT(refusal([&] { runStudy(study_, stubRun, {parts(), 1, false}, monitor_); }), HasSubstr("--collect"));
  EXPECT_EQ(contentOf(parts()), before);
  runStudy(study_, stubRun, {folder_ / "whole", 1, false}, monitor_);
  EXPECT_THAT(refusal([&] { runStudy(study_, stubRun, partOptions(folder_ / "whole", "slice:1/2"), monitor_); }),
              HasSubstr("one process"));
}

// As another user where the test is run by root, to whom every folder is open.
TEST_F(Parts, aFolderThatMayNotBeWrittenIsNamed) {
  for (const int part : {1, 2, 3, 4}) runPart(study_, "slice:" + std::to_string(part) + "/4");
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
  std::filesystem::permissions(parts(), std::filesystem::perms(0555));
  const auto before = contentOf(parts());
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(9);
    const auto part = refusal([&] { runPart(study_, "slice:1/4"); });
    const auto all = refusal([&] { writeCollected(study_, parts()); });
    const auto isNamed = [](const std::string& text) {
      return text.starts_with("file: ") && text.find("cannot be written: Permission denied") != std::string::npos;
    };
    ::_exit(isNamed(part) && isNamed(all) ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  std::filesystem::permissions(parts(), std::filesystem::perms::owner_all);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(contentOf(parts()), before);
}

TEST_F(Parts, aStudyGrowsByHash) {
  const auto small = stubStudy(3, 2), large = stubStudy(5, 2);  // 20, 40, 60 are among 20, 30, ..., 60
  int runs = 0;
  const StudyRunner counted = [&](const StudyPoint& point, Monitor& monitor) {
    ++runs;
    return stubRun(point, monitor);
  };
  for (const auto* part : {"hash:1/2", "hash:2/2"}) runPart(small, part, counted);
  writeCollected(small, parts());
  EXPECT_EQ(runs, 6);
  runPart(large, "hash:1/2", counted);
  EXPECT_THAT(refusal([&] { runPart(small, "hash:2/2"); }), HasSubstr("another study"));
  runPart(large, "hash:2/2", counted);
  EXPECT_EQ(runs, 10);
  writeCollected(large, parts());
  runStudy(large, stubRun, {folder_ / "whole", 1, false}, monitor_);
  EXPECT_EQ(read(parts() + "/study.csv"), read(folder_ / "whole" + "/study.csv"));
  auto longer = stubStudy(9, 2), before = large;
  before.start = "zone 0.03:0.03", longer.start = "zone 0.05:0.05";
  const TemporaryFolder other;
  runStudy(before, stubRun, partOptions(other / "a", "hash:1/2"), monitor_);
  EXPECT_THAT(refusal([&] { runStudy(longer, stubRun, partOptions(other / "a", "hash:1/2"), monitor_); }),
              HasSubstr("another mesh"));
}

TEST_F(Parts, aKilledPartResumes) {
  const pid_t child = ::fork();
  if (child == 0) {
    int runs = 0;
    runPart(study_, "slice:1/2", [&](const StudyPoint& point, Monitor& monitor) {
      if (++runs == 4) ::raise(SIGKILL);
      return stubRun(point, monitor);
    });
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  // The clocks of machines differ: a day ahead and a day behind.
  const auto now = std::filesystem::file_time_type::clock::now();
  std::filesystem::last_write_time(parts() + "/study-slice-1-of-2.csv", now + std::chrono::hours(24));
  std::filesystem::last_write_time(parts() + "/study-slice-1-of-2.lock", now - std::chrono::hours(24));
  int runs = 0;
  runPart(study_, "slice:1/2", [&](const StudyPoint& point, Monitor& monitor) {
    ++runs;
    return stubRun(point, monitor);
  });
  EXPECT_EQ(runs, 2) << "five points, three of them done";
  EXPECT_EQ(collectParts(study_, parts()).missing(), 4U);
}

// Sixteen processes and six more on parts that have one already. Each run leaves a file that must be new; runs wait
// until the six have been refused.
TEST_F(Parts, sixteenAtOnceSomeOfThemTwice) {
  const auto study = stubStudy(20, 8);
  makeFolder(folder_ / "ran");
  const StudyRunner marked = [&](const StudyPoint& point, Monitor& monitor) {
    while (!std::filesystem::exists(folder_ / "go")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const auto path = folder_ / "ran" + "/" + std::to_string(point.index);
    const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0600);
    if (file < 0) throw RunError("computed twice", 0, 0, path);
    ::close(file);
    return stubRun(point, monitor);
  };
  for (int i = 0; i < 22; ++i) {
    if (::fork() != 0) continue;
    const auto outcome = refusal([&] { runPart(study, "slice:" + std::to_string(i % 16 + 1) + "/16", marked); });
    const bool isReported = outcome.find("computed by squat study --partition") != std::string::npos;
    ::_exit(outcome == "accepted" ? 0 : isReported ? 2 : 1);
  }
  int refused = 0, looks = 0;
  for (int ended = 0; ended < 22;) {
    int status = 0;
    if (::waitpid(-1, &status, WNOHANG) > 0) {
      ++ended;
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != 1);
      refused += WIFEXITED(status) && WEXITSTATUS(status) == 2;
      if (refused == 6) writeDurably(folder_ / "go", std::string_view("go"));
    }
    // A torn table is a FileError.
    if (std::filesystem::exists(parts() + "/study-parts.json")) {
      EXPECT_NO_THROW(collectParts(study, parts()));
      ++looks;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(refused, 6);
  EXPECT_GT(looks, 10);
  const auto table = writeCollected(study, parts());
  EXPECT_EQ(table.count(RowState::failed), 0U) << "one computed twice";  // 40, 0.2 is no point of this grid
  EXPECT_EQ(table.count(RowState::done), 160U);
}

}  // namespace
}  // namespace squat::studies
