// solver/signals/BesselI0.h - the modified Bessel function of the first kind and order zero: Kaiser's window.
#pragma once

namespace squat::signals {

// By its power series, sum of ((x/2)^k / k!)^2; terms below the last digit of the sum no longer change it.
inline double besselI0(double x) {
  double term = 1, sum = 1;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= (x / (2 * k)) * (x / (2 * k));
    sum += term;
  }
  return sum;
}

}  // namespace squat::signals
