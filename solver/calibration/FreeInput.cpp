#include "calibration/FreeInput.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "text/Numbers.h"

namespace squat::calibration {

std::vector<FreeInput> freeInputsFromText(const std::vector<std::string>& texts) {
  return studies::inputRangesFromText(texts, "--free");
}

std::string valueText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

Values valuesAt(const std::vector<FreeInput>& inputs, const UnitPoint& point) {
  Values values;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double share = std::clamp(point[i], 0.0, 1.0);
    const double value = inputs[i].low + share * (inputs[i].high - inputs[i].low);
    values.push_back(text::numberFromText(valueText(value)).value_or(value));
  }
  return values;
}

UnitPoint pointOf(const std::vector<FreeInput>& inputs, const Values& values) {
  UnitPoint point;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    point.push_back((values[i] - inputs[i].low) / (inputs[i].high - inputs[i].low));
  return point;
}

}  // namespace squat::calibration
