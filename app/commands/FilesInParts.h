// app/commands/FilesInParts.h - many files, each worked on by itself, shared by several processes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "studies/PartLock.h"

namespace squat::commands {

enum class FileOutcome { done, known, failed, cancelled };  // known: done by an earlier call

// Throws CaseError where another process has taken the part over meanwhile.
using FileWork = std::function<FileOutcome(const std::string& file, const studies::PartLock& lock)>;

// Does the work of one part of `files` for `squat COMMAND --partition`; the part is locked in the folder. A file that
// fails does not stop the others. Returns the exit code: 4 where one failed, 130 where it was cancelled.
int workOnPart(const std::string& command, const std::vector<std::string>& files, const std::string& folder,
               const studies::Partition& part, const FileWork& work, Monitor& monitor);

// "a.csv, b.csv and 3 more"
std::string listed(const std::vector<std::string>& files);

}  // namespace squat::commands
