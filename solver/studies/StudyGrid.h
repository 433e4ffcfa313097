// solver/studies/StudyGrid.h - which runs a study consists of.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace squat::studies {

inline constexpr std::size_t kMaximumPoints = 10000;

// One key of the case and the values that it takes, as text in the unit of the case file.
struct Variation {
  std::string key;
  std::vector<std::string> values;
};

// "defect.length=20:60:5" is five equally spaced values from 20 to 60, both ends included; "defect.length=20,35,60" and
// "defect.lateral=uniform,parabolic" are lists. Values of a range are rounded to 12 digits. Throws CaseError; limits:
// 1000 values a key.
Variation variationFromText(const std::string& text);

std::string withoutRounding(double value);  // twelve digits: 0.1 + 0.2 is 0.3

struct StudyDefinition {
  std::string caseName;  // as the user named it
  std::string caseHash;  // of the case before any variation
  std::vector<Variation> variations;
  bool isList = false;       // the n-th values of all keys are one point; else every combination of them
  std::string program = {};  // version of the program; empty: not known
  std::string work = {};     // what is computed at each point, in words; empty: a run
  std::string start = {};    // what the runs have in common besides the case (SharedStart); empty: nothing
};

// One run: a value for each variation, in their order.
struct StudyPoint {
  std::size_t index = 0;
  std::vector<std::string> values;
};

// Every combination, the last variation changing fastest; or the points of a list. Throws CaseError for no variation, a
// key given twice, and more than 10000 points.
std::vector<StudyPoint> gridOf(const StudyDefinition& definition);

// "defect.length=20, defect.depth=0.1"
std::string toText(const StudyDefinition& definition, const StudyPoint& point);

}  // namespace squat::studies
