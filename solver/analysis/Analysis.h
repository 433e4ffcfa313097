// solver/analysis/Analysis.h - everything that is asked of a signal, for computed and measured ones alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/Monitor.h"
#include "readers/SignalFile.h"
#include "signals/Alignment.h"
#include "signals/ContinuousWavelet.h"
#include "signals/Features.h"
#include "signals/PowerSpectrum.h"
#include "signals/Stft.h"

namespace squat::analysis {

struct AnalysisOptions {
  readers::SignalFileOptions file;
  double lowPass = 2000;                   // [Hz] zero-phase Butterworth of order 4 before everything else; 0: none
  signals::FeatureOptions features;        // `speed` is taken from the file or from file.speed
  signals::PowerSpectrumOptions spectrum;  // of the whole record; segment 0: 8192 samples where it is longer than 16384
  signals::StftOptions stft{signals::Window::hann, 0, 0, 0};  // segment 0: 10 ms; hop 0: at most 2000 columns
  signals::WaveletOptions
      wavelet;  // shown: the window of the spectrum; cell 0: at most 2000 columns; highest is lowered to half the rate,
                // lowest raised to one wave in the record and 1e-5 of the rate, voices lowered to 1000 rows
  bool align = true;  // where there is more than one run
  signals::AlignmentOptions alignment;
  AnalysisOptions() { wavelet.cell = 0; }
};

struct SignalAnalysis {
  std::string file, run;
  std::vector<std::string> notes;
  signals::Passage passage;      // as read
  signals::TimeSeries filtered;  // what everything below was made from
  signals::Features features;
  signals::PowerSpectrum spectrum;        // of the whole record
  std::optional<signals::Stft> stft;      // none where the record is shorter than the window found by itself
  signals::Scalogram scalogram;           // of the stretch that is shown: the window of the spectrum
  bool scalogramByAmplitude = false;      // normalised so that a tone of amplitude 1 gives 1
  std::vector<double> scalogramPosition;  // [m] at the columns, zero at the anchor
};

struct Analysis {
  std::vector<SignalAnalysis> signals;
  std::optional<signals::AlignedRuns> inTime, inPosition;  // where there is more than one
  std::optional<signals::RunDispersion> dispersion;        // of the runs aligned in time, as the paper compares them
  std::vector<std::string> notes;
};

// Reads and analyses every run of every file. Throws FileError (what is wrong with a file or with one of its signals)
// and CaseError (an option is wrong, the speed is missing). A cancelled analysis returns the signals so far, with a
// note.
Analysis analyse(const std::vector<std::string>& files, const AnalysisOptions& options, Monitor& monitor);

// One signal that is in memory already. Throws SignalError.
SignalAnalysis analyseSignal(const signals::Record& signal, const AnalysisOptions& options);

}  // namespace squat::analysis
