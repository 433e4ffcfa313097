// solver/loggers/UniversalFunction.h - one dataset 58 of a universal file: a function at a point of a structure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "loggers/UniversalText.h"

namespace squat::loggers {

// From dataset 164: a value in the file's units divided by the factor is in SI. SI where there is none.
struct UniversalUnits {
  double length = 1, force = 1;
};

struct UniversalQuantity {
  long code = 0;     // 8 displacement, 11 velocity, 12 acceleration, 13 force, 17 time, 18 frequency
  std::string unit;  // the label; empty: NONE
};

struct UniversalFunction {
  long type = 0;                           // 0 general, 1 time response, 4 frequency response
  std::string title, response, reference;  // ID line 1; "12 +Z"; empty where the file has none
  UniversalQuantity abscissa, ordinate, denominator;
  UniversalUnits units;
  bool even = true, isComplex = false;
  double start = 0, step = 0;  // of an even abscissa
  std::string stepText;        // as it is written
  std::vector<double> x;       // of an uneven abscissa, finite
  std::vector<double> real, imaginary;

  std::size_t size() const { return real.size(); }
};

// All functions of the file. One that the end of the file cuts short is left out, with a note. Throws FileError with
// the line or dataset: not IEEE numbers, an unknown kind of ordinate, fewer values than stated, text among the values.
std::vector<UniversalFunction> universalFunctions(std::string_view bytes, const std::string& path,
                                                  std::vector<std::string>& notes);

}  // namespace squat::loggers
