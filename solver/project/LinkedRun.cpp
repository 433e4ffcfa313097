#include "project/LinkedRun.h"

#include <algorithm>
#include <filesystem>

#include "project/FileDigest.h"

namespace squat::project {

std::string changeOf(const Entry& entry, const signals::Record& record) {
  return entry.digest.empty() ? std::string() : changeOf(entry.path, entry.digest, recordDigest(record));
}

LinkedRun openRun(const Entry& entry, results::ResultContent content) {
  try {
    auto result = std::make_shared<results::RunResult>(results::readResult(entry.path, content));
    if (result->stem.empty()) result->stem = std::filesystem::path(entry.path).stem().string();
    const std::string problem = changeOf(entry, *result);
    return {std::move(result), problem};
  } catch (const std::exception& error) {
    return {nullptr, error.what()};
  }
}

LinkedSignal openSignal(const Entry& entry) {
  LinkedSignal linked;
  linked.measured.reading = {entry.reading, entry.impact, entry.gain, entry.isAutomatic};
  try {
    const auto records = measuredRecords(entry.path, entry.reading.speed, linked.measured.reading);
    const auto found = std::find_if(records.begin(), records.end(),
                                    [&](const auto& each) { return each.record->run == entry.signal; });
    if (found == records.end()) {
      linked.problem = entry.path + " no longer has a signal “" + entry.signal + "”";
    } else {
      linked.measured = *found;
      linked.problem = changeOf(entry, *found->record);
    }
  } catch (const std::exception& error) {
    linked.problem = error.what();
  }
  return linked;
}

}  // namespace squat::project
