// solver/studies/SampledPoints.h - points of a study that are no grid: sampled between limits, or from a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "studies/StudyGrid.h"

namespace squat::studies {

// Points in the unit cube, one vector each. The same seed gives the same points on every machine.
// Sobol's sequence (direction numbers of Joe and Kuo, Boost.Random) with a digital shift, one for each coordinate: any
// 2^k points from the start hold one in each of 2^k equal intervals, in every coordinate.
std::vector<std::vector<double>> sobolPoints(std::size_t count, std::size_t dimensions, std::uint64_t seed);
// Latin hypercube: one point at a random place in each of `count` equal intervals, in every coordinate.
std::vector<std::vector<double>> latinHypercubePoints(std::size_t count, std::size_t dimensions, std::uint64_t seed);

// `sample` is "sobol:256" or "latin-hypercube:200", `ranges` are texts KEY=LOW:HIGH. Values row by row. Throws
// CaseError.
std::vector<Variation> sampledVariations(const std::vector<std::string>& ranges, const std::string& sample,
                                         std::uint64_t seed);

// From a file of comma-separated values: keys in its first line, a point in each other one. FileError (line).
std::vector<Variation> variationsFromFile(const std::string& path);

}  // namespace squat::studies
