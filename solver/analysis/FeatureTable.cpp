#include "analysis/FeatureTable.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "analysis/RunFeatures.h"
#include "signals/SignalError.h"
#include "text/Text.h"

namespace squat::analysis {

namespace {

// Names as featureTable gives them, without their units, up to the name of a band or of a peak.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kMeanings{{
    {"speed", "of the wheel where it passes the anchor"},
    {"impact time", "of the anchor, since the start of the record"},
    {"peak to peak", "largest less smallest value of aba_filtered"},
    {"peak 1", "most prominent peak of the spectrum from 100 mm before to 280 mm behind the anchor"},
    {"peak 2", "second peak of that spectrum; not a number: there are fewer"},
    {"peak 3", "third peak of that spectrum; not a number: there are fewer"},
    {"peak 4", "fourth peak of that spectrum; not a number: there are fewer"},
    {"peak", "largest absolute value of aba_filtered"},
    {"maximum", "largest value of aba_filtered"},
    {"minimum", "smallest value of aba_filtered"},
    {"rms", "root mean square of aba_filtered, whole record"},
    {"largest moving rms", "largest root mean square of aba_filtered over 250 mm"},
    {"wavelength by", "mean wavelength of aba_filtered after the impact; not a number: too few waves"},
    {"power", "integral of the spectrum of aba_filtered over the band"},
    {"free vibration", "until the band has decayed to a tenth; not a number: longer than the record"},
    {"spectrum", "of the spectrum of aba_filtered around the anchor"},
    {"smallest contact force", "smallest vertical force on the rail"},
    {"largest contact force", "largest vertical force on the rail"},
}};

std::string meaningOf(const std::string& column) {
  const auto found = std::find_if(kMeanings.begin(), kMeanings.end(),
                                  [&](const auto& meaning) { return column.starts_with(meaning.first); });
  return found == kMeanings.end() ? std::string() : std::string(found->second);
}

// "peak [m/s2]" -> "m/s2"
std::string unitIn(const std::string& column) {
  const auto from = column.find('['), to = column.rfind(']');
  return from == std::string::npos || to == std::string::npos ? std::string() : column.substr(from + 1, to - from - 1);
}

}  // namespace

std::vector<std::pair<std::string, double>> featureTable(const results::RunResult& result) {
  auto row = signals::featureRow(runFeatures(result));
  if (const auto* force = result.signal("contact_force"); force && !force->empty()) {
    const auto [low, high] = std::minmax_element(force->begin(), force->end());
    row.emplace_back("smallest contact force [N]", *low);
    row.emplace_back("largest contact force [N]", *high);
  }
  return row;
}

std::string featureWord(const std::string& column) {
  std::string word(text::trimmed(column.substr(0, column.find('['))));
  std::replace(word.begin(), word.end(), ' ', '_');
  word.erase(std::remove(word.begin(), word.end(), ','), word.end());
  return word;
}

std::vector<results::Scalar> featureScalars(const results::RunResult& result) {
  std::vector<results::Scalar> list;
  try {
    for (const auto& [column, value] : featureTable(result))
      list.push_back({featureWord(column), unitIn(column), meaningOf(column), value});
  } catch (const signals::SignalError&) {
    return {};
  }
  return list;
}

}  // namespace squat::analysis
