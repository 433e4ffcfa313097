// solver/detection/EventFeatures.h - what is measured of one event, the same for computed passages and records.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "detection/BandPower.h"
#include "detection/Candidates.h"

namespace squat::detection {

inline constexpr std::size_t bandCount = 6;  // detectionBands().size()

struct EventFeatures {
  double speed = 0;                         // [m/s] at the anchor
  std::array<double, bandCount> energy{};   // [m2/s3] power of each band over the event's window, noise included
  std::array<double, bandCount> noise{};    // [m2/s3] of the local level over the same window; 0: band not shown
  std::array<double, bandCount> freedom{};  // degrees of freedom of the noise's energy; 0: band not shown
  double before = 0;      // [-] mean power ahead of the window by that inside it, above the level, bands 320 to 2000 Hz
  double reach = 0;       // [m] of the neighbourhood (3 m on both sides) that is at least a tenth as loud as the event
  double wavelength = 0;  // [m] speed by the mean frequency of the power in 560 to 2000 Hz
};

// The stretch that counts as the event [m]: ahead of the anchor and behind it. The lowest band, which tells the long
// dips of joints and welds from squats, has wavelets as long as a metre and counts over more.
struct EventWindow {
  double before = 0, behind = 0;
};
constexpr EventWindow eventWindow(std::size_t band) {
  return band == 0 ? EventWindow{0.4, 0.8} : EventWindow{0.12, 0.28};
}

// `speed` [m/s] and `travelled` [m] at each cell; `rate` [Hz] of the samples.
EventFeatures eventFeatures(const BandPower& power, const Evidence& evidence, double rate,
                            const std::vector<double>& speed, const std::vector<double>& travelled, std::size_t anchor);

}  // namespace squat::detection
