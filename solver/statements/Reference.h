// solver/statements/Reference.h - what the paper states, as data (resources/reference/paper.json): runs to make,
// statements to judge on them, the parameters of its model, and numbers that no run can be judged by.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/CaseDeclaration.h"

namespace squat::statements {

struct ReferenceRun {
  std::string name, caseName;
  std::vector<std::pair<std::string, std::string>> sets;  // keys changed, in the unit of the case file
  // Further ones on the mesh preset "paper", where the model is the paper's to the last stated parameter.
  std::vector<std::pair<std::string, std::string>> paperSets = {};

  // The case of the run on a mesh preset. Throws as cases::loadCase().
  cases::CaseDescription caseOn(const std::string& mesh) const;
};

// Where on the vehicle a signal is judged: the paper's accelerometer is on the axle box.
inline constexpr const char* axleBox = "axle box";
inline constexpr const char* wheelCentre = "wheel centre";

struct Statement {
  std::string section, text;             // of the paper
  std::string name;                      // a few words for a column or an axis; the text where none is given
  std::string run, against;              // names of runs; `against` not empty: the ratio of both is judged
  std::string measure;                   // see Measures.h; "none": cannot be judged, the reason says why
  std::string mesh;                      // judged on this mesh preset only; empty: on any
  std::string point = axleBox;           // where: axleBox or wheelCentre
  std::pair<double, double> band{0, 0};  // [Hz]
  double near = 0;                       // [Hz]
  std::optional<double> expected;        // the paper's number, where it gives one
  double low = -std::numeric_limits<double>::infinity();  // allowed range, in `unit`; a trend has one bound
  double high = std::numeric_limits<double>::infinity();
  std::string unit, reason;  // reason of the range
};

// A parameter of the paper's model that is a key of the case file, in the unit of the case file.
struct PaperParameter {
  std::string section, text, key, value;
};

// Stated by the paper, but of measurements or of the track: kept, not judged.
struct PaperNumber {
  std::string section, text, value, unit;
};

// Values of one key, all else as in the run that sensitivity is shown on.
struct SensitivityKey {
  std::string key, text;
  std::vector<std::string> values;  // in the unit of the case file
};

struct Reference {
  std::string source;
  std::vector<ReferenceRun> runs;
  std::vector<Statement> statements;
  std::vector<PaperParameter> parameters;
  std::vector<PaperNumber> numbers;
  std::string sensitivityRun;
  std::vector<SensitivityKey> sensitivity;

  const ReferenceRun* run(const std::string& name) const;
};

// A statement gives its range by "low" and "high" (or one of them: a trend), or by "expected" and "tolerance" (a share
// of it). Throws FileError with the entry that is wrong: unknown run, measure, key or point, no range or one that is
// upside down, newer schema.
Reference readReference(const std::string& path);

// The same for text that stands in memory; `path` names it in messages.
Reference parseReference(std::string_view text, const std::string& path);

// The paper's statements as they are installed.
std::string paperReferencePath();

}  // namespace squat::statements
