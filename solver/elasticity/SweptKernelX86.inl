// The kernels on x86: what only its processors have, then the body; LANES and WIDEST are set.
namespace squat::elasticity {
namespace {

// While one stands, numbers too small for full precision count as zero: ahead of a wave front they would cost some
// processors a hundred times the work.
struct FlushTiny {
  unsigned before = __builtin_ia32_stmxcsr();
  FlushTiny() { __builtin_ia32_ldmxcsr(before | 0x8040); }  // flush to zero, denormals are zero
  ~FlushTiny() { __builtin_ia32_ldmxcsr(before); }
  FlushTiny(const FlushTiny&) = delete;
  FlushTiny& operator=(const FlushTiny&) = delete;
};

// Asks for a line of memory. Assembly, for GCC takes a function of nothing but __builtin_prefetch for an empty one and
// leaves out its calls.
inline void ask(const double* p) { asm volatile("prefetcht0 %0" : : "m"(*p)); }

// A value that stays in its register: without this the compiler loads it anew for each of its three products.
template <typename Packed>
inline Packed fixed(Packed value) {
#if LANES == 8
  asm("" : "+v"(value));
#else
  asm("" : "+x"(value));
#endif
  return value;
}

}  // namespace
}  // namespace squat::elasticity

#include "elasticity/SweptKernel.inl"
