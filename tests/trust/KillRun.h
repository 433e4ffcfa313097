// Kills at random moments of real runs.
#pragma once

namespace squat::tests {

// A complete result stands; runs of the same case that checkpoint as often as they can are killed (SIGKILL) at random
// moments. After each kill the earlier result and the newest checkpoint must be whole; at the end --resume must finish
// with the bits of an undisturbed run.
void killAndResume(int kills);

}  // namespace squat::tests
