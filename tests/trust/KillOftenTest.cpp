#include <gtest/gtest.h>

#include "trust/KillRun.h"

TEST(KillRunOften, FiftyMomentsLoseNothing) { squat::testing::killAndResume(50); }
