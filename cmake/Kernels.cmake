# Kernels: what most of the time of a run goes into, written for the vectors of the processor. One binary for all
# processors of a kind: each unit is compiled for its own instruction set and chosen at run time.
#
# squat_kernels(NAME): adds NAMESse2.cpp, NAMEAvx2.cpp, ... to the solver and NAMEUnitsX86.cpp, which knows them; on
# other kinds of processor theirs.
#
# Multiplications and additions of the kernels become one operation, rounded once, wherever an instruction set has it
# (all but SSE2): the compiler's default for C++. Everything else of ours rounds twice, since not all x86 processors have
# it; so that it does on ARM as well, that default is turned off there, and on again for the kernels.
# (Eigen's vectors on ARM round once where Eigen says so.) What the kernels rely on is only that all instances of a loop
# are contracted alike, however its stations are grouped.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(kernel_processor X86)
  set(kernel_units Sse2 Avx2 Avx512)
  set(kernel_options_Sse2 -O3)
  set(kernel_options_Avx2 -O3 -mavx2 -mfma)
  set(kernel_options_Avx512 -O3 -mavx512f -mavx512dq -mavx512vl -mfma -mprefer-vector-width=512)
  if(WIN32)
    # The stack of 64-bit Windows is aligned to 16 bytes, and GCC puts vectors of 32 and 64 there all the same (GCC bug
    # 54412). The assembler makes moves of them that need no alignment; other instructions with AVX need none.
    foreach(unit Avx2 Avx512)
      list(APPEND kernel_options_${unit} -Wa,-muse-unaligned-vector-move)
    endforeach()
  endif()
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set(kernel_processor Arm64)
  set(kernel_units Neon)
  # Without the scheduling before registers are given out, which GCC leaves out on x86: it moves so many loads ahead
  # that the operator's sums go to the stack and back.
  set(kernel_options_Neon -O3 -ffp-contract=fast $<$<CXX_COMPILER_ID:GNU>:-fno-schedule-insns>)
  target_compile_options(squat_flags INTERFACE -ffp-contract=off)
else()
  message(FATAL_ERROR "no kernels for the processor '${CMAKE_SYSTEM_PROCESSOR}'; cmake/Kernels.cmake has those there are")
endif()

function(squat_kernels name)
  set(sources)
  foreach(unit IN LISTS kernel_units)
    list(APPEND sources ${name}${unit}.cpp)
  endforeach()
  squat_sources(squat_solver ${name}Units${kernel_processor}.cpp ALONE ${sources})
  foreach(unit IN LISTS kernel_units)
    set_source_files_properties(${name}${unit}.cpp TARGET_DIRECTORY squat_solver PROPERTIES
      COMPILE_OPTIONS "${kernel_options_${unit}}")
  endforeach()
endfunction()
