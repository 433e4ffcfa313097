#include "calibration/ReceptanceResiduals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/Errors.h"
#include "readers/TableFile.h"
#include "signals/Resample.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::calibration {

namespace {

using text::TableColumn;

constexpr double kDegree = std::numbers::pi / 180;

using text::lowerCase;

// A unit of a frequency response: its factor to SI, and how often the displacement in it is derived by the time:
// receptance 0, mobility 1, accelerance 2.
struct ResponseUnit {
  double factor = 1;
  int derivatives = 0;
};

std::optional<ResponseUnit> responseUnit(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '(' || c == ')' || c == '^' || c == '*'; });
  text = lowerCase(text);
  const std::size_t slash = text.rfind('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto force = text.substr(slash + 1), motion = text.substr(0, slash);
  const auto* known = text::findUnit(motion == "nm" ? "m" : motion);
  if ((force != "n" && force != "kn") || !known) return std::nullopt;
  const int derivatives = known->si == "m" ? 0 : known->si == "m/s" ? 1 : known->si == "m/s2" ? 2 : -1;
  if (derivatives < 0) return std::nullopt;
  return ResponseUnit{known->factor * (motion == "nm" ? 1e-9 : 1) / (force == "kn" ? 1e3 : 1), derivatives};
}

// To receptance [m/N] at a frequency [Hz].
std::complex<double> scaleOf(const TableColumn& column, double frequency, const std::string& path) {
  const auto unit = responseUnit(column.unit);
  if (!unit)
    throw FileError(
        path, "column '" + column.name + "'",
        column.unit.empty() ? "states no unit" : "unit is '" + column.unit + "', must be m/N",
        "Known are m/N, mm/kN, um/kN, nm/N and the like, mobilities in m/s/N, accelerances in m/s2/N or g/N; "
        "write the unit behind the name");
  return unit->factor / std::pow(std::complex<double>(0, 2 * std::numbers::pi * frequency), unit->derivatives);
}

// [rad] for one of the column's unit.
double angleOf(const TableColumn& column, const std::string& path) {
  const auto unit = lowerCase(column.unit);
  if (unit == "rad" || unit == "radian" || unit == "radians") return 1;
  if (unit == "deg" || unit == "degree" || unit == "degrees" || unit == "\xC2\xB0") return kDegree;
  throw FileError(path, "column '" + column.name + "'",
                  unit.empty() ? "states no unit" : "unit is '" + column.unit + "', must be deg or rad",
                  "Write the unit behind the name: phase [deg] or phase [rad]");
}

// Whether a word of letters stands in the name by itself.
bool hasWord(const std::string& name, std::string_view word) {
  const auto isLetter = [&](std::size_t at) { return at < name.size() && name[at] >= 'a' && name[at] <= 'z'; };
  for (std::size_t at = name.find(word); at != std::string::npos; at = name.find(word, at + 1))
    if (!(at > 0 && isLetter(at - 1)) && !isLetter(at + word.size())) return true;
  return false;
}

// The columns of one point, by what they hold.
struct ReceptanceColumns {
  const TableColumn *magnitude = nullptr, *real = nullptr, *imaginary = nullptr, *phase = nullptr;
};

ReceptanceColumns columnsOf(const text::DelimitedTable& table, const ReceptanceTarget& target) {
  const auto namesPoint = [&](const TableColumn& column) {
    return lowerCase(column.name).find(target.point) != std::string::npos;
  };
  const bool parted = std::any_of(table.columns.begin(), table.columns.end(), namesPoint);
  ReceptanceColumns found;
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    const auto& column = table.columns[i];
    if (parted && !namesPoint(column)) continue;
    const auto name = lowerCase(column.name);
    const auto holds = [&](const char* word) { return name.find(word) != std::string::npos; };
    if (holds("coher")) continue;  // of a hammer test
    if (holds("imag") || hasWord(name, "im"))
      found.imaginary = &column;
    else if (holds("real") || hasWord(name, "re"))
      found.real = &column;
    else if (holds("phase") || hasWord(name, "angle") || hasWord(name, "arg"))
      found.phase = &column;
    else if (!found.magnitude || holds("magn"))
      found.magnitude = &column;
  }
  const bool isComplex = found.real && found.imaginary;
  if (!found.magnitude && !isComplex)
    throw FileError(target.file, "line 1", "has no column of magnitudes, nor of real and imaginary parts",
                    "Name the columns, e.g. frequency [Hz], magnitude [m/N], phase [deg]");
  return found;
}

std::complex<double> valueAt(const ReceptanceColumns& columns, std::size_t row, double frequency,
                             const std::string& path) {
  if (columns.real && columns.imaginary)
    return columns.real->values[row] * scaleOf(*columns.real, frequency, path) +
           std::complex<double>(0, 1) * columns.imaginary->values[row] * scaleOf(*columns.imaginary, frequency, path);
  const double magnitude = columns.magnitude->values[row];
  const auto scale = scaleOf(*columns.magnitude, frequency, path);
  if (!columns.phase) return std::abs(magnitude * scale);
  return std::polar(std::abs(magnitude), columns.phase->values[row] * angleOf(*columns.phase, path)) * scale;
}

