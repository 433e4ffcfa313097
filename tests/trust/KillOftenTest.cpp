#include <gtest/gtest.h>

#include "trust/KillRun.h"

TEST(KillRunOften, FiftyMomentsLoseNothing) { squat::tests::killAndResume(50); }
