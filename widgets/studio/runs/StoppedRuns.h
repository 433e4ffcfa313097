// widgets/studio/runs/StoppedRuns.h - checkpoints of the studio's runs: one that was stopped, or went down with the
// machine, resumes as soon as its case is open again.
#pragma once

#include <QString>
#include <string>

#include "case/CaseDescription.h"

namespace squat::studio {

class StoppedRuns {
 public:
  // An empty folder keeps nothing. Else it is made, and all but the newest few checkpoints are taken out of it: each
  // holds the whole state of a model (10 MB for `draft`).
  explicit StoppedRuns(const QString& folder);

  // Where the run of this case keeps its state; empty where nothing is kept.
  QString file(const cases::CaseDescription& description) const;
  QString file(const std::string& caseHash) const;
  bool has(const cases::CaseDescription& description) const { return exists(file(description)); }
  static bool exists(const QString& file);
  static void forget(const QString& file);  // nothing happens where there is none

 private:
  QString folder_;
};

}  // namespace squat::studio
