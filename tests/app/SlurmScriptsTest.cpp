#include "commands/SlurmScripts.h"

#include <gmock/gmock.h>

namespace squat::commands {
namespace {

TEST(SlurmScripts, wordsAreQuotedForAShell) {
  EXPECT_EQ(quoted("--vary"), "--vary");
  EXPECT_EQ(quoted("motion.speed=28,30"), "motion.speed=28,30");
  EXPECT_EQ(quoted("motion.speed=108 km/h"), "'motion.speed=108 km/h'");
  EXPECT_EQ(quoted("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(quoted(""), "''");
}

TEST(SlurmScripts, tasksAreRanges) {
  EXPECT_EQ(arrayText({1, 2, 3, 4}), "1-4");
  EXPECT_EQ(arrayText({2, 4, 5, 9}), "2,4-5,9");
  EXPECT_EQ(arrayText({7}), "7");
}

// The script of the manual's page, and the one that computes the rest.
TEST(SlurmScripts, thePlainScript) {
  SlurmJob job{{"squat", "study", "light-defect", "--vary", "motion.speed=28,30", "-o", "array"},
               "array",
               "slice:%/4",
               {1, 2, 3, 4},
               "10:00",
               2,
               false};
  EXPECT_EQ(arrayScript(job), R"(#!/bin/sh
# The parts of a study, one a task. A part that is started again resumes.
#SBATCH --job-name=squat-study
#SBATCH --array=1-4
#SBATCH --cpus-per-task=2
#SBATCH --time=10:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@60
#SBATCH --output=array/part-%a.log
exec squat study light-defect --vary motion.speed=28,30 -o array --partition slice:$SLURM_ARRAY_TASK_ID/4
)");
  EXPECT_THAT(collectScript(job), ::testing::HasSubstr("\nexec squat study light-defect --vary motion.speed=28,30 -o "
                                                       "array --collect\n"));
  job.parts = {3}, job.repeatsFailed = true, job.time.clear();
  EXPECT_THAT(arrayScript(job), ::testing::HasSubstr(" --retry-failed --partition slice:$SLURM_ARRAY_TASK_ID/4\n"));
  EXPECT_THAT(arrayScript(job), ::testing::Not(::testing::HasSubstr("--time")));
}

}  // namespace
}  // namespace squat::commands
