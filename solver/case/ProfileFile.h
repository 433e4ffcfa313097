// solver/case/ProfileFile.h - measured longitudinal profiles as CSV.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// A table of text as every other one (text/TableLayout.h: lines above the heading, a row of units below it, any
// delimiter, decimal comma, remarks), with two columns, position and height, in the order of the header or, where its
// words do not tell, in this order; of more columns, the one that names a position and the one that names a height or a
// depth, in English, German, Dutch or French. Each names a unit of length (text/Units.h): a table without header, or
// with a unit missing, is refused: a profile read in the wrong unit would go unnoticed. Any step; positions ascend or
// fall strictly. Heights up positive, depths down. Returns metres, as measured and exact to the last digit: neither
// levelled nor shifted. Throws FileError with path, line and advice; limits: 200 MB, 80,000 points, 50 mm of height.
// `origin` names the text in messages.
//
// `asked` is the defect whose profile this is; without it, messages name none of a defect's keys. Three of them count
// here. `from` and `to` cut a scan with more points than allowed; all others come whole, for DefectSurface to cut. With
// a `filter`, rows that have no number are left out, up to a quarter of them: an empty field, "nan", or a mark for no
// value such as -9999 (one of the usual ones, and far beyond all other values); without, the first is an error.
std::vector<ProfilePoint> parseProfile(std::string_view text, const std::string& origin,
                                       const std::optional<Defect>& asked = {});

// The same of a file.
std::vector<ProfilePoint> readProfileFile(const std::filesystem::path& path);

// As above, or several profiles side by side: a column of positions first, then one of heights for each lateral
// position, which its header names: "position [mm]; y = -10 mm [um]; y = 0 mm [um]". Lateral positions ascend, on the
// crown from its middle outwards. One line with lateral position zero where the file holds a single profile.
std::vector<ProfileLine> readProfileLines(const std::filesystem::path& path, const std::optional<Defect>& asked = {});
std::vector<ProfileLine> parseProfileLines(std::string_view text, const std::string& origin,
                                           const std::optional<Defect>& asked = {});

}  // namespace squat::cases
