// widgets/studio/records/RecordReading.h - how the search and the view read the records that are chosen.
#pragma once

#include "project/Project.h"
#include "records/RecordStream.h"

namespace squat::studio {

// Throws CaseError for a chainage or a unit that cannot be read.
records::RecordOptions readingOf(const project::LongRecords& chosen);

records::Together togetherOf(const project::LongRecords& chosen);

// The signal over an event in the file that a search wrote. Throws FileError and CaseError.
signals::TimeSeries passageIn(const std::string& file);

}  // namespace squat::studio
