# Debian's cross compiler for 64-bit Windows, MinGW-w64 with threads of POSIX. Libraries come from build/windows-packages,
# which .ci/windows makes, but for headers that are the same for every system: those of this machine, by links there.
# What it has made runs on this machine in Wine.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

cmake_path(SET squat_windows_packages NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../build/windows-packages)
set(CMAKE_FIND_ROOT_PATH ${squat_windows_packages} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${squat_windows_packages}/include)
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/lib/wine/wine64)

# One file that starts by itself, on Windows 10 and later.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
add_compile_definitions(_WIN32_WINNT=0x0A00 NOMINMAX WIN32_LEAN_AND_MEAN)
set(HDF5_USE_STATIC_LIBRARIES ON)
# HDF5's own compiler would say what the library of this machine needs.
set(HDF5_C_COMPILER_EXECUTABLE "" CACHE FILEPATH "None")
set(ZLIB_LIBRARY /usr/x86_64-w64-mingw32/lib/libz.a CACHE FILEPATH "Not the one that loads a DLL")
