#include "case/DynamicPads.h"

#include <array>
#include <cmath>
#include <utility>

#include "case/DecimalNumber.h"
#include "core/Errors.h"
#include "text/DelimitedTable.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::cases {

namespace {

using scenario::DynamicStiffness;
using text::TableColumn;

constexpr int inMeganewtons = 6;
constexpr const char* padExample =
    "Name the columns, e.g. frequency [Hz], stiffness real [MN/m], stiffness imaginary [MN/m]";

std::optional<double> stiffnessFactor(std::string unit) {
  std::erase(unit, ' ');
  constexpr std::array<std::pair<std::string_view, double>, 6> known{
      {{"n/m", 1}, {"n/mm", 1e3}, {"kn/m", 1e3}, {"kn/mm", 1e6}, {"mn/m", 1e6}, {"n/um", 1e6}}};
  unit = text::lowerCase(unit);
  for (const auto& [name, factor] : known)
    if (unit == name) return factor;
  return std::nullopt;
}

struct ComplexColumns {
  const TableColumn *real = nullptr, *imaginary = nullptr;

  std::complex<double> at(std::size_t row) const {
    return {real->values[row] * *stiffnessFactor(real->unit),
            imaginary->values[row] * *stiffnessFactor(imaginary->unit)};
  }
};

ComplexColumns complexColumns(const text::DelimitedTable& table, bool lateral) {
  ComplexColumns found;
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    const auto& column = table.columns[i];
    const auto name = text::lowerCase(column.name);
    if (!stiffnessFactor(column.unit) || (name.find("lateral") != std::string::npos) != lateral) continue;
    const bool imaginary = name.find("imag") != std::string::npos;
    if (imaginary && !found.imaginary) found.imaginary = &column;
    if (!imaginary && name.find("real") != std::string::npos && !found.real) found.real = &column;
  }
  return found;
}

std::string stiffnessMistake(const std::complex<double>& stiffness) {
  constexpr double softest = 1e6, stiffest = 1e11;  // [N/m]
  const double size = std::abs(stiffness);
  if (size >= softest && size <= stiffest && stiffness.real() > 0 && stiffness.imag() >= 0) return {};
  return "the stiffness is " + text::formatted("%.3g", stiffness.real()) +
         text::formatted(" + %.3g i N/m; pads have 1 MN/m to 100 GN/m and a positive loss", stiffness.imag());
}

std::string rowMistake(const DynamicStiffness& row, double frequencyBefore, bool hasLateral) {
  if (!(row.frequency > frequencyBefore)) return "frequencies must be positive and ascend";
  if (auto wrong = stiffnessMistake(row.vertical); !wrong.empty()) return wrong;
  return hasLateral ? stiffnessMistake(row.lateral) : std::string();
}

// "3863 608": as many numbers as the text has between blanks.
std::optional<std::vector<double>> numbersIn(std::string_view text) {
  std::vector<double> numbers;
  for (text = text::trimmed(text); !text.empty(); text = text::trimmed(text)) {
    const auto end = std::min(text.find(' '), text.size());
    const auto number = parseDecimal(text.substr(0, end), inMeganewtons);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    text.remove_prefix(end);
  }
  return numbers;
}

}  // namespace

std::optional<std::vector<DynamicStiffness>> parseDynamicStiffness(std::string_view text) {
  std::vector<DynamicStiffness> table;
  for (text = text::trimmed(text); !text.empty();) {
    const auto end = std::min(text.find(','), text.size());
    const auto row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto colon = row.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const auto frequency = parseDecimal(row.substr(0, colon));
    const auto numbers = numbersIn(row.substr(colon + 1));
    if (!frequency || !numbers || (numbers->size() != 2 && numbers->size() != 4)) return std::nullopt;
    const auto& n = *numbers;
    table.push_back({*frequency, {n[0], n[1]}, n.size() == 4 ? std::complex<double>(n[2], n[3]) : 0});
    if ((n.size() == 4) != (table.front().lateral != 0.0)) return std::nullopt;
  }
  return table;
}

std::string formatDynamicStiffness(const std::vector<DynamicStiffness>& table) {
  std::string text;
  const auto add = [&](double value) { text.append(" ").append(formatDecimal(value, inMeganewtons)); };
  for (const auto& row : table) {
    if (!text.empty()) text += ", ";
    text.append(formatDecimal(row.frequency)).append(":");
    add(row.vertical.real()), add(row.vertical.imag());
    if (row.lateral != 0.0) add(row.lateral.real()), add(row.lateral.imag());
  }
  return text;
}

std::string dynamicStiffnessMistake(const std::vector<DynamicStiffness>& table) {
  constexpr std::size_t mostRows = 2000;
  if (table.size() > mostRows) return "more than " + std::to_string(mostRows) + " rows";
  double before = 0;
  for (const auto& row : table) {
    if (auto wrong = rowMistake(row, before, table.front().lateral != 0.0); !wrong.empty())
      return formatDecimal(row.frequency) + " Hz: " + wrong;
    before = row.frequency;
  }
  return {};
}

std::vector<DynamicStiffness> readDynamicStiffness(const std::string& path) {
  const auto table = text::readDelimitedTable(path);
  const auto vertical = complexColumns(table, false), lateral = complexColumns(table, true);
  if (!vertical.real || !vertical.imaginary)
    throw FileError(path, "heading",
                    "no columns of the real and the imaginary part of a stiffness in N/m, N/mm, kN/mm or MN/m",
                    padExample);
  if (!lateral.real != !lateral.imaginary)
    throw FileError(path, "heading", "only one part of the lateral stiffness", "Give real and imaginary part, or none");
  if (text::lowerCase(table.columns[0].unit) != "hz")
    throw FileError(path, "column '" + table.columns[0].name + "'", "must be the frequency in Hz", padExample);
  std::vector<DynamicStiffness> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const DynamicStiffness at{table.columns[0].values[row], vertical.at(row),
                              lateral.real ? lateral.at(row) : std::complex<double>()};
    if (const auto wrong = rowMistake(at, rows.empty() ? 0 : rows.back().frequency, lateral.real != nullptr);
        !wrong.empty())
      throw FileError(path, table.rowWord + " " + std::to_string(table.lines[row]), wrong,
                      "Check the units in the heading, the signs and the order of the rows");
    rows.push_back(at);
  }
  return rows;
}

}  // namespace squat::cases
