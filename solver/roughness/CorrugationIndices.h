// solver/roughness/CorrugationIndices.h - corrugation as track maintenance counts it: the root mean square of
// band-passed heights over moving windows.
//
// Bands 10 to 30, 30 to 100, 100 to 300 and 300 to 1000 mm; windows of five times the longest wavelength (0.15,
// 0.5, 1.5, 5 m), moved by a quarter of it: in common use, not compared with EN 13231-3.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace squat::roughness {

struct CorrugationBand {
  double shortest = 0, longest = 0;  // [m]
  double window() const { return 5 * longest; }
};
const std::array<CorrugationBand, 4>& corrugationBands();

struct CorrugationIndex {
  CorrugationBand band;
  double rms = 0;           // [m] of everything; not-a-number where nothing was seen
  double typical = 0;       // [m] median of the moving rms; not-a-number where no window was full
  double exceeded = 0;      // [m] moving rms that 5 % of the windows exceed
  double largest = 0;       // [m] largest moving rms
  double largestAt = 0;     // [m] way from the start to the middle of that window
  std::size_t windows = 0;  // full ones
};

// Takes heights that are band-passed already, piece by piece.
class CorrugationGauge {
 public:
  explicit CorrugationGauge(const CorrugationBand& band) : band_(band) {}

  void add(double height, double way);  // [m] the way that this height stands for
  void skip(double way);                // nothing is known there: no window reaches across
  CorrugationIndex index() const;

 private:
  struct Cell {  // a quarter of a window
    double square = 0, way = 0, end = 0;
    bool first = false;  // a new stretch begins
  };
  CorrugationBand band_;
  std::vector<Cell> cells_;
  Cell open_{0, 0, 0, true};
  double at_ = 0, square_ = 0, way_ = 0;
};

// Share of a wave that a band takes, 0 to 1: between its limits with edges of half a third octave, half at each limit.
double passedByBand(const CorrugationBand& band, double wavelength);

// Of equally spaced heights [m]: band-passed as a whole, straight line taken off.
std::vector<CorrugationIndex> corrugationIndices(const std::vector<double>& heights, double spacing);

}  // namespace squat::roughness
