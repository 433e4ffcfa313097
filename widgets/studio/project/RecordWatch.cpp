#include "studio/project/RecordWatch.h"

#include <utility>

#include "project/FileDigest.h"

namespace squat::studio {

RecordWatch::RecordWatch(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

RecordWatch::~RecordWatch() {
  ++generation_;
  thread_.clear();
  thread_.waitForDone();
}

void RecordWatch::open(const project::LongRecords& kept) {
  ++generation_;
  thread_.clear();
  known_.clear();
  for (std::size_t i = 0; i < kept.files.size(); ++i)
    known_[kept.files[i]] = {i < kept.digests.size() ? kept.digests[i] : std::string(), true};
  lookAgain();
}

void RecordWatch::follow(const std::vector<std::string>& files) {
  std::map<std::string, Known> before;
  before.swap(known_);
  for (const auto& file : files)
    if (const auto found = before.find(file); found != before.end())
      known_.insert(*found);
    else if (known_.try_emplace(file).second)
      look(file);
}

void RecordWatch::lookAgain() {
  for (const auto& [file, known] : known_) look(file);
}

std::vector<std::string> RecordWatch::digestsOf(const std::vector<std::string>& files) const {
  std::vector<std::string> digests;
  for (const auto& file : files) {
    const auto found = known_.find(file);
    digests.push_back(found == known_.end() ? std::string() : found->second.digest);
  }
  return digests;
}

void RecordWatch::look(const std::string& file) {
  thread_.start([this, file, generation = generation_.load()] {
    if (generation != generation_) return;
    const auto conclude = [this, file, generation, digest = project::fileDigest(file)] {
      if (generation == generation_) take(file, digest);
    };
    QMetaObject::invokeMethod(this, conclude, Qt::QueuedConnection);
  });
}

// A file that is missing keeps its digest: it may come back.
void RecordWatch::take(const std::string& file, const std::string& digest) {
  const auto found = known_.find(file);
  if (found == known_.end() || digest.empty()) return;
  const std::string before = std::exchange(found->second.digest, digest);
  const bool isKept = std::exchange(found->second.isKept, false);
  if (before == digest) return;
  if (const auto change = project::changeOf(file, before, digest); isKept && !change.empty())
    Q_EMIT changed(QString::fromStdString(change));
  Q_EMIT looked();
}

}  // namespace squat::studio
