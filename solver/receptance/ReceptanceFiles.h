// solver/receptance/ReceptanceFiles.h - receptance and modes as HDF5 and CSV.
#pragma once

#include <string>
#include <vector>

#include "receptance/Receptance.h"

namespace squat::receptance {

// HDF5: /frequency, /over_a_sleeper/{real,imaginary}, /midspan/..., /wheelset/{frequency,harmonic,box,wheel,contact};
// attributes say how it was made. `caseToml` is the case as it was asked for. Throws FileError.
void writeReceptance(const std::string& path, const TrackReceptance& receptance, const std::string& caseToml);

// frequency [Hz], then real part, imaginary part, magnitude [m/N] and phase [deg] of each point.
std::string receptanceCsv(const TrackReceptance& receptance);

// frequency [Hz], harmonic, shares at box, wheel centre and contact [1/sqrt(kg)].
std::string modesCsv(const TrackReceptance& receptance);

// The three of them: STEM-receptance.h5, STEM-receptance.csv, STEM-wheelset-modes.csv.
std::vector<std::string> receptanceFiles(const std::string& stem);
void writeReceptanceFiles(const std::string& stem, const TrackReceptance& receptance, const std::string& caseToml);

}  // namespace squat::receptance
