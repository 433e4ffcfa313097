// solver/statements/PaperCase.h - whether a result is one of the paper's cases, whatever its file is called.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/RunResult.h"

namespace squat::statements {

// A key that differs from the paper's case, "right.pad.stiffness" as well; both values in the unit of the case file,
// with the unit.
struct ChangedKey {
  std::string key, ours, paper;
};

struct PaperCase {
  std::string name;                 // of the shipped case, e.g. "light-defect"
  std::vector<ChangedKey> changed;  // empty: the result is this case, and the paper's statements apply
  bool isThePapers() const { return changed.empty(); }
};

// The paper's case with the fewest differences from the case of the result, on the result's own mesh preset. Keys that
// cannot change what the paper states do not count: title, note, mesh, distance rolled before and after the defect,
// number of wavelets. The torque may be that of the case or the paper's. Nothing where the defect is another one, and
// where the result carries no case.
std::optional<PaperCase> paperCaseOf(const results::RunResult& result);

// The mesh preset that a result was made on. Throws FileError where it carries no case that this version can read.
std::string meshPresetOf(const results::RunResult& result);

}  // namespace squat::statements
