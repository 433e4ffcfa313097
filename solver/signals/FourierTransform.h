// solver/signals/FourierTransform.h - discrete Fourier transforms of one length, prepared once and used often.
// Plans are estimated, not measured, so results are the same from run to run. Making one waits for a mutex; using one
// is safe from any thread.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace squat::signals {

using Complex = std::complex<double>;

// X[k] = sum_i x[i] exp(-2 pi i k/n) for k = 0 .. n/2; not scaled.
class RealTransform {
 public:
  explicit RealTransform(std::size_t n);
  ~RealTransform();
  RealTransform(RealTransform&&) noexcept;
  RealTransform& operator=(RealTransform&&) noexcept;

  std::size_t size() const;
  // n values in, n/2 + 1 values out; `in` is left as it is. The two must not overlap.
  void forward(const double* in, Complex* out) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

enum class Direction { forward, backward };

// X[k] = sum_i x[i] exp(-+ 2 pi i k/n), minus for forward; not scaled.
class ComplexTransform {
 public:
  ComplexTransform(std::size_t n, Direction direction);
  ~ComplexTransform();
  ComplexTransform(ComplexTransform&&) noexcept;
  ComplexTransform& operator=(ComplexTransform&&) noexcept;

  std::size_t size() const;
  void inPlace(Complex* values) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

// Smallest number 2^a 3^b 5^c that is at least n: a length that transforms quickly.
std::size_t fastLength(std::size_t n);

}  // namespace squat::signals
