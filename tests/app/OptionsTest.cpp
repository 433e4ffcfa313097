// Options as they reach a command.
#include <gmock/gmock.h>

#include <algorithm>
#include <thread>

#include "commands/CaseOptions.h"
#include "commands/ComputeOptions.h"
#include "commands/ExitCodes.h"
#include "commands/FigureNames.h"
#include "commands/Program.h"

namespace squat::commands {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(FigureNames, CountOnce) {
  CLI::App app;
  NamedFigures named;
  addFigureNames(app, named);
  app.parse("--figures psd,aba,psd --format png,png --figures aba");
  EXPECT_THAT(named.figures, ElementsAre("psd", "aba"));
  EXPECT_THAT(named.formats, ElementsAre("png"));
}

TEST(FigureSize, IsWidthByHeightInMillimetresAndDotsPerInch) {
  const auto taken = [](const std::string& words) {
    CLI::App app;
    plots::PrintedSize size;
    addFigureSize(app, size);
    app.parse(words);
    return size;
  };
  EXPECT_EQ(taken("").width, 0);
  EXPECT_EQ(taken("").resolution, 300);
  const auto size = taken("--figure-size 120.5x80 --dpi 600");
  EXPECT_EQ(size.width, 120.5);
  EXPECT_EQ(size.height, 80);
  EXPECT_EQ(size.resolution, 600);
  for (const std::string wrong :
       {"85", "85x", "x60", "85x60mm", "79x60", "85x54", "85x401", "-85x60", "nanx60", "85*60"})
    EXPECT_THROW(taken("--figure-size " + wrong), CLI::ParseError) << wrong;
  for (const std::string wrong : {"49", "1201", "nan"}) EXPECT_THROW(taken("--dpi " + wrong), CLI::ParseError) << wrong;
}

TEST(Spectrum, IsOneOfFourScalesInAnyCase) {
  const auto taken = [](const std::string& words) {
    CLI::App app;
    NamedFigures named;
    addFigureNames(app, named);
    app.parse(words);
    return named.settings.spectrum;
  };
  EXPECT_EQ(taken(""), analysis::SpectrumScale::linear);
  EXPECT_EQ(taken("--spectrum linear"), analysis::SpectrumScale::linear);
  EXPECT_EQ(taken("--spectrum log"), analysis::SpectrumScale::logarithmic);
  EXPECT_EQ(taken("--spectrum db"), analysis::SpectrumScale::decibel);
  EXPECT_EQ(taken("--spectrum Third-Octaves"), analysis::SpectrumScale::thirdOctaves);
  for (const std::string wrong : {"d", "decibel", "third", "0"})
    EXPECT_THROW(taken("--spectrum " + wrong), CLI::ParseError) << wrong;
}

TEST(Name, IsThatOfTheCaseWhereNoneIsGiven) {
  const auto stem = [](std::vector<std::string> words) {
    CLI::App app;
    CaseOptions options;
    options.name = "cases/dip.toml";
    addName(app, options);
    std::reverse(words.begin(), words.end());  // as the parser takes them
    app.parse(words);
    return stemOf(options);
  };
  EXPECT_EQ(stem({}), "dip");
  EXPECT_EQ(stem({"--name", "Assen km 12.3"}), "Assen km 12.3");
  for (const std::string wrong : {"", ".", "..", ".hidden", "a/b", "a\\b", "two\nlines"})
    EXPECT_THROW(stem({"--name", wrong}), CLI::ParseError) << wrong;
  EXPECT_THROW(stem({"--name", std::string(201, 'a')}), CLI::ParseError);
}

// A script's empty variable is no wish for the defaults.
TEST(Describe, AnEmptyNameIsNoCase) {
  std::string words[] = {"squat", "describe", ""};
  char* argv[] = {words[0].data(), words[1].data(), words[2].data()};
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(runProgram(3, argv), kFileWrong);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("no such case file"));
}

// What is asked for `words`, and what is said.
std::pair<int, std::string> threadsOf(const std::string& words) {
  CLI::App app;
  int threads = 0;
  addThreads(app, threads);
  ::testing::internal::CaptureStderr();
  app.parse(words);
  return {threads, ::testing::internal::GetCapturedStderr()};
}

TEST(Threads, AreLimitedByTheMachineAndThatIsReported) {
  EXPECT_EQ(threadsOf("").first, 0);
  EXPECT_EQ(threadsOf("--threads 3"), std::pair(3, std::string()));
  for (const auto& [cores, maximum] : {std::pair(1, 8), std::pair(2, 8), std::pair(16, 64), std::pair(200, 800)})
    EXPECT_EQ(usefulThreads(cores), maximum);
  const auto [threads, reported] = threadsOf("--threads 1024");
  const int maximum = usefulThreads(static_cast<int>(std::thread::hardware_concurrency()));
  EXPECT_EQ(threads, std::min(1024, maximum));
  if (maximum < 1024)
    EXPECT_THAT(reported, HasSubstr("instead of 1024"));
  else
    EXPECT_EQ(reported, "");  // nothing was taken off, nothing is said
  EXPECT_THROW(threadsOf("--threads 0"), CLI::ValidationError);
  ::testing::internal::GetCapturedStderr();
  EXPECT_THROW(threadsOf("--threads 5000"), CLI::ValidationError);
  ::testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace squat::commands
