// solver/case/NamedTables.h - keys of a case that name a file whose numbers the case then holds itself: profile, tread,
// irregularity, dynamic pads. Who reads a case, copies it or edits it asks here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "case/ParameterTable.h"

namespace squat::cases {

struct NamedTable {
  std::string fileKey;                 // "defect.file"
  std::vector<std::string> valueKeys;  // those that hold the numbers
  std::string holds;                   // "a profile file", for messages
  std::string& (*file)(CaseDescription&);
  bool (*isWanted)(const CaseDescription&);  // whether the case uses it
  bool (*isFilled)(const CaseDescription&);  // whether the case has the numbers already
  void (*clear)(CaseDescription&);
  // Throws FileError.
  void (*read)(CaseDescription&, const std::filesystem::path&);
};

const std::vector<NamedTable>& namedTables();

// nullptr: the key names no table.
const NamedTable* namedTable(const std::string& fileKey);
// The numbers of the table count, not the name of its file.
inline bool namesTable(const Parameter& parameter) { return namedTable(parameter.key) != nullptr; }

}  // namespace squat::cases
