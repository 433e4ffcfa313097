// The kernels on 64-bit ARM: what only its processors have, then the body; LANES and WIDEST are set.
namespace squat::elasticity {
namespace {

// As on x86 (SweptKernelX86.inl). One bit flushes what goes in and what comes out.
struct FlushTiny {
  unsigned long before;
  FlushTiny() {
    asm volatile("mrs %0, fpcr" : "=r"(before));
    asm volatile("msr fpcr, %0" : : "r"(before | 1UL << 24) : "memory");
  }
  ~FlushTiny() { asm volatile("msr fpcr, %0" : : "r"(before) : "memory"); }
  FlushTiny(const FlushTiny&) = delete;
  FlushTiny& operator=(const FlushTiny&) = delete;
};

// Asks for a line of memory.
inline void ask(const double* p) { asm volatile("prfm pldl1keep, %a0" : : "p"(p)); }

// A value that stays in its register.
template <typename Packed>
inline Packed fixed(Packed value) {
  asm("" : "+w"(value));
  return value;
}

}  // namespace
}  // namespace squat::elasticity

#include "elasticity/SweptKernel.inl"
