// solver/core/ProgramVersion.h - what made a file: version of the program, and the commit that it was built from.
#pragma once

#include <string>

namespace squat {

// "0.2.0": what states, studies and results are compared by. Two commits of one version count as the same program.
const char* programVersion();

// The commit that was built: twelve digits, with "-changed" where files differed from it; empty where the sources were
// under no version control and of no archive of it. Only named, never compared.
const char* programCommit();

// For people: "0.2.0 (commit 0123456789ab)".
std::string programVersionText();

}  // namespace squat
