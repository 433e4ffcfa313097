// tests/studies/StubStudy.h - a study whose runs are a formula.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "core/Errors.h"
#include "studies/RunStudy.h"

namespace squat::studies {

// `lengths` times `depths` points.
inline StudyDefinition stubStudy(int lengths, int depths) {
  StudyDefinition study{"light-defect",
                        "12345678",
                        {variationFromText("defect.length=20:60:" + std::to_string(lengths)),
                         variationFromText("defect.depth=0.1:0.3:" + std::to_string(depths))}};
  study.program = "1.0";
  return study;
}

// Features that depend on the point alone, one of them without a value; the point 40, 0.2 fails.
inline std::optional<FeatureRow> stubRun(const StudyPoint& point, Monitor&) {
  if (point.values[0] == "40" && point.values[1] == "0.2")
    throw RunError("contact lost, \"for good\"", 7, 0.01, "element 3");
  const double length = std::stod(point.values[0]), depth = std::stod(point.values[1]);
  return FeatureRow{
      {"peak [m/s2]", length * depth / 3}, {"wavelength, mean [m]", 1 / length}, {"peak 2 [Hz]", std::nan("")}};
}

inline StudyOptions partOptions(const std::string& folder, const std::string& part, int jobs = 1) {
  StudyOptions options{folder, jobs, false};
  options.part = partitionFromText(part);
  return options;
}

}  // namespace squat::studies
