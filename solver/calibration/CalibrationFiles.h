// solver/calibration/CalibrationFiles.h - what a calibration reads and leaves, for command and studio.
#pragma once

#include <string>
#include <vector>

#include "calibration/Calibration.h"

namespace squat::calibration {

// `jobs` and `threads` as the machine allows for the larger of the two meshes; 0 in either: not chosen by the user.
void shareCores(const CalibrationDefinition& definition, int jobs, int threads, CalibrationOptions& options);

std::string calibratedCaseFile(const std::string& folder, const std::string& stem);  // FOLDER/STEM-calibrated.toml

// Throws CaseError where a file of the calibration would replace one that it is computed from: case, profile, targets
// (`targetFiles`, as the user named them) and what these name.
void keepInputsOf(const CalibrationDefinition& definition, const std::vector<std::string>& targetFiles,
                  const std::string& folder, const std::string& stem);

// Of a calibration that is complete: writes the calibrated case and calibration.txt, the summary. Returns the paths of
// all files that a user reads. Throws FileError.
std::vector<std::string> writeCalibrated(const Calibration& found, const std::string& folder, const std::string& stem);

}  // namespace squat::calibration
