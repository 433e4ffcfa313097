// solver/detection/AxleNames.h - the axle boxes of wheelsets by the names of their channels, as a user writes them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace squat::detection {

// Names of the left and the right channel of each axle. Empty list: every channel is judged by itself; nothing: axles
// are found by the names of the channels.
using AxleNames = std::optional<std::vector<std::pair<std::string, std::string>>>;

// "none", or LEFT,RIGHT of each axle; an empty list gives nothing. A name in double quotes is taken as it stands, with
// any comma in it, two quotes for one: quotedAxleName() writes it so. Throws CaseError for other texts, among them
// those with more than one comma outside quotes.
AxleNames axleNamesFromText(const std::vector<std::string>& texts);

// The same in one line, with a semicolon between axles; an empty line gives nothing.
AxleNames axleNamesFromLine(const std::string& line);

// A channel's name as it is to be written in either: in quotes where it would be read in another way.
std::string quotedAxleName(const std::string& name);

}  // namespace squat::detection
