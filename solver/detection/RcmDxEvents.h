// solver/detection/RcmDxEvents.h - what was found in a recording of RCM-DX, as events of that format.
#pragma once

#include <string>
#include <vector>

#include "detection/DetectionFiles.h"
#include "readers/SignalFile.h"

namespace squat::detection {

// FOLDER/squats.rcmdx, with the places that the recording itself gives; the path. Nothing where the record is in
// another format, or several were searched: an event of several passes has no single time. `reading` as the search had
// it. Throws FileError.
std::vector<std::string> writeRcmDxEvents(const DetectionReport& report, const readers::SignalFileOptions& reading,
                                          const std::string& folder);

}  // namespace squat::detection
