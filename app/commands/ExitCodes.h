// app/commands/ExitCodes.h - exit codes for scripts.
#pragma once

namespace squat::commands {

inline constexpr int kDone = 0;
inline constexpr int kCaseWrong = 2;  // the case or the call
inline constexpr int kRunFailed = 3;
inline constexpr int kFileWrong = 4;
inline constexpr int kCancelled = 130;

}  // namespace squat::commands
