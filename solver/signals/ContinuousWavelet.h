// solver/signals/ContinuousWavelet.h - continuous wavelet transform with the Morlet wavelet.
//
//   W(s, tau) = 1/sqrt(s) Integral x(t) psi*((t - tau)/s) dt,   psi(t) = pi^(-1/4) exp(i w0 t) exp(-t^2/2),  w0 = 6
//
// (Molodova et al. 2014, equation 1). The signal is zero outside its record and band-limited inside; take its mean off
// first where it has one. Frequencies are those of the pure tone that answers most strongly at the scale:
//   energy     |W|^2 as in the equation;              f = (w0 + sqrt(2 + w0^2)) / (4 pi s)  (Torrence & Compo 1998)
//   amplitude  |W| sqrt(2) pi^(-1/4) / sqrt(s), a tone of amplitude 1 gives 1;   f = w0 / (2 pi s)
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "signals/TimeSeries.h"

namespace squat::signals {

enum class WaveletNormalisation { energy, amplitude };

struct WaveletOptions {
  double lowest = 50, highest = 2500;  // [Hz] ends of the frequency axis; highest at most half the sampling rate
  double voicesPerOctave = 16;
  WaveletNormalisation normalisation = WaveletNormalisation::energy;
  std::size_t cell = 1;  // scalogram(): samples per column; each column holds the mean power over its cell
  int threads = 1;
  // scalogram(): columns for this part of the record only [s]; the whole record counts for every one of them.
  std::optional<std::pair<double, double>> shown = std::nullopt;
};

inline constexpr double morletFrequency = 6.0;  // w0: at 6 the wavelet's own mean is negligible (1.5e-8)

double waveletScale(double frequency, WaveletNormalisation normalisation);  // [Hz] -> [s]

// lowest * 2^(i/voices) up to and including highest where it falls on a voice.
std::vector<double> waveletFrequencies(double lowest, double highest, double voicesPerOctave);

struct Scalogram {
  std::vector<double> frequency;  // [Hz] rising
  std::vector<double> time;       // [s] centre of each column
  std::vector<double> power;      // |W|^2, row by row, one row a frequency: [unit^2 s], amplitude: [unit^2]
  // [Hz] per column: lowest frequency that the record's ends do not touch. sqrt(2) s away from a discontinuity its
  // trace has fallen to 1/e in |W|, to 1/e^2 in |W|^2; at the very ends the value is half the sampling rate.
  std::vector<double> coneOfInfluence;
  std::string normalisation;  // in words, for labels

  double at(std::size_t row, std::size_t column) const { return power[row * time.size() + column]; }
};

// Throws SignalError for a signal that is empty, constant or not finite, for frequencies above half its rate, and where
// no sample is shown.
Scalogram scalogram(const TimeSeries& series, const WaveletOptions& options = {});

// W (or its amplitude-normalised variant) at one frequency, at every sample.
std::vector<std::complex<double>> waveletCoefficients(const TimeSeries& series, double frequency,
                                                      WaveletNormalisation normalisation);

// Mean power over the whole record at each frequency of the options: a smooth spectrum.
std::vector<double> meanWaveletPower(const TimeSeries& series, const WaveletOptions& options);

// Part of a voice: coefficient i belongs to sample `first + i * stride` of the record.
struct WaveletPart {
  std::size_t voice, first, stride;
  std::span<const std::complex<double>> coefficients;
};
using WaveletSink = std::function<void(const WaveletPart&)>;

// The engine under the functions above, for records of any length: works in blocks, keeps a few blocks a thread in
// memory and hands each part of each voice to the sink. Low voices come at a stride: the largest power of two, at most
// `largestStride`, that still samples their band without loss. Calls of the sink never overlap; the parts of a
// voice come in their order in the record, on any number of threads.
void transformInBlocks(const TimeSeries& series, const std::vector<double>& frequencies,
                       WaveletNormalisation normalisation, std::size_t largestStride, int threads,
                       const WaveletSink& sink);

std::vector<double> coneOfInfluence(const std::vector<double>& time, double recordStart, double recordEnd, double rate,
                                    WaveletNormalisation normalisation);

}  // namespace squat::signals
