// solver/signals/Features.h - what an axle box acceleration says about a defect, as numbers.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "signals/Anchor.h"
#include "signals/Peaks.h"
#include "signals/PowerSpectrum.h"
#include "signals/TimeSeries.h"

namespace squat::signals {

struct Passage;

struct Band {
  std::string name;
  double low = 0, high = 0;  // [Hz]
  // Above half the sampling rate: a required band is refused, another one's features are not-a-number.
  bool required = true;
};

// The bands in which squats speak (Molodova et al. 2014, section 4; the third is that of the later detection work).
// Nobody asked for them by name, so a slow record does without: not required.
std::vector<Band> squatBands();

// Whether a signal of this sampling rate [Hz] can show the band.
bool shows(double rate, const Band& band);

struct FeatureOptions {
  double speed = 30.0;           // [m/s] at the anchor
  std::optional<Anchor> anchor;  // default: the sample with the largest absolute value
  double before = 0.10;          // [m] of the record used for the spectrum, before and after the anchor
  double after = 0.28;
  std::vector<Band> bands = squatBands();
  Band waveBand{"wave", 600, 2000, false};  // the short waves after the impact: the record is band-passed to it
  double waveSpan = 0.15;                   // [m] after the impact over which the mean wavelength is taken
  double rmsLength = 0.25;                  // [m] of the moving root mean square
  double decayLevel = 0.1;  // free vibration ends where the band's envelope stays below this share of its peak
  double lowestPeak = 50;   // [Hz] range and minimum share of the peaks of the spectrum
  double highestPeak = 2000;
  double peakShare = 0.02;
};

struct BandFeatures {
  Band band;
  double power = 0;          // [unit^2] integral of the density
  double share = 0;          // of the integral of the whole spectrum
  double freeVibration = 0;  // [s] from the anchor to the end of free vibration; NaN where the record ends before
  double ringsFor = 0;       // [s] the same, or as long as the record shows it
};

struct Features {
  std::string name, unit;
  double speed = 0, impactTime = 0;                 // [m/s], [s] of the anchor
  AnchorRule anchor = AnchorRule::largestValue;     // how the impact was found
  double peak = 0;                                  // largest absolute value
  double maximum = 0, minimum = 0, peakToPeak = 0;  // [unit]
  double rms = 0;                                   // of the whole record
  double largestMovingRms = 0;                      // over FeatureOptions::rmsLength
  double wavelengthByCrossings = 0;                 // [m] mean after the anchor; NaN: fewer than three crossings
  double wavelengthByRidge = 0;                     // [m] speed / power-weighted mean frequency of the wavelet ridge
  std::vector<BandFeatures> bands;
  std::vector<SpectralPeak> peaks;  // most prominent first
  PowerSpectrum spectrum;           // Hann, from `before` to `after`, zeros appended for a step of about 3 Hz
};

// Index of the sample with the largest absolute value.
std::size_t largestSample(const std::vector<double>& values);

// The lines that tables and figures name: at most six between 50 and 2000 Hz, those with at least 5 % of the
// prominence of the first, the most prominent first.
std::vector<SpectralPeak> namedLines(const PowerSpectrum& spectrum);

// Throws SignalError for a signal that is too short, constant or not finite, for a speed that is not positive, and for
// required bands above half the sampling rate.
Features features(const TimeSeries& series, const FeatureOptions& options = {});

// Anchor and speed of a passage where the options do not name them: anchorOf, and the wheel's own speed there, which
// under torque differs a little from the nominal one. One rule for runs, files, comparisons and the studio.
FeatureOptions anchored(const Passage& passage, FeatureOptions options = {});
Features features(const Passage& passage, const FeatureOptions& options = {});

// The same as a row of a table: names with unit ("peak [m/s2]"; a signal of unknown unit has "unit" there) and values,
// in a fixed order; `peakCount` frequencies, not a number beyond those there are. The spectrum is the one around the
// impact.
std::vector<std::pair<std::string, double>> featureRow(const Features& features, std::size_t peakCount = 4);

// Root mean square over the n samples centred on each sample (fewer at the ends).
std::vector<double> movingRms(const std::vector<double>& values, std::size_t n);

// The spectrum of a stretch, wherever one is shown or judged: of the samples from..to [s], mean taken off, zeros
// appended until the frequency step is at most 3 Hz.
PowerSpectrum localSpectrum(const TimeSeries& series, double from, double to, Window window = Window::hann);

// The same from..to [m] on the passage's own positions, at the speed of the anchor. Throws SignalError for a stretch
// that holds fewer than two samples.
PowerSpectrum stretchSpectrum(const Passage& passage, double from, double to, Window window = Window::hann);

// Mean wavelength [m] from the zero crossings of the band-passed record in from..to [s]; NaN with fewer than
// three.
double wavelengthByCrossings(const TimeSeries& series, double from, double to, double speed, const Band& band);

// The same from the ridge of the amplitude-normalised Morlet transform: at each sample the strongest frequency in the
// band, averaged with its power as weight.
double wavelengthByRidge(const TimeSeries& series, double from, double to, double speed, const Band& band);

// Time [s] from `impact` until the band's envelope (root mean wavelet power, amplitude-normalised) falls below `level`
// of its largest value after the impact and stays below for a period of the band's lower edge. Where it never does
// within the record, or one second, the vibration has not ended: it lasts at least that long. The wavelet's own length
// is the minimum that can be seen: an impulse gives 2.0/(band centre) at level 0.1.
struct FreeVibration {
  double duration = 0;  // [s]
  bool ended = false;
};
FreeVibration freeVibration(const TimeSeries& series, double impact, const Band& band, double level);

}  // namespace squat::signals
