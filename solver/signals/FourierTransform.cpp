#include "signals/FourierTransform.h"

#include <fftw3.h>

#include <mutex>
#include <new>

namespace squat::signals {
namespace {

// FFTW: everything but execute shares state and must be kept to one thread at a time.
std::mutex& plannerMutex() {
  static std::mutex mutex;
  return mutex;
}

fftw_complex* raw(Complex* values) { return reinterpret_cast<fftw_complex*>(values); }

void requireMemory(const void* memory) {
  if (!memory) throw std::bad_alloc();
}

}  // namespace

// Plans are made on FFTW's own memory and executed on the caller's. A plan without FFTW_UNALIGNED wants the alignment
// it was made with (16 bytes); vectors of Complex have it, an odd offset in a vector of double has not.
struct Plans {
  std::size_t n = 0;
  fftw_plan aligned = nullptr, unaligned = nullptr;
  ~Plans() {
    const std::lock_guard lock(plannerMutex());
    if (aligned) fftw_destroy_plan(aligned);
    if (unaligned) fftw_destroy_plan(unaligned);
  }
};

struct RealTransform::Plan : Plans {};

RealTransform::RealTransform(std::size_t n) : plan_(std::make_unique<Plan>()) {
  plan_->n = n;
  const std::lock_guard lock(plannerMutex());
  double* in = fftw_alloc_real(n);
  fftw_complex* out = fftw_alloc_complex(n / 2 + 1);
  if (in && out) {
    const unsigned flags = FFTW_ESTIMATE | FFTW_PRESERVE_INPUT;
    plan_->aligned = fftw_plan_dft_r2c_1d(static_cast<int>(n), in, out, flags);
    plan_->unaligned = fftw_plan_dft_r2c_1d(static_cast<int>(n), in, out, flags | FFTW_UNALIGNED);
  }
  fftw_free(in);
  fftw_free(out);
  requireMemory(plan_->aligned);
  requireMemory(plan_->unaligned);
}
RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;

std::size_t RealTransform::size() const { return plan_->n; }

void RealTransform::forward(const double* in, Complex* out) const {
  // FFTW's interface takes a pointer to non-const; FFTW_PRESERVE_INPUT promises not to write.
  auto* input = const_cast<double*>(in);
  const bool aligned = fftw_alignment_of(input) == 0 && fftw_alignment_of(reinterpret_cast<double*>(out)) == 0;
  fftw_execute_dft_r2c(aligned ? plan_->aligned : plan_->unaligned, input, raw(out));
}

struct ComplexTransform::Plan : Plans {};

ComplexTransform::ComplexTransform(std::size_t n, Direction direction) : plan_(std::make_unique<Plan>()) {
  plan_->n = n;
  const int sign = direction == Direction::forward ? FFTW_FORWARD : FFTW_BACKWARD;
  const std::lock_guard lock(plannerMutex());
  fftw_complex* values = fftw_alloc_complex(n);
  if (values) {
    plan_->aligned = fftw_plan_dft_1d(static_cast<int>(n), values, values, sign, FFTW_ESTIMATE);
    plan_->unaligned = fftw_plan_dft_1d(static_cast<int>(n), values, values, sign, FFTW_ESTIMATE | FFTW_UNALIGNED);
  }
  fftw_free(values);
  requireMemory(plan_->aligned);
  requireMemory(plan_->unaligned);
}
ComplexTransform::~ComplexTransform() = default;
ComplexTransform::ComplexTransform(ComplexTransform&&) noexcept = default;
ComplexTransform& ComplexTransform::operator=(ComplexTransform&&) noexcept = default;

std::size_t ComplexTransform::size() const { return plan_->n; }

void ComplexTransform::inPlace(Complex* values) const {
  const bool aligned = fftw_alignment_of(reinterpret_cast<double*>(values)) == 0;
  fftw_execute_dft(aligned ? plan_->aligned : plan_->unaligned, raw(values), raw(values));
}

std::size_t fastLength(std::size_t n) {
  if (n <= 1) return 1;
  std::size_t best = 1;
  while (best < n) best *= 2;
  for (std::size_t fives = 1; fives < best; fives *= 5)
    for (std::size_t threes = fives; threes < best; threes *= 3) {
      std::size_t candidate = threes;
      while (candidate < n) candidate *= 2;
      if (candidate < best) best = candidate;
    }
  return best;
}

}  // namespace squat::signals
