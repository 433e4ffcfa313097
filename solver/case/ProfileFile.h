// solver/case/ProfileFile.h - measured longitudinal profiles as CSV.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// Two columns, position and height, in the order of the header or, where its words do not tell, in this order. The
// header names the units m, mm or um after each name: "position [mm]; height (um)", "position, mm". A table without
// header, or with a unit missing, is refused: a profile read in the wrong unit would go unnoticed. Delimiter `,` `;` or
// tab; decimal point, or decimal comma where the delimiter is not a comma; byte-order mark, CRLF, empty lines and lines
// that begin with # or % are skipped. Any step; positions ascend or fall strictly. Heights up positive. Returns metres,
// as measured: neither levelled nor shifted. Independent of the locale. Throws FileError with path, line and advice;
// limits: 200 MB, 1 MB a line, 80,000 points, 50 mm of height.
std::vector<ProfilePoint> readProfileFile(const std::filesystem::path& path);

// The same for text that stands in memory; `origin` names it in messages.
std::vector<ProfilePoint> parseProfile(std::string_view text, const std::string& origin);

// As above, or several profiles side by side: a column of positions first, then one of heights for each lateral
// position, which its header names: "position [mm]; y = -10 mm [um]; y = 0 mm [um]". Lateral positions ascend, on the
// crown from its middle outwards. One line with lateral position zero where the file holds a single profile.
std::vector<ProfileLine> readProfileLines(const std::filesystem::path& path);
std::vector<ProfileLine> parseProfileLines(std::string_view text, const std::string& origin);

}  // namespace squat::cases
