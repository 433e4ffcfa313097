// solver/roughness/RoughnessFiles.h - roughness as text for a terminal and as tables.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "roughness/RoughnessGauge.h"

namespace squat::roughness {

// Of several signals, each with its name.
using NamedRoughness = std::pair<std::string, RecordRoughness>;

// Levels with their bounds, the limit of ISO 3095 beside them, and corrugation indices.
std::string roughnessSummary(const NamedRoughness& roughness);

// One row a third octave: wavelength [mm], level, lowest, highest, limit [dB re 1 um], shares [dB], waves.
std::string roughnessCsv(const RecordRoughness& roughness);
// frequency [Hz], real and imaginary part of the mean response [1/s2], then magnitudes [1/s2] of all variants.
std::string transferCsv(const TransferFunction& transfer);
// {"schema": "squat-roughness", "schema_version": 1, "case", "transfer": {...}, "signals": [{name, levels,
// corrugation}]}
std::string roughnessJson(const std::vector<NamedRoughness>& roughness, const TransferFunction& transfer,
                          const std::string& caseName);

// What the files of a signal begin with: its name without odd characters, with a number where there are several, and
// "_roughness".
std::string fileStem(const std::vector<NamedRoughness>& roughness, std::size_t index);

// FOLDER/roughness.json, roughness-transfer.csv and NAME_roughness.csv of each signal, durably. Returns the paths.
std::vector<std::string> writeRoughness(const std::vector<NamedRoughness>& roughness, const TransferFunction& transfer,
                                        const std::string& caseName, const std::string& folder);

}  // namespace squat::roughness
