// solver/detection/EvidenceTail.h - how much evidence the background of a record makes by itself, learned from it.
#pragma once

#include <vector>

namespace squat::detection {

// White noise makes a largest evidence W in a metre that is below W(y) with the probability exp(-exp(-y)). The
// background of a record is taken to make a W^b: a and b follow from the values that 30 and 60 % of the metres stay
// below. Events in a tenth of the metres raise the evidence that is reached once in 10 km by a fifth, in a fifth of
// them by three fifths.
// b = 1 for white noise, up to 1.2 for noise with
// resonances, 2 to 3 where the noise swells and fades, as on measured track.
//
// Of 40 km of noise with measured roughness and four resonances, the value that one metre in 10 000 exceeds is found
// within a tenth.
class EvidenceTail {
 public:
  // `maxima`: largest evidence in each metre. Fewer than some hundred say little: white noise counts as 50 more.
  explicit EvidenceTail(const std::vector<double>& maxima);

  // Metres in a kilometre whose background reaches the evidence, on the average.
  double alarmsPerKilometre(double evidence) const;
  // Its inverse; `alarms` from above 0 to 1000.
  double evidenceOf(double alarms) const;

 private:
  double factor_ = 1, exponent_ = 1;
};

}  // namespace squat::detection
