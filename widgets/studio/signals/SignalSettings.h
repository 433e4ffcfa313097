// widgets/studio/signals/SignalSettings.h - filter and window as the user has set them, and a result seen through them.
#pragma once

#include <memory>
#include <string>

#include "plots/SpectrumScale.h"
#include "project/Project.h"
#include "results/RunResult.h"
#include "signals/PowerSpectrum.h"
#include "signals/SignalCatalogue.h"

namespace squat::studio {

struct SignalSettings {
  double cutoff = 2000;           // [Hz] low-pass, Butterworth of order 4 forward and back
  std::string window = "hann";    // of the spectrum
  double from = -0.1, to = 0.28;  // [m] stretch of the spectrum
  plots::SpectrumScale spectrum = plots::SpectrumScale::linear;
  int moment = -1;                     // of the contact patch, index into the result's patches; -1: the impact
  std::size_t segment = 128, hop = 4;  // [samples] of the short-time Fourier transform
};

// As a project keeps them, with the colours of maps; and back. A scale that this version does not know is linear.
project::FigureChoices choicesOf(const SignalSettings& settings, const std::string& colours);
SignalSettings settingsOf(const project::FigureChoices& choices);

// The filtered channels of a record computed anew from the raw ones, where it has them. Throws SignalError, e.g. for a
// cut-off above half the rate.
void filterAnew(signals::Record& record, const SignalSettings& settings);

// The spectrum of aba_filtered, or of another channel, over the chosen stretch. Throws SignalError with what is wrong.
signals::PowerSpectrum spectrumOf(const signals::Record& record, const SignalSettings& settings,
                                  const std::string& channel = signals::names::axleBoxFiltered);

// The result with filtered channels and both spectra computed anew. Where that cannot be done these stay as they are
// and `problem` says why; where only the stretch of the spectra is wrong, only they do. The stretch that other figures
// show (psdFrom, psdTo) is that of the run.
std::shared_ptr<const results::RunResult> analysed(const results::RunResult& result, const SignalSettings& settings,
                                                   std::string& problem);

// Its scalogram computed anew from aba_filtered as it stands; unchanged where the record is too short.
std::shared_ptr<const results::RunResult> withScalogram(const results::RunResult& result);

}  // namespace squat::studio
