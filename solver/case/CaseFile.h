// solver/case/CaseFile.h - cases as TOML files: reading with all errors collected, writing with every key filled in.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/CaseDeclaration.h"

namespace squat::cases {

inline constexpr int caseSchema =
    1;  // key `schema` of a case file; raise it when an old reader would misread a new file

// What the command line adds to a case file.
struct CaseOverrides {
  std::string preset;                                       // --mesh; empty: as the case states
  std::vector<std::pair<std::string, std::string>> values;  // --set: key and text in the unit of the case file
};

// Order of precedence: --set, keys stated in the file, presets (wheelset.preset, track.preset and mesh.preset: --mesh
// and
// --set, else the file's, else none and draft), defaults. A preset on the command line takes the place of the file's. A
// key of theirs that the file states with just the value that its own preset gives, or the default where it names none
// (as every written case does), counts as not stated then, so that presets act on written cases too.
// A profile named by defect.file is read, relative to the file's folder, unless the case has defect.points or lines; in
// the same way the deviation of the tread, wheelset.tread_deviation.
// Throws CaseError with every error in keys, types, ranges and relations (Validation.h); FileError where the file or
// the profile cannot be read, is no TOML (with line), is larger than 4 MB or of a newer schema.
CaseDescription readCase(const std::filesystem::path& path, const CaseOverrides& overrides = {});

// The same for text; `origin` names it in messages, profiles are looked for relative to `folder`.
CaseDescription parseCase(std::string_view text, const std::string& origin, const std::filesystem::path& folder = {},
                          const CaseOverrides& overrides = {});

// The same for a case that is still being edited: relations between its values may be broken.
CaseDescription parseUnfinishedCase(std::string_view text, const std::string& origin);

// The case that a result carries. Opens no file, whatever it names: results are untrusted files, and the case has
// the points of its tables.
CaseDescription parseCaseOfResult(std::string_view text, const std::string& origin);

// A path to a case file, or the name of a shipped case ("light-defect").
CaseDescription loadCase(const std::string& nameOrPath, const CaseOverrides& overrides = {});

// The files that a case is read from: its own, and the tables that it names, which are looked for beside the case, or
// here where --set names them.
std::vector<std::string> filesOfCase(const std::string& nameOrPath, const CaseDescription& description);

// Name of the result for a case: the file's name without its ending.
std::string caseStem(const std::string& nameOrPath);

// Every key with its value, grouped in tables, units and documentation as comments. parseCase gives back the same
// description, bit for bit: profiles are written as defect.points or lines, treads likewise.
std::string writeCase(const CaseDescription& description);

// Written beside, read back, renamed: the earlier file stays until the new one is whole. Throws FileError, and
// CaseError for a case that could not be read back because it has problems.
void saveCase(const CaseDescription& description, const std::filesystem::path& path);

// Eight hexadecimal digits that stand for everything that the physics sees: all keys but title, note and the names of
// the files of tables. Does not depend on machine, locale or the wording of comments.
std::string caseHash(const CaseDescription& description);

}  // namespace squat::cases
