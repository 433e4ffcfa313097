// widgets/studio/project/StoreReport.h - a report of what the studio shows: the current run and what is laid over it.
#pragma once

#include <QString>

#include "project/Report.h"
#include "studio/runs/RunStore.h"

namespace squat::studio {

// `shown`: the current run with its fields; null: there is none. The reference of the comparison is in it, drawn or
// not.
project::Report reportOf(const RunStore& store, const ResultPointer& shown, const QString& title, const QString& notes);

}  // namespace squat::studio
