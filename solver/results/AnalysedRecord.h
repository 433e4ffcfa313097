// solver/results/AnalysedRecord.h - a record with its spectrum and its scalogram, and what names it on a figure.
#pragma once

#include <string>
#include <vector>

#include "signals/Record.h"

namespace squat::results {

// Computed or measured: what draws spectra and scalograms takes this and nothing else.
struct AnalysedRecord : signals::Record {
  std::string stem;  // name of the case file without its ending; empty for a measured signal
  std::string title;
  std::string caseHash;  // short hash of the case, shown on figures; empty for a measured signal
  bool complete = false;
  std::string stopReason;  // "done", "cancelled", "failed: ..."

  // Spectra of aba_filtered; window and its limits as text.
  std::vector<double> frequency, psd, psdWheel;
  std::string psdWindow;
  double psdFrom = 0, psdTo = 0;  // [m] positions

  std::vector<double> scalogramFrequency, scalogramTime, scalogramPosition;
  std::vector<double> scalogramPower;   // row by row, one row a frequency
  std::vector<double> coneOfInfluence;  // [Hz] lowest trustworthy frequency at each scalogram time
};

}  // namespace squat::results
