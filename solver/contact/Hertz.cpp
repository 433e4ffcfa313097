#include "contact/Hertz.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/ElementaryFunctions.h"

namespace squat::contact {

namespace {

// Complete elliptic integrals of first and second kind, parameter m = e^2.
std::pair<double, double> ellipticIntegrals(double m) {
  double a = 1, b = std::sqrt(1 - m), c = std::sqrt(m), sum = 0.5 * m, power = 1;
  while (std::abs(c) > 1e-15) {
    const double next = 0.5 * (a + b);
    c = 0.5 * (a - b);
    b = std::sqrt(a * b);
    a = next;
    sum += power * c * c;
    power *= 2;
  }
  const double first = std::numbers::pi / (2 * a);
  return {first, first * (1 - sum)};
}

}  // namespace

HertzContact hertzContact(double radiusX, double radiusY, double young, double poisson, double load) {
  const bool alongX = radiusX >= radiusY;  // the long axis lies along the larger radius
  const double large = alongX ? radiusX : radiusY, small = alongX ? radiusY : radiusX;
  const double pi = std::numbers::pi, modulus = young / (2 * (1 - poisson * poisson));
  // B/A = (a^2/b^2 E - K) / (K - E), rising with e from 1.
  double low = 1e-9, high = 1 - 1e-12;
  for (int i = 0; i < 200; ++i) {
    const double m = 0.5 * (low + high);
    const auto [k, e] = ellipticIntegrals(m);
    ((e / (1 - m) - k) / (k - e) < large / small ? low : high) = m;
  }
  const double m = 0.5 * (low + high), ratio = std::sqrt(1 - m);  // b / a
  const auto [k, e] = ellipticIntegrals(m);
  // A = 1/(2 large) = p0/E* b/(e^2 a^2) (K - E) with p0 = 3 N / (2 pi a b).
  const double shape = m > 1e-8 ? (k - e) / m : pi / 4;
  const double a = elementary::cbrt(3 * load * large * shape / (pi * modulus));
  const double b = ratio * a, peak = 3 * load / (2 * pi * a * b);
  return {alongX ? a : b, alongX ? b : a, peak, peak / modulus * b * k};
}

}  // namespace squat::contact
