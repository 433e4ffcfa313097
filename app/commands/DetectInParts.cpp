#include "commands/DetectInParts.h"

#include "commands/FilesInParts.h"
#include "core/Errors.h"
#include "detection/CandidateFile.h"

namespace squat::commands {

namespace {

FileOutcome searchRecord(const RecordSearch& search, const std::string& record, const studies::PartLock& lock,
                         Monitor& monitor) {
  try {
    const auto key = detection::candidateKey(record, search.read, search.options);
    if (detection::readCandidates(search.folder, key)) return FileOutcome::known;
    const auto stream = records::openRecord(record, search.read);
    const auto found = detection::findCandidates(*stream, search.options, monitor);
    if (found.cancelled) return FileOutcome::cancelled;
    lock.requireOwn();
    detection::writeCandidates(search.folder, key, found);
    return FileOutcome::done;
  } catch (const FileError& error) {
    monitor.message(std::string("error: ") + error.what());
    return FileOutcome::failed;
  }
}

}  // namespace

int searchPart(const RecordSearch& search, const studies::Partition& part, Monitor& monitor) {
  return workOnPart(
      "detect", search.records, search.folder, part,
      [&](const std::string& record, const studies::PartLock& lock) {
        return searchRecord(search, record, lock, monitor);
      },
      monitor);
}

std::vector<detection::RecordDetection> collectRecords(const RecordSearch& search) {
  std::vector<detection::RecordDetection> found;
  std::vector<std::string> missing;
  for (const auto& record : search.records) {
    const auto key = detection::candidateKey(record, search.read, search.options);
    if (auto candidates = detection::readCandidates(search.folder, key))
      found.push_back(*std::move(candidates));
    else
      missing.push_back(record);
  }
  if (!missing.empty())
    throw FileError(search.folder, "",
                    "holds no candidates of " + listed(missing) + ": never searched, or changed since",
                    "Repeat the parts that have these records");
  return found;
}

}  // namespace squat::commands
