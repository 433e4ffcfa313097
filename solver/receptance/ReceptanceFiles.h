// solver/receptance/ReceptanceFiles.h - receptance and modes as HDF5 and CSV.
#pragma once

#include <string>
#include <vector>

#include "receptance/Receptance.h"

namespace squat::receptance {

// HDF5: /frequency, /over_a_sleeper/{real,imaginary}, /midspan/... or the names of other places,
// /wheelset/{frequency,harmonic,box,wheel,contact}; attributes say how it was made. `caseToml` is the case as it was
// asked for. Throws FileError.
void writeReceptance(const std::string& path, const TrackReceptance& receptance, const std::string& caseToml);

// frequency [Hz], then real part, imaginary part, magnitude and phase [deg] of each point.
std::string receptanceCsv(const TrackReceptance& receptance,
                          ReceptanceQuantity quantity = ReceptanceQuantity::receptance);

// Third octaves: middle [Hz], root mean square of the magnitude of each point.
std::string thirdOctavesCsv(const TrackReceptance& receptance, ReceptanceQuantity quantity);

// frequency [Hz], harmonic, shares at box, wheel centre and contact [1/sqrt(kg)].
std::string modesCsv(const TrackReceptance& receptance);

// All of them: STEM-receptance.h5, STEM-receptance.csv, STEM-receptance-third-octaves.csv, STEM-wheelset-modes.csv. The
// HDF5 file holds receptances whatever the quantity.
std::vector<std::string> receptanceFiles(const std::string& stem);
void writeReceptanceFiles(const std::string& stem, const TrackReceptance& receptance, const std::string& caseToml,
                          ReceptanceQuantity quantity = ReceptanceQuantity::receptance);

}  // namespace squat::receptance
