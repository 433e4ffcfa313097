// solver/validation/Reference.h - what the paper states, as data (resources/reference/paper.json): runs to make, and
// statements to judge on them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace squat::validation {

struct ReferenceRun {
  std::string name, caseName;
  std::vector<std::pair<std::string, std::string>> sets;  // keys changed, in the unit of the case file
};

struct Statement {
  std::string section, text;             // of the paper
  std::string run, against;              // names of runs; `against` not empty: the ratio of both is judged
  std::string measure;                   // see Measures.h; "none": cannot be judged, the reason tells why
  std::string mesh;                      // judged on this mesh preset only; empty: on any
  std::pair<double, double> band{0, 0};  // [Hz]
  double near = 0;                       // [Hz]
  double low = 0, high = 0;              // allowed range, in `unit`
  std::string unit, reason;              // reason of the range
};

struct Reference {
  std::string source;
  std::vector<ReferenceRun> runs;
  std::vector<Statement> statements;
};

// Throws FileError with the entry that is wrong: unknown run or measure, range upside down, newer schema.
Reference readReference(const std::string& path);

}  // namespace squat::validation
