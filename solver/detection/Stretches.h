// solver/detection/Stretches.h - stretches of corrugation as rows of the list of events.
#pragma once

#include <string>
#include <vector>

#include "detection/Passes.h"

namespace squat::detection {

// Whether speeds vary enough to tell a wavelength from a frequency.
bool areVaried(double slowest, double fastest);

// Those of one channel: position is where they begin, `extent` how long they are.
std::vector<Event> stretchEvents(const ChannelDetection& channel, const std::string& unit);

// The stretches of all records, in the first record's chainage (`shifts`: shiftsOntoFirst()). Those of two passes that
// overlap by half of the shorter, of one channel and with wavelengths within 15 %, are one: from the first metre that
// any pass shows to the last. Passes at speeds that differ tell a wavelength from a resonance as a speed that varies.
std::vector<CombinedEvent> combinedStretches(const std::vector<RecordDetection>& detections,
                                             const std::vector<double>& shifts);

}  // namespace squat::detection
