// widgets/studio/comparison/ComparisonWorker.h - computes the numbers of the comparison in a thread of its own.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <map>
#include <set>
#include <utility>

#include "analysis/ComparisonTable.h"
#include "project/MeasuredRecords.h"

namespace squat::studio {

using project::RecordPointer;

// One signal after the other, each once: of a run its record, of a measured signal the whole file, which may be longer
// than what is drawn.
class ComparisonWorker : public QObject {
  Q_OBJECT
 public:
  struct Source {
    RecordPointer record;
    project::MeasuredReading reading;
    bool measured = false;
  };
  struct Numbers {
    analysis::NamedNumbers numbers;
    QString problem;  // why there are none; empty: there are
  };

  explicit ComparisonWorker(QObject* parent = nullptr);
  ~ComparisonWorker() override;  // drops what is waiting, and waits for what is under way

  // Null where they are not known yet; then they are computed, and changed() follows.
  const Numbers* numbersOf(const Source& source);
  const Numbers* likenessOf(const Source& source, const Source& reference);
  bool isBusy() const { return !asked_.empty(); }
  void forgetAllBut(const std::set<RecordPointer>& records);

 Q_SIGNALS:
  void changed();

 private:
  using Pair = std::pair<RecordPointer, RecordPointer>;  // without a second: the numbers of the first
  const Numbers* found(const Source& source, const Source& reference);
  Numbers compute(const Source& source, const Source& reference);
  void take(const Pair& pair, const Numbers& numbers);

  std::map<Pair, Numbers> known_;
  std::set<Pair> asked_;
  RecordPointer referenceOf_;  // of the thread alone: whose whole signal this is
  signals::Record reference_;
  std::atomic<bool> closing_{false};
  QThreadPool thread_;
};

}  // namespace squat::studio
