# Shared flags as INTERFACE targets: link squat::flags PRIVATE.
add_library(squat_flags INTERFACE)
add_library(squat::flags ALIAS squat_flags)
target_compile_features(squat_flags INTERFACE cxx_std_20)
target_compile_options(squat_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
# GCC 12 warns of overlaps and overflows in std::string's own operator+ (GCC bug 105651).
target_compile_options(squat_flags INTERFACE "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow>")
if(SQUAT_SANITIZERS)
  target_compile_options(squat_flags INTERFACE -fsanitize=${SQUAT_SANITIZERS} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(squat_flags INTERFACE -fsanitize=${SQUAT_SANITIZERS})
endif()
if(SQUAT_FUZZERS)
  target_compile_options(squat_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
