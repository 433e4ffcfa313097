// solver/case/TreadFile.h - measured deviations of a wheel's tread as CSV.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// As a profile of the rail (ProfileFile.h), with the length of arc along the tread, in the order in which it meets the
// rail, as position and the radial deviation as height. The first column may be an angle in rad or deg instead, of a
// wheel of this radius [m]: "angle [deg]; deviation [mm]". Side by side "y = -10 mm [mm]": from the wheel plane
// outwards. Throws FileError.
std::vector<ProfileLine> readTreadLines(const std::filesystem::path& path, double radius);
std::vector<ProfileLine> parseTreadLines(std::string_view text, const std::string& origin, double radius);

}  // namespace squat::cases
