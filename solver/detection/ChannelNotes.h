// solver/detection/ChannelNotes.h - what a channel shows beside its events, and what it cannot show.
#pragma once

#include <string>
#include <vector>

#include "detection/Detect.h"

namespace squat::detection {

// Of a judged channel: a background that is restless, events that are not those of an axle box.
std::vector<std::string> channelNotes(const ChannelDetection& channel, const DetectOptions& options);

}  // namespace squat::detection
