#include "analysis/FeatureTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "analysis/RunFeatures.h"
#include "signals/SignalCatalogue.h"
#include "signals/SignalError.h"
#include "text/Text.h"

namespace squat::analysis {

namespace {

// What a row of the catalogue says of a feature, whose name is as featureTable gives it, without unit and band.
struct Meaning {
  std::string_view name, title, meaning;
};
// First match counts.
constexpr std::array<Meaning, 16> kMeanings{{
    {"speed", "Speed at the defect", "of the wheel where it passes the anchor"},
    {"impact time", "Time of the impact", "of the anchor, since the start of the record"},
    {"peak to peak", "Largest less smallest acceleration", "largest less smallest value of aba_filtered"},
    {"peak", "Largest acceleration, up or down", "largest absolute value of aba_filtered"},
    {"maximum", "Largest acceleration", "largest value of aba_filtered"},
    {"minimum", "Smallest acceleration", "smallest value of aba_filtered"},
    {"rms", "Root mean square of the acceleration", "root mean square of aba_filtered, whole record"},
    {"largest moving rms", "Largest root mean square over 250 mm",
     "largest root mean square of aba_filtered over 250 mm"},
    {"wavelength by crossings", "Wavelength behind the defect, by zero crossings",
     "mean after the impact, from the zero crossings; not a number: fewer than three"},
    {"wavelength by ridge", "Wavelength behind the defect, by wavelets",
     "mean after the impact, from the ridge of the wavelet transform; not a number: no waves"},
    {"power", "Power", "integral of the spectrum of aba_filtered over the band"},
    {"free vibration", "Free vibration", "until the band has decayed to a tenth; not a number: longer than the record"},
    {"spectrum integral", "Integral of the spectrum", "of the density around the anchor, over all frequencies"},
    {"spectrum mean square", "Mean square around the defect",
     "of the samples around the anchor: what the integral should be"},
    {"smallest contact force", "Smallest contact force", "smallest vertical force on the rail"},
    {"largest contact force", "Largest contact force", "largest vertical force on the rail"},
}};

// "peak 2 width": of the peaks of the spectrum around the anchor, the most prominent first.
constexpr std::array<Meaning, 3> kPeakMeanings{{
    {"frequency", "Line N of the spectrum",
     "of peak N of the spectrum around the anchor (100 mm before to 280 mm behind it)"},
    {"width", "Width of line N", "of that peak, at half its prominence"},
    {"prominence", "Prominence of line N", "of that peak: its height above the higher of the two valleys beside it"},
}};

// "2 width" of "peak 2 width"; empty for any other name.
std::string_view peakIn(std::string_view name) {
  constexpr std::string_view peak = "peak ";
  const bool isPeak =
      name.starts_with(peak) && name.size() > peak.size() + 2 && name[peak.size()] >= '1' && name[peak.size()] <= '9';
  return isPeak ? name.substr(peak.size()) : std::string_view();
}

// `part` of the row that such a peak has; empty where there is none.
std::string ofPeak(std::string_view peak, std::string_view Meaning::*part) {
  for (const auto& row : kPeakMeanings) {
    if (!peak.substr(2).starts_with(row.name)) continue;
    std::string text(row.*part);
    if (const auto at = text.find('N'); at != std::string::npos) text[at] = peak[0];
    return text;
  }
  return {};
}

const Meaning* meaningRow(std::string_view name) {
  const auto found =
      std::find_if(kMeanings.begin(), kMeanings.end(), [&](const auto& row) { return name.starts_with(row.name); });
  return found == kMeanings.end() ? nullptr : &*found;
}

// Of another axle box than the first: "right peak [m/s2]".
struct OtherBox {
  std::string_view whose, signal, wheel;
};
constexpr std::array<OtherBox, 3> kOthers{{
    {"right second ", "second_aba_right_filtered", ", of the right wheel of the second wheelset"},
    {"right ", "aba_right_filtered", ", of the right wheel"},
    {"second ", "second_aba_filtered", ", of the wheel of the second wheelset"},
}};

std::string meaningOf(const std::string& column) {
  constexpr std::string_view first = "aba_filtered";
  for (const auto& [whose, signal, wheel] : kOthers) {
    if (!column.starts_with(whose)) continue;
    auto text = meaningOf(column.substr(whose.size()));
    const auto at = text.find(first);
    return at == std::string::npos ? text + std::string(wheel) : text.replace(at, first.size(), signal);
  }
  if (const auto peak = peakIn(column); !peak.empty()) {
    const auto text = ofPeak(peak, &Meaning::meaning);
    return text.empty() ? text : text + "; not a number: fewer peaks";
  }
  const auto* row = meaningRow(column);
  return row ? std::string(row->meaning) : std::string();
}

// "peak [m/s2]" -> "m/s2"
std::string unitIn(const std::string& column) {
  const auto from = column.find('['), to = column.rfind(']');
  return from == std::string::npos || to == std::string::npos ? std::string() : column.substr(from + 1, to - from - 1);
}

using Row = std::vector<std::pair<std::string, double>>;

void addForces(const results::RunResult& result, const std::string& signal, const std::string& side, Row& row) {
  const auto* force = result.signal(signal);
  if (!force || force->empty()) return;
  const auto [low, high] = std::minmax_element(force->begin(), force->end());
  row.emplace_back(side + "smallest contact force [N]", *low);
  row.emplace_back(side + "largest contact force [N]", *high);
}

// What another axle box feels, beside all that is said of the first one: of the other side, of a bogie's other
// wheelset.
void addOther(const results::RunResult& result, const std::string& filtered, const std::string& force,
              const std::string& whose, Row& row) {
  const auto* values = result.signal(filtered);
  if (!values || values->empty()) return;
  const auto [low, high] = std::minmax_element(values->begin(), values->end());
  double squares = 0;
  for (const double value : *values) squares += value * value;
  row.emplace_back(whose + "peak [m/s2]", std::max(std::abs(*low), std::abs(*high)));
  row.emplace_back(whose + "maximum [m/s2]", *high);
  row.emplace_back(whose + "minimum [m/s2]", *low);
  row.emplace_back(whose + "rms [m/s2]", std::sqrt(squares / static_cast<double>(values->size())));
  addForces(result, force, whose, row);
}

}  // namespace

std::vector<std::pair<std::string, double>> featureTable(const results::RunResult& result) {
  auto row = signals::featureRow(runFeatures(result));
  addForces(result, signals::names::contactForce, "", row);
  namespace names = signals::names;
  const auto onRight = [](const char* name) { return std::string(name) + "_right"; };
  addOther(result, signals::filteredNameOnRight(names::axleBox), onRight(names::contactForce), "right ", row);
  addOther(result, names::secondAxleBoxFiltered, names::secondContactForce, "second ", row);
  addOther(result, signals::filteredNameOnRight(names::secondAxleBox), onRight(names::secondContactForce),
           "right second ", row);
  return row;
}

std::string featureWord(const std::string& column) {
  std::string word(text::trimmed(column.substr(0, column.find('['))));
  std::replace(word.begin(), word.end(), ' ', '_');
  word.erase(std::remove(word.begin(), word.end(), ','), word.end());
  return word;
}

std::string featureTitle(const std::string& name) {
  std::string words(text::trimmed(name.substr(0, name.find('['))));
  std::replace(words.begin(), words.end(), '_', ' ');
  for (const auto& [whose, signal, wheel] : kOthers)
    if (words.starts_with(whose)) return featureTitle(words.substr(whose.size())) + std::string(wheel);
  if (const auto peak = peakIn(words); !peak.empty())
    if (auto title = ofPeak(peak, &Meaning::title); !title.empty()) return title;
  const auto* row = meaningRow(words);
  if (!row) return words;
  const auto band = text::trimmed(std::string_view(words).substr(row->name.size()));
  return std::string(row->title) + (band.empty() ? "" : ", " + std::string(band));
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