// At most so many frequencies, in equal ratios: a measurement in steps of 1 Hz does not know more than its resonances.
std::vector<std::size_t> thinned(const std::vector<double>& frequency, std::size_t maximum) {
  std::vector<std::size_t> kept;
  const double ratio = std::pow(frequency.back() / frequency.front(), 1.0 / static_cast<double>(maximum));
  double next = frequency.front();
  for (std::size_t i = 0; i < frequency.size(); ++i)
    if (frequency[i] >= next) kept.push_back(i), next = frequency[i] * ratio;
  return kept;
}

std::complex<double> computedAt(const receptance::TrackReceptance& computed, const std::string& point,
                                double frequency) {
  for (const auto& one : computed.points) {
    if (one.name != point) continue;
    std::vector<double> real, imaginary;
    for (const auto& value : one.receptance) real.push_back(value.real()), imaginary.push_back(value.imag());
    return {signals::interpolateLinear(computed.frequency, real, frequency),
            signals::interpolateLinear(computed.frequency, imaginary, frequency)};
  }
  return 0;
}

}  // namespace

MeasuredReceptance readMeasuredReceptance(const ReceptanceTarget& target) {
  constexpr std::size_t maximum = 60;
  const auto table = readers::readTableFile(target.file).table;
  if (table.columns.size() < 2)
    throw FileError(target.file, "", "must have a column of frequencies and one of magnitudes at least");
  if (const auto& unit = table.columns[0].unit; !unit.empty() && unit != "Hz")
    throw FileError(target.file, "column '" + table.columns[0].name + "'", "unit is '" + unit + "', must be Hz");
  const auto columns = columnsOf(table, target);
  std::vector<double> frequency;
  std::vector<std::complex<double>> values;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double f = table.columns[0].values[row];
    if (!(f >= target.lowest && f <= target.highest)) continue;
    const auto value = valueAt(columns, row, f, target.file);
    if (!std::isfinite(value.real()) || !std::isfinite(value.imag()) || std::abs(value) == 0)
      throw FileError(target.file, table.rowWord + " " + std::to_string(table.lines[row]), "has no receptance");
    if (!frequency.empty() && f <= frequency.back())
      throw FileError(target.file, table.rowWord + " " + std::to_string(table.lines[row]), "frequency does not rise");
    frequency.push_back(f), values.push_back(value);
  }
  if (frequency.size() < 3)
    throw FileError(target.file, "", "has fewer than three frequencies within the limits of the target",
                    "Change \"lowest\" and \"highest\" [Hz]");
  const bool isComplex = columns.real && columns.imaginary;
  MeasuredReceptance measured{target, {}, {}, isComplex || columns.phase};
  for (const std::size_t i : thinned(frequency, maximum))
    measured.frequency.push_back(frequency[i]), measured.receptance.push_back(values[i]);
  return measured;
}

TargetValue receptanceValue(const MeasuredReceptance& measured, const receptance::TrackReceptance& computed) {
  constexpr double degreesOfOneDecibel = 6.6;  // ln(10) / 20 rad: in ln H = ln |H| + i arg H both weigh the same
  TargetValue value;
  const double tolerance = measured.target.tolerance;
  double sum = 0;
  for (std::size_t i = 0; i < measured.frequency.size(); ++i) {
    const auto ours = computedAt(computed, measured.target.point, measured.frequency[i]);
    const auto theirs = measured.receptance[i];
    value.residuals.push_back(20 * std::log10(std::abs(ours) / std::abs(theirs)) / tolerance);
    if (measured.hasPhase)
      value.residuals.push_back(std::arg(ours / theirs) / kDegree / (degreesOfOneDecibel * tolerance));
  }
  for (const double residual : value.residuals) sum += residual * residual;
  value.misfit = sum / static_cast<double>(value.residuals.size());
  value.value = std::sqrt(value.misfit);
  value.isMet = *value.value <= 1.5;
  return value;
}

std::string unitDoubt(const MeasuredReceptance& measured, const receptance::TrackReceptance& computed) {
  constexpr double plausible = 50;
  double sum = 0;
  for (std::size_t i = 0; i < measured.frequency.size(); ++i)
    sum += std::log(std::abs(measured.receptance[i]) /
                    std::abs(computedAt(computed, measured.target.point, measured.frequency[i])));
  const double ratio = std::exp(sum / static_cast<double>(measured.frequency.size()));
  if (ratio < plausible && ratio > 1 / plausible) return {};
  char text[128];
  std::snprintf(text, sizeof text, "magnitudes are about %.1e times the computed ones; they must be in m/N", ratio);
  return text;
}

}  // namespace squat::calibration
