// solver/loggers/WavCalibration.h - what full scale means, as people write it into the comment of a wave file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace squat::loggers {

struct WavCalibration {
  double fullScale = 1;
  std::string unit;

  bool operator==(const WavCalibration&) const = default;
};

// All that stand in a text: "1.0 = 500 m/s2", "full scale 500 m/s2", "FS=50 g". The unit must be known and may not be
// one of time or frequency: "fs = 48000 Hz" is a sampling rate.
std::vector<WavCalibration> wavCalibrations(std::string_view text);

}  // namespace squat::loggers
