// widgets/studio/runs/StoppedRuns.h - checkpoints of the studio's runs: one that was stopped, or went down with the
// machine, resumes as soon as its case is open again.
#pragma once

#include <QDateTime>
#include <QString>
#include <memory>
#include <string>

#include "case/CaseDescription.h"
#include "core/platform/FileLock.h"

namespace squat::studio {

// All windows of a user share the folder, those of other processes as well. A run that is under way holds the lock
// beside its checkpoint: another window neither resumes it, nor writes or removes that file. The lock is the operating
// system's, which takes it from a process that dies.
class StoppedRuns {
 public:
  // An empty folder keeps nothing. Else it is made, and all but the newest few checkpoints are taken out of it: each
  // holds the whole state of a model (10 MB for `draft`). Those of runs that are under way stay.
  explicit StoppedRuns(const QString& folder);

  // Where the run of this case keeps its state; empty where nothing is kept.
  QString file(const cases::CaseDescription& description) const;
  QString file(const std::string& caseHash) const;
  // Whether a run of this case can be resumed: it has a checkpoint, and is not under way.
  bool has(const cases::CaseDescription& description) const;
  static bool exists(const QString& file);
  static QDateTime time(const QString& file);  // when its state was last written; not valid: there is none
  // Who computes the run of this checkpoint now: "squat-studio (process 4711 on HOST)"; empty: nobody.
  static QString owner(const QString& file);
  // For as long as a run is under way. Null without a file, and where another window holds it.
  static std::unique_ptr<platform::FileLock> hold(const QString& file);
  static void forget(const QString& file);  // nothing happens where there is none, or its run is under way

 private:
  QString folder_;
};

}  // namespace squat::studio
