// solver/detection/CandidateFile.h - the candidates of one record, kept so that several processes share many records.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "detection/Detect.h"

namespace squat::detection {

// What the candidates of a record follow from. A record counts as the same while its size and both its ends (64 KiB)
// are.
struct CandidateKey {
  std::string record;        // path as the call names it
  std::string settings;      // how it is read and searched, as text
  std::uintmax_t bytes = 0;  // of the record
  std::string ends;          // hash of both ends
};

// Throws FileError where the record cannot be read.
CandidateKey candidateKey(const std::string& record, const records::RecordOptions& read, const DetectOptions& options);

// FOLDER/candidates/STEM-HASH.candidates, HASH of the record's path.
std::string candidateFile(const std::string& folder, const std::string& record);

// Durable; every number is kept exactly. Throws FileError.
void writeCandidates(const std::string& folder, const CandidateKey& key, const RecordDetection& detection);

// Nothing where there are none, or those of a record of before. Throws CaseError where they were found with other
// settings or by another version of the program, FileError where the file is damaged.
std::optional<RecordDetection> readCandidates(const std::string& folder, const CandidateKey& key);

}  // namespace squat::detection
