#include "loggers/TdmsScales.h"

#include <algorithm>
#include <cmath>

#include "text/Text.h"

namespace squat::loggers {
namespace {

constexpr double tdmsRawInput = 0xFFFFFFFF;  // input of a scale: the values themselves
constexpr double tdmsMostScales = 100, tdmsMostCoefficients = 100;

// "NI_Scale[2]_Linear_"
std::string tdmsScaleName(std::size_t scale, const std::string& rest) {
  return "NI_Scale[" + std::to_string(scale) + "]_" + rest;
}

// How many scales the properties speak of; most writers say, some only number them.
double tdmsScaleCount(const TdmsProperties& properties) {
  if (const auto count = tdmsNumber(properties, "NI_Number_Of_Scales")) return *count;
  double count = 0;
  while (count <= tdmsMostScales && properties.count(tdmsScaleName(static_cast<std::size_t>(count), "Scale_Type")) > 0)
    ++count;
  return count;
}

// The coefficients of one scale; none: one is missing, or they are no numbers.
std::vector<double> tdmsCoefficients(const TdmsProperties& properties, std::size_t scale, std::string_view type) {
  std::vector<double> coefficients;
  const auto take = [&](const std::string& rest) {
    const auto number = tdmsNumber(properties, tdmsScaleName(scale, rest));
    if (number && std::isfinite(*number)) coefficients.push_back(*number);
    return number && std::isfinite(*number);
  };
  if (type == "Linear") {
    if (take("Linear_Y_Intercept") && take("Linear_Slope")) return coefficients;
    return {};
  }
  // Four, where nothing else is said.
  const double size = tdmsNumber(properties, tdmsScaleName(scale, "Polynomial_Coefficients_Size")).value_or(4);
  if (!(size >= 1 && size <= tdmsMostCoefficients)) return {};
  for (int i = 0; i < size; ++i)
    if (!take("Polynomial_Coefficients[" + std::to_string(i) + "]")) return {};
  return coefficients;
}

// Walks from the last scale, whose output counts, through what each takes as its input to the raw values.
TdmsScaling tdmsChain(const TdmsObject& channel, const TdmsProperties& properties, double count) {
  TdmsScaling scaling;
  if (!(count <= tdmsMostScales)) return {{}, "it has too many scales"};
  double scale = count - 1;
  while (scale != tdmsRawInput) {
    if (!(scale >= 0 && scale < count) || scaling.steps.size() >= static_cast<std::size_t>(count))
      return {{}, "its scales do not lead to its values"};
    const auto i = static_cast<std::size_t>(scale);
    const std::string name = "scale " + std::to_string(i);
    const auto type = tdmsText(properties, tdmsScaleName(i, "Scale_Type"));
    if (type.empty()) {
      // The values of a data acquisition card stand in the place of a scale.
      const bool card = channel.index && !channel.index->type && channel.index->scalers.size() == 1;
      if (card && channel.index->scalers[0].id == i) break;
      return {{}, "its " + name + " has no type"};
    }
    if (type != "Linear" && type != "Polynomial")
      return {{}, "its " + name + " is of the type " + text::shown(type) + "; linear and polynomial scales are read"};
    auto coefficients = tdmsCoefficients(properties, i, type);
    if (coefficients.empty()) return {{}, "its " + name + " lacks coefficients"};
    scaling.steps.push_back(std::move(coefficients));
    scale = tdmsNumber(properties, tdmsScaleName(i, std::string(type) + "_Input_Source")).value_or(tdmsRawInput);
  }
  std::reverse(scaling.steps.begin(), scaling.steps.end());
  return scaling;
}

}  // namespace

TdmsScaling tdmsScaling(const TdmsObject& channel, const TdmsProperties& group, const TdmsProperties& file) {
  for (const auto* properties : {&channel.properties, &group, &file}) {
    const double count = tdmsScaleCount(*properties);
    if (tdmsText(*properties, "NI_Scaling_Status") == "scaled") return {};
    if (count >= 1) return tdmsChain(channel, *properties, std::floor(count));
  }
  return {};
}

void applyTdmsScaling(const TdmsScaling& scaling, std::vector<double>& values) {
  for (const auto& step : scaling.steps)
    for (double& value : values) {
      double sum = 0;
      for (std::size_t i = step.size(); i-- > 0;) sum = sum * value + step[i];
      value = sum;
    }
}

}  // namespace squat::loggers
