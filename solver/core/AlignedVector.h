// solver/core/AlignedVector.h - contiguous doubles on a 64-byte boundary, for vector loads.
//
// Large arrays lie on 2 MB boundaries and ask the system for pages of that size: the kernels read hundreds of lines
// at once, thousands of bytes apart, which small pages would turn into as many misses of the address cache.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "core/platform/Memory.h"

namespace squat {

template <typename T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <typename U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  static constexpr std::size_t largePage = std::size_t{1} << 21;
  static std::align_val_t alignment(std::size_t n) {
    return std::align_val_t{n * sizeof(T) >= largePage ? largePage : 64};
  }
  T* allocate(std::size_t n) {
    void* p = ::operator new(n * sizeof(T), alignment(n));
    if (n * sizeof(T) >= largePage) platform::wishLargePages(p, n * sizeof(T));
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n)); }
  template <typename U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};

using AlignedVector = std::vector<double, AlignedAllocator<double>>;

}  // namespace squat
