#include "case/CaseDescription.h"
#include "core/DurableFile.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "core/Errors.h"
#include "results/Checkpoint.h"
#include "results/ResultFile.h"
#include "results/SampleResult.h"

namespace squat::results {
namespace {

using ::testing::HasSubstr;
using tests::TemporaryFolder;

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

int filesIn(const std::string& folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
  return count;
}

template <typename Work>
std::string errorOf(const Work& work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

// `work` in a child process, so that limits and another user do not stay: its error text, or how the child died.
template <typename Work>
std::string inChild(const Work& work) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    const auto text = errorOf(work);
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

void limitFileSize(rlim_t bytes) {
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(DurableFile, ReplacesAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  writeDurably(folder / "a.txt", "first");
  writeDurably(folder / "a.txt", "second");
  EXPECT_EQ(contents(folder / "a.txt"), "second");
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(DurableFile, AFailedVerificationKeepsTheEarlierFile) {
  const TemporaryFolder folder;
  writeDurably(folder / "a.txt", "first");
  const std::string text = "second";
  const auto verify = [](const std::string& part) { throw FileError(part, "", "bad"); };
  EXPECT_THROW(writeDurably(folder / "a.txt", std::as_bytes(std::span(text)), verify), FileError);
  EXPECT_EQ(contents(folder / "a.txt"), "first");
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(DurableFile, AFullDiskIsReportedWithPathAndBytesAndHarmsNothing) {
  const TemporaryFolder folder;
  const auto path = folder / "sample.h5";
  writeResult(path, tests::sampleResult());
  const auto before = contents(path);
  const auto text = inChild([&] {
    limitFileSize(1000);
    writeResult(path, tests::sampleResult(500));
  });
  EXPECT_THAT(text, HasSubstr(path));
  EXPECT_THAT(text, HasSubstr("bytes needed"));
  EXPECT_THAT(text, HasSubstr("free"));
  EXPECT_EQ(contents(path), before);
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(DurableFile, AFullDiskKeepsTheEarlierCheckpoint) {
  const TemporaryFolder folder;
  ArrayTree state;
  state.add("/state/displacement", std::vector<double>(1000, 0.5), "m");
  writeCheckpoint(folder / "run.checkpoint", state);
  const auto text = inChild([&] {
    limitFileSize(4000);
    writeCheckpoint(folder / "run.checkpoint", state);
  });
  EXPECT_THAT(text, HasSubstr("bytes needed"));
  const auto back = readCheckpoint(folder / "run.checkpoint");
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(valueCount(back->find("/state/displacement")->values), 1000U);
}

TEST(DurableFile, AFullDiskKeepsTheEarlierCase) {
  const TemporaryFolder folder;
  const auto path = folder / "case.toml";
  cases::saveCase(cases::defaultCase(), path);
  const auto before = contents(path);
  const auto text = inChild([&] {
    limitFileSize(1000);
    cases::saveCase(cases::defaultCase(), path);
  });
  EXPECT_THAT(text, HasSubstr("case.toml: cannot be written"));
  EXPECT_THAT(text, HasSubstr("bytes needed"));
  EXPECT_EQ(contents(path), before);
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(DurableFile, AReadOnlyFolderIsReported) {
  const TemporaryFolder folder;
  writeDurably(folder / "a.txt", "first");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  const auto text = inChild([&] {
    if (::geteuid() == 0 && ::seteuid(65534) != 0) return;  // root may write anywhere
    writeDurably(folder / "a.txt", "second");
  });
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_THAT(text, HasSubstr("a.txt: cannot be written: Permission denied"));
  EXPECT_EQ(contents(folder / "a.txt"), "first");
}

TEST(DurableFile, AVanishedFolderIsReported) {
  const TemporaryFolder folder;
  const auto text = errorOf([&] { writeDurably(folder / "gone/a.txt", "text"); });
  EXPECT_THAT(text, HasSubstr("gone/a.txt: cannot be written: No such file or directory"));
}

TEST(DurableFile, SweepsWhatADeadProcessLeft) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);  // now a process number that is free
  std::ofstream(folder / ("a.txt.part-" + std::to_string(child))) << "half";
  std::ofstream(folder / ("a.txt.part-" + std::to_string(::getppid()))) << "someone else is at work";
  std::ofstream(folder / "a.txt.part-notes") << "not ours";
  writeDurably(folder / "a.txt", "whole");
  EXPECT_EQ(filesIn(folder.path()), 3);
  EXPECT_FALSE(std::filesystem::exists(folder / ("a.txt.part-" + std::to_string(child))));
}

TEST(DurableFile, WholeFileReadsRefusePipesAndGiants) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(errorOf([&] { readWholeFile(folder / "pipe", 100); }), HasSubstr("not a regular file"));
  writeDurably(folder / "a.txt", std::string(101, 'x'));
  EXPECT_THAT(errorOf([&] { readWholeFile(folder / "a.txt", 100); }), HasSubstr("larger than the 100 bytes"));
  EXPECT_EQ(readWholeFile(folder / "a.txt", 101).size(), 101U);
}

TEST(DurableFile, FolderThatIsAFileIsReported) {
  const TemporaryFolder folder;
  writeDurably(folder / "a.txt", "text");
  EXPECT_THAT(errorOf([&] { makeFolder(folder / "a.txt"); }), HasSubstr("a.txt"));
  makeFolder(folder / "deep/er");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "deep/er"));
}

}  // namespace
}  // namespace squat::results
