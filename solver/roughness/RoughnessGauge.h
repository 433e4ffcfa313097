// solver/roughness/RoughnessGauge.h - the roughness that a record of axle box acceleration implies.
//
// The record goes by in stretches under Hann's window, half over each other. Each has its own speed v; a third octave
// of wavelength is the band f = v / wavelength of its spectrum, and its mean square of heights
//   integral of S_a(f) / (|H(f)|^2 C(v/f)^2) df,   H: TransferFunction.h, C: ContactFilter.h.
// Where H is small against its mean in the band (an antiresonance, a zero of C) there is little to divide: H^2 C^2 is
// not taken below a tenth of the band's mean. Stretches weigh by their length. Heights for corrugation indices come
// from the same stretches, through H with its phase.
//
// What is seen is what excites the wheel: roughness of rail and wheel together, and as well sleepers that pass, joints,
// squats. Nothing of that can be told apart here.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "roughness/ContactFilter.h"
#include "roughness/CorrugationIndices.h"
#include "roughness/HeightSpectrum.h"
#include "roughness/TransferFunction.h"

namespace squat::roughness {

struct GaugeOptions {
  double shortest = 0.010, longest = 1.0;  // [m] middles of the outermost third octaves
  ContactFilter filter = ContactFilter::remington;
  bool quietEnds = false;  // the record begins and ends at rest and is one stretch: no window
  double stretch = 0;      // [m] about the length of a stretch; 0: eight times the longest wave
};

struct RoughnessLevel {
  WavelengthBand band;
  double level = 0;  // [dB re 1 um]; not-a-number where the record or the transfer function does not reach
  double lowest = 0, highest = 0;  // [dB re 1 um] with what is not known, the roots of squares added
  double track = 0;                // [dB] half the difference between over a sleeper and midspan
  double pads = 0;                 // [dB] the larger change with softer or stiffer pads
  double length = 0, waves = 0;    // [m] that was seen, and how many wavelengths that is
  double weak = 0;                 // share of the band where the response is below a tenth of its mean, 0 to 1
};

struct RecordRoughness {
  std::vector<RoughnessLevel> levels;
  // largestAt: way from the start. Of bands within what is asked for; without windows where record or transfer function
  // do not reach over the whole band.
  std::vector<CorrugationIndex> corrugation;
  ContactFilter filter = ContactFilter::remington;
  double length = 0, speed = 0;  // [m] that was analysed, [m/s] mean
  double left = 0;               // [m] that was not: too slow, speed changing, not a number
  std::vector<std::string> notes;
};

class RoughnessGauge {
 public:
  // `rate` [Hz] of the record. The transfer function must outlive the gauge.
  RoughnessGauge(const TransferFunction& transfer, double rate, const GaugeOptions& options);

  // Samples of acceleration [m/s2, up positive or negative] and the speed at each [m/s], which may be negative.
  void add(const std::vector<double>& acceleration, const std::vector<double>& speed);
  void breakHere();  // what comes does not follow on
  RecordRoughness finish();

 private:
  struct Sums {
    double central = 0, sleeper = 0, midspan = 0, soft = 0, stiff = 0;  // [m3] mean squares of heights times way
    double way = 0, weak = 0;
  };
  void setSize(double speed);
  void takeStretches(bool last);
  void takeStretch(std::size_t size, bool alone);
  void addLevels(const std::vector<double>& acceleration, double speed, double way);
  void addHeights(const std::vector<double>& acceleration, double speed, bool alone);
  using PerBand = std::array<bool, 4>;  // corrugation bands
  PerBand reachedBands(double speed) const;
  void releaseHeights(std::size_t count, double way, const PerBand& known);
  double transferIndex(double frequency) const;

  const TransferFunction& transfer_;
  double rate_;
  GaugeOptions options_;
  std::vector<WavelengthBand> bands_;
  std::size_t size_ = 0;  // samples of a stretch
  std::vector<double> acceleration_, speed_;
  std::array<std::vector<double>, 4> heights_;  // of the corrugation bands, as stretches add up
  std::vector<Sums> sums_;
  std::vector<CorrugationGauge> gauges_;
  std::size_t taken_ = 0;
  double sizeSpeed_ = 0;  // [m/s] that the size of the stretches was chosen for
  PerBand lastKnown_{};   // of the stretch before, which lies half under the next one
  double length_ = 0, time_ = 0, left_ = 0;
};

}  // namespace squat::roughness
