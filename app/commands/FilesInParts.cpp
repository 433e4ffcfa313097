#include "commands/FilesInParts.h"

#include <algorithm>
#include <cstdio>

#include "commands/ExitCodes.h"
#include "core/DurableFile.h"

namespace squat::commands {

int workOnPart(const std::string& command, const std::vector<std::string>& files, const std::string& folder,
               const studies::Partition& part, const FileWork& work, Monitor& monitor) {
  makeFolder(folder);
  const studies::PartLock lock(command, part, folder, studies::kPartBeat, monitor);
  std::size_t own = 0, done = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (studies::partOf(part, i, files[i]) != part.part) continue;
    ++own;
    const auto outcome = work(files[i], lock);
    if (outcome == FileOutcome::cancelled) {
      std::fprintf(stderr, "cancelled: repeat the command to resume\n");
      return kCancelled;
    }
    if (outcome == FileOutcome::failed) continue;
    ++done;
    monitor.message(files[i] + (outcome == FileOutcome::known ? ": already done" : ": done"));
  }
  std::printf("%s: %zu of %zu files done\n", studies::toText(part).c_str(), done, own);
  return done == own ? kDone : kFileWrong;
}

std::string listed(const std::vector<std::string>& files) {
  constexpr std::size_t shown = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, files.size()); ++i) text += (i > 0 ? ", " : "") + files[i];
  if (files.size() > shown) text += " and " + std::to_string(files.size() - shown) + " more";
  return text;
}

}  // namespace squat::commands
