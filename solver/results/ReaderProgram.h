// solver/results/ReaderProgram.h - the program that reads untrusted files for the others: where it is, and what it
// does.
#pragma once

#include <filesystem>
#include <span>

#include "core/platform/Caller.h"
#include "results/ReaderCall.h"

namespace squat::results {

// SQUAT_READER, or squat-reader beside this program or the library that this code is part of, or in
// libexec/squat-studio where both are installed; empty where there is none.
std::filesystem::path readerProgram();

// Kinds of what the program sends: an error, "location\nwhat"; everything else says the work.
inline constexpr char kRefused = 'E';

std::vector<std::byte> questionOf(const ReaderCall& call, const platform::OwnLimits& limits);

// Answers the question of who has started this program with one of `works`. The code that it has to end with.
int answerCaller(const ReaderWorks& works);

}  // namespace squat::results
