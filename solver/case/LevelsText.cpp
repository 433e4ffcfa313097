#include "case/LevelsText.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/DecimalNumber.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "text/DelimitedTable.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::cases {

namespace {

constexpr std::size_t largestLevelsFile = 20'000'000;  // bytes
constexpr std::size_t mostLevels = 60;
constexpr int inMillimetres = -3;

// "2.5119 cm" [m]; nothing where it is no length.
std::optional<double> lengthOf(std::string_view text) {
  text = text::trimmed(text);
  const std::size_t end = std::min(text.find_first_not_of("0123456789.,"), text.size());
  std::string number(text.substr(0, end));
  std::replace(number.begin(), number.end(), ',', '.');
  const auto value = parseDecimal(number);
  const auto* unit = text::findUnit(text::trimmed(text.substr(end)));
  return value && *value > 0 && unit && unit->si == "m" ? std::optional(*value * unit->factor) : std::nullopt;
}

bool isLevelUnit(const std::string& unit) { return text::lowerCase(text::bareUnit(unit)).starts_with("db"); }

class LevelsTable {
 public:
  LevelsTable(const text::DelimitedTable& table, std::string origin) : table_(table), origin_(std::move(origin)) {}

  std::vector<WavelengthLevel> levels() const {
    auto found = fromColumnNames();
    if (found.empty()) found = fromRows();
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.wavelength < b.wavelength; });
    if (const auto wrong = levelsMistake(found); !wrong.empty()) throw FileError(origin_, "", wrong, example());
    return found;
  }

 private:
  static const char* example() { return "Write a heading such as: wavelength [mm]; level [dB re 1 um]"; }

  std::vector<WavelengthLevel> fromColumnNames() const {
    std::vector<WavelengthLevel> found;
    for (const auto& column : table_.columns) {
      const auto wavelength = lengthOf(column.name);
      if (!wavelength || !isLevelUnit(column.unit)) continue;
      double sum = 0;
      int count = 0;
      for (const double level : column.values)
        if (std::isfinite(level)) sum += std::pow(10.0, level / 10), ++count;
      if (count > 0) found.push_back({*wavelength, 10 * std::log10(sum / count)});
    }
    return found;
  }

  std::vector<WavelengthLevel> fromRows() const {
    const text::TableColumn *wavelengths = nullptr, *levels = nullptr;
    double factor = 1;
    for (const auto& column : table_.columns) {
      const auto* unit = text::findUnit(text::bareUnit(column.unit));
      if (!wavelengths && unit && unit->si == "m") wavelengths = &column, factor = unit->factor;
      if (!levels && isLevelUnit(column.unit)) levels = &column;
    }
    if (!wavelengths) throw FileError(origin_, "heading", "no column of wavelengths in m, cm or mm", example());
    if (!levels) throw FileError(origin_, "heading", "no column of levels in dB", example());
    std::vector<WavelengthLevel> found;
    for (std::size_t i = 0; i < table_.rows(); ++i)
      if (std::isfinite(wavelengths->values[i]) && std::isfinite(levels->values[i]))
        found.push_back({wavelengths->values[i] * factor, levels->values[i]});
    return found;
  }

  const text::DelimitedTable& table_;
  std::string origin_;
};

}  // namespace

std::optional<std::vector<WavelengthLevel>> parseLevels(std::string_view text) {
  std::vector<WavelengthLevel> levels;
  if (text::trimmed(text).empty()) return levels;
  for (const auto& part : text::split(text, ',')) {
    const auto pair = text::split(part, ':');
    if (pair.size() != 2) return std::nullopt;
    const auto wavelength = parseDecimal(pair[0], inMillimetres), level = parseDecimal(pair[1]);
    if (!wavelength || !level) return std::nullopt;
    levels.push_back({*wavelength, *level});
  }
  return levels;
}

std::string formatLevels(const std::vector<WavelengthLevel>& levels) {
  std::string text;
  for (const auto& [wavelength, level] : levels)
    text += (text.empty() ? "" : ", ") + formatDecimal(wavelength, inMillimetres) + ": " + formatDecimal(level);
  return text;
}

std::string levelsMistake(const std::vector<WavelengthLevel>& levels) {
  if (levels.empty()) return "no levels";
  if (levels.size() > mostLevels) return "more than " + std::to_string(mostLevels) + " levels";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto& [wavelength, level] = levels[i];
    if (!(wavelength >= 1e-4 && wavelength <= 100)) return "a wavelength is not between 0.1 mm and 100 m";
    if (!(std::abs(level) <= 120)) return "a level is not between -120 and 120 dB re 1 um";
    if (i > 0 && !(wavelength > levels[i - 1].wavelength)) return "wavelengths do not ascend, or appear twice";
  }
  return {};
}

std::vector<WavelengthLevel> parseLevelsTable(std::string_view text, const std::string& origin) {
  return LevelsTable(text::parseDelimitedTable(text, origin), origin).levels();
}

std::vector<WavelengthLevel> readLevels(const std::filesystem::path& path) {
  return parseLevelsTable(readWholeFile(path.string(), largestLevelsFile), path.string());
}

}  // namespace squat::cases
