// solver/analysis/SignalViews.h - a run seen through the settings of its figures: signals filtered with another
// cut-off, spectra over another section, the scalogram of what is shown.
#pragma once

#include <memory>
#include <string>

#include "analysis/FigureSettings.h"
#include "results/RunResult.h"
#include "signals/PowerSpectrum.h"
#include "signals/SignalCatalogue.h"

namespace squat::analysis {

// The filtered partners of a record's signals computed from the signals themselves, where it has both. Throws
// SignalError, e.g. for a cut-off [Hz] above half the rate.
void filterPartners(signals::Record& record, double cutoff);

// The spectrum of a channel over a section. Throws SignalError with what is wrong.
signals::PowerSpectrum sectionSpectrum(const signals::Record& record, const Section& section, const std::string& window,
                                       const std::string& channel = signals::names::axleBoxFiltered);

// The result with filtered partners and both spectra as the settings ask for. Where that cannot be done these stay as
// they are and `problem` says why; where only the section is wrong, only the spectra do. The stretch that other figures
// show (psdFrom, psdTo) is that of the run.
std::shared_ptr<const results::RunResult> resultThrough(const FigureSettings& settings,
                                                        const results::RunResult& result, std::string& problem);

// Its scalogram computed from aba_filtered as it stands; unchanged where the record is too short.
std::shared_ptr<const results::RunResult> withScalogram(const results::RunResult& result);

}  // namespace squat::analysis
