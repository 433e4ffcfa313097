#include "calibration/ReceptanceResiduals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "core/Errors.h"
#include "signals/Resample.h"
#include "text/DelimitedTable.h"

namespace squat::calibration {

namespace {

using text::TableColumn;

constexpr double kDegree = std::numbers::pi / 180;

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

double scaleOf(const TableColumn& column, const std::string& path) {
  static const std::map<std::string, double> known = {{"", 1},         {"m/N", 1},     {"m/kN", 1e-3}, {"mm/N", 1e-3},
                                                      {"mm/kN", 1e-6}, {"um/N", 1e-6}, {"µm/N", 1e-6}, {"um/kN", 1e-9},
                                                      {"µm/kN", 1e-9}, {"nm/N", 1e-9}};
  const auto found = known.find(column.unit);
  if (found == known.end())
    throw FileError(path, "column '" + column.name + "'", "unit is '" + column.unit + "', must be m/N",
                    "Known are m/N, m/kN, mm/N, mm/kN, um/N, um/kN, nm/N");
  return found->second;
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
    if (holds("imag"))
      found.imaginary = &column;
    else if (holds("real"))
      found.real = &column;
    else if (holds("phase"))
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

std::complex<double> valueAt(const ReceptanceColumns& columns, std::size_t row, const std::string& path) {
  if (columns.real && columns.imaginary)
    return {columns.real->values[row] * scaleOf(*columns.real, path),
            columns.imaginary->values[row] * scaleOf(*columns.imaginary, path)};
  const double magnitude = columns.magnitude->values[row] * scaleOf(*columns.magnitude, path);
  if (!columns.phase) return magnitude;
  const double angle = columns.phase->values[row] * (columns.phase->unit == "rad" ? 1 : kDegree);
  return std::polar(std::abs(magnitude), angle);
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
  const auto table = text::readDelimitedTable(target.file);
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
    const auto value = valueAt(columns, row, target.file);
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
