// The results that a project links to: there, missing, changed.
#include "project/LinkedRun.h"

#include <gmock/gmock.h>

#include "analysis/Folder.h"
#include "results/ResultFile.h"

namespace squat::project {
namespace {

using ::testing::HasSubstr;
using tests::Folder;

results::RunResult madeUp(double height) {
  results::RunResult run;
  run.stem = "dip";
  run.speed = 30;
  results::Channel aba{"aba", "m/s2", "", {}};
  for (int i = 0; i < 400; ++i) {
    run.time.push_back(i / 25000.0);
    run.position.push_back(30 * i / 25000.0 - 0.2);
    aba.values.push_back(height * std::sin(0.1 * i));
  }
  run.signals = {aba};
  run.complete = true;
  return run;
}

TEST(LinkedRun, isThereAsItWas) {
  const Folder folder;
  Entry entry;
  entry.path = folder.path("dip.h5");
  entry.digest = recordDigest(madeUp(50));
  results::writeResult(entry.path, madeUp(50));
  const auto found = openRun(entry);
  ASSERT_TRUE(found.result);
  EXPECT_EQ(found.problem, "");
  EXPECT_EQ(recordDigest(*found.result), entry.digest);
  entry.digest.clear();  // not known: nothing is said
  EXPECT_EQ(openRun(entry).problem, "");
}

TEST(LinkedRun, thatHasChangedIsShownAndSaid) {
  const Folder folder;
  Entry entry;
  entry.path = folder.path("dip.h5");
  entry.digest = recordDigest(madeUp(50));
  results::writeResult(entry.path, madeUp(50.000001));
  const auto found = openRun(entry);
  ASSERT_TRUE(found.result);
  EXPECT_THAT(found.problem, HasSubstr("dip.h5 holds other values"));
}

TEST(LinkedRun, thatIsGoneOrBrokenSaysWhy) {
  const Folder folder;
  Entry entry;
  entry.path = folder.path("dip.h5");
  EXPECT_FALSE(openRun(entry).result);
  EXPECT_THAT(openRun(entry).problem, HasSubstr("dip.h5"));
  folder.write("dip.h5", "no result");
  EXPECT_FALSE(openRun(entry).result);
  EXPECT_THAT(openRun(entry).problem, HasSubstr("dip.h5"));
}

TEST(RecordDigest, seesTimesPositionsNamesAndValues) {
  const auto run = madeUp(50);
  const auto digest = recordDigest(run);
  EXPECT_EQ(digest.size(), 8U);
  EXPECT_EQ(recordDigest(run), digest);
  auto other = run;
  other.time[7] += 1e-9;
  EXPECT_NE(recordDigest(other), digest);
  other = run;
  other.position[7] += 1e-9;
  EXPECT_NE(recordDigest(other), digest);
  other = run;
  other.signals[0].name = "other";
  EXPECT_NE(recordDigest(other), digest);
  other = run;
  other.signals[0].values[399] = -other.signals[0].values[399];
  EXPECT_NE(recordDigest(other), digest);
}

}  // namespace
}  // namespace squat::project
