// solver/case/LevelsText.h - spectra of an irregularity: as text of a case, and files of them.
//
// A file is a table with a heading. Either its columns are wavelength and level, one third octave a row, or each column
// of levels is named by its wavelength, "2.5119 cm [dB re 1 um]", and each row is a measurement: then mean squares are
// averaged over the rows. Units of wavelength: m, cm, mm, um; levels are in dB re 1 um.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::cases {

// "10: -8, 20: -6.2": wavelength in mm, level in dB re 1 um. Nothing where the text is anything else; empty text: an
// empty table.
std::optional<std::vector<WavelengthLevel>> parseLevels(std::string_view text);
std::string formatLevels(const std::vector<WavelengthLevel>& levels);

// What is wrong with a table: too many rows, wavelengths not ascending, absurd values. Empty: nothing.
std::string levelsMistake(const std::vector<WavelengthLevel>& levels);

// Throws FileError.
std::vector<WavelengthLevel> readLevels(const std::filesystem::path& path);
std::vector<WavelengthLevel> parseLevelsTable(std::string_view text, const std::string& origin);

}  // namespace squat::cases
