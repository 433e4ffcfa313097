// widgets/studio/profile/ProfileImport.h - any table of numbers read as a profile, with the user's choices. No windows
// here.
#pragma once

#include <string>
#include <vector>

#include "case/CaseDescription.h"

namespace squat::studio {

enum class Levelling { none, throughEnds, leastSquares };

struct ImportChoices {
  char delimiter = 0;         // 0: found from the text; else , ; | tab or space
  bool decimalComma = false;  // meaningless with the delimiter ","
  int skippedLines = -1;      // -1: lines before the first one that is all numbers
  int positionColumn = 0, heightColumn = 1;
  double positionUnit = 1e-3, heightUnit = 1e-3;  // [m] per unit of the column
  Levelling levelling = Levelling::throughEnds;
  bool flip = false;     // heights measured downwards
  bool reverse = false;  // measured against the rolling direction
  double heightScale = 1;
  double resampleStep = 0;  // [m]; 0: as measured
};

struct ImportedProfile {
  std::vector<std::vector<std::string>> head;  // the first cells, for the preview
  std::vector<cases::ProfilePoint> points;     // [m], positions ascending
  char delimiter = ',';                        // as used
  int columns = 0, skippedLines = 0;
  std::string problem;  // one sentence with the line; empty: the points can be used
};

// Choices that suit the text: delimiter, decimal comma, units named in the header.
ImportChoices suggestedChoices(const std::string& text);
ImportedProfile importProfile(const std::string& text, const ImportChoices& choices);

}  // namespace squat::studio
