#include "commands/TerminalMonitor.h"

#include <gmock/gmock.h>

#include <string>

namespace squat::commands {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string contents(std::FILE* file) {
  std::rewind(file);
  std::string text(10000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

TEST(TerminalMonitor, ProgressNamesPhasePercentTimeAndWhatIsLeft) {
  Progress progress;
  progress.phase = "rolling";
  progress.fraction = 0.42;
  progress.simulatedTime = 12.3e-3;
  progress.position = -0.123;
  progress.contactForce = 86100;
  progress.remainingSeconds = 130;
  const auto text = progressText(progress);
  EXPECT_THAT(text, HasSubstr("rolling"));
  EXPECT_THAT(text, HasSubstr("42 %"));
  EXPECT_THAT(text, HasSubstr("t 12.30 ms"));
  EXPECT_THAT(text, HasSubstr("N 86.1 kN"));
  EXPECT_THAT(text, HasSubstr("about 2 min left"));
  progress.remainingSeconds = -1;
  EXPECT_THAT(progressText(progress), Not(HasSubstr("left"))) << "nothing is promised that is not known";
}

// A study's phase names its run: the values in the middle give way, the phase and the time left never do.
TEST(TerminalMonitor, PhasesAreNeverCut) {
  Progress progress;
  progress.phase = "wheelset.bearing_centre=143, track.defect_from_sleeper=0.203 (stable_step)";
  progress.simulatedTime = 12.3e-3;
  progress.contactForce = 86100;
  progress.remainingSeconds = 130;
  EXPECT_THAT(progressText(progress), ::testing::AllOf(HasSubstr(progress.phase + "   0 %"), HasSubstr("86.1 kN")));
  EXPECT_EQ(progressText(progress, 100), progress.phase + "   0 %  about 2 min left");
}

TEST(TerminalMonitor, ALogGetsOneLineAPhaseNotOneAReport) {
  std::FILE* file = std::tmpfile();
  {
    TerminalMonitor monitor(file, false);
    Progress progress;
    for (const char* phase : {"mesh", "equilibrium"})
      for (int i = 0; i < 1000; ++i) {
        progress.phase = phase;
        monitor.report(progress);
      }
    monitor.message("a figure");
  }
  const auto text = contents(file);
  std::fclose(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST(TerminalMonitor, ATerminalKeepsOneLineAndLeavesItClean) {
  std::FILE* file = std::tmpfile();
  {
    TerminalMonitor monitor(file, true);
    Progress progress;
    progress.phase = "mesh";
    monitor.report(progress);
  }
  const auto text = contents(file);
  std::fclose(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
  EXPECT_EQ(text.substr(text.size() - 4), "\r\033[K");
}

}  // namespace
}  // namespace squat::commands
