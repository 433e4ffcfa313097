#include "studio/comparison/ComparisonWorker.h"

namespace squat::studio {
namespace {

signals::Record wholeOf(const ComparisonWorker::Source& source) {
  return source.measured ? project::wholeRecord({source.record, source.reading}) : *source.record;
}

}  // namespace

ComparisonWorker::ComparisonWorker(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

ComparisonWorker::~ComparisonWorker() {
  closing_ = true;
  thread_.clear();
  thread_.waitForDone();
}

const ComparisonWorker::Numbers* ComparisonWorker::numbersOf(const Source& source) { return found(source, {}); }

const ComparisonWorker::Numbers* ComparisonWorker::likenessOf(const Source& source, const Source& reference) {
  return found(source, reference);
}

const ComparisonWorker::Numbers* ComparisonWorker::found(const Source& source, const Source& reference) {
  const Pair pair(source.record, reference.record);
  if (const auto known = known_.find(pair); known != known_.end()) return &known->second;
  if (!asked_.insert(pair).second) return nullptr;
  thread_.start([this, source, reference, pair] {
    if (closing_) return;
    const Numbers numbers = compute(source, reference);
    QMetaObject::invokeMethod(
        this, [this, pair, numbers] { take(pair, numbers); }, Qt::QueuedConnection);
  });
  return nullptr;
}

ComparisonWorker::Numbers ComparisonWorker::compute(const Source& source, const Source& reference) {
  try {
    if (!reference.record) return {analysis::signalNumbers(wholeOf(source)), {}};
    if (referenceOf_ != reference.record) {
      referenceOf_.reset();
      reference_ = wholeOf(reference);
      referenceOf_ = reference.record;
    }
    return {analysis::likenessNumbers(wholeOf(source), reference_), {}};
  } catch (const std::exception& error) {
    return {{}, QString::fromStdString(error.what())};
  }
}

void ComparisonWorker::take(const Pair& pair, const Numbers& numbers) {
  if (asked_.erase(pair) == 0) return;  // forgotten meanwhile
  known_[pair] = numbers;
  Q_EMIT changed();
}

void ComparisonWorker::forgetAllBut(const std::set<RecordPointer>& records) {
  const auto gone = [&](const Pair& pair) {
    return records.count(pair.first) == 0 || (pair.second && records.count(pair.second) == 0);
  };
  std::erase_if(known_, [&](const auto& each) { return gone(each.first); });
  std::erase_if(asked_, gone);
}

}  // namespace squat::studio
