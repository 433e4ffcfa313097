// solver/results/Hdf5.h - an ArrayTree as an HDF5 file, both ways. All use of the HDF5 library stays behind this
// header.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/ArrayTree.h"

namespace squat::results {

// What a file may hold at most; a file beyond is refused before memory is taken.
struct Hdf5Limits {
  std::size_t bytes = std::size_t{384} << 20;  // of all values together, uncompressed
  std::size_t objects = 20000;
  std::size_t rank = 4;
  std::size_t chunkBytes = std::size_t{32} << 20;
  // Files of other programs (measured signals): soft links, named types and datasets that are neither numbers nor text
  // are passed over instead of refused. Datasets of records give an array for each field of numbers, "/dataset/field";
  // datasets of references give the paths of their objects, with `referencesAttribute`.
  bool skipForeign = false;
  // Datasets with more values than this come without them: their type, shape and attributes alone. Such a tree can
  // not be written again.
  std::size_t valuesUpTo = static_cast<std::size_t>(-1);
  // Groups that are passed over with all that is in them ("/fields"). Such a tree can not be written again either.
  std::vector<std::string> without = {};
};

// The image of an HDF5 file in memory. Nothing touches the disk, so a full disk cannot leave the library in a bad
// state. Datasets above 1 kB are shuffled and deflated; no time stamps: equal trees give equal bytes. Throws
// FileError(path, object, ...) where the library refuses.
std::vector<std::byte> encodeHdf5(const ArrayTree& tree, const std::string& path);

// Attribute of the root of a listed tree (Hdf5Stream.h) whose file is cut off: what is missing, in words.
inline constexpr const char* truncationAttribute = "file cut off";
// Attribute of an array of paths that stands for references: cells and arrays of structures in MATLAB 7.3.
inline constexpr const char* referencesAttribute = "references";
// A slash in a field's name stands in its path as this character, which looks like one.
inline constexpr const char* slashInName = "\u2215";

// Reads an untrusted file. Refused with FileError naming the object: external storage, links other
// than hard ones, virtual layouts, filters other than shuffle, deflate and checksum, extents beyond the limits or
// beyond what the file can hold, types other than numbers and text. The library itself is old and not proof against
// damaged files: the work is done in a program of its own with limits on memory and time, whose death is a FileError
// here.
ArrayTree readHdf5(const std::string& path, const Hdf5Limits& limits = {});

// The same without the other program, for files that this process has just written.
ArrayTree readOwnHdf5(const std::string& path, const Hdf5Limits& limits = {});

}  // namespace squat::results
