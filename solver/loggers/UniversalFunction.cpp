#include "loggers/UniversalFunction.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "text/Lines.h"
#include "text/Text.h"
#include "text/Utf8Text.h"

namespace squat::loggers {
namespace {

constexpr std::size_t uffHeaderLines = 11;

// The line that names a dataset: its number, and what follows the letter b.
struct UffName {
  long number = 0;
  bool binary = false;
  long order = 0, format = 0, lines = 0, bytes = 0;
};

UffName uffName(std::string_view line) {
  UffName name;
  const std::string_view word = text::trimmed(line.substr(0, line.find_first_not_of(" 0123456789")));
  name.number = universalInteger(word.substr(0, word.find(' '))).value_or(0);
  const std::size_t letter = line.find_first_of("bB");
  name.binary = letter <= 8;  // not found is far beyond
  if (!name.binary) return name;
  std::vector<std::string_view> fields;
  text::splitFields(line.substr(letter + 1), ' ', fields);
  long* const values[] = {&name.order, &name.format, &name.lines, &name.bytes};
  for (std::size_t i = 0; i < std::min<std::size_t>(fields.size(), 4); ++i)
    *values[i] = std::max(universalInteger(fields[i]).value_or(0), 0L);
  return name;
}

std::string uffLabel(std::string_view field) {
  const std::string label = text::asUtf8(text::trimmed(field, std::string_view(" \t\r\n\0", 5)));
  return text::lowerCase(label) == "none" ? std::string() : label;
}

UniversalQuantity uffQuantity(std::string_view line) {
  return {universalInteger(universalField(line, 0, 10)).value_or(0), uffLabel(universalField(line, 47, 20))};
}

// Entity, node and direction: "BOX 12 +Z".
std::string uffPoint(std::string_view line, std::size_t from) {
  static constexpr std::array<const char*, 7> directions{"", "X", "Y", "Z", "RX", "RY", "RZ"};
  std::string point = uffLabel(universalField(line, from, 10));
  const long node = universalInteger(universalField(line, from + 10, 10)).value_or(0);
  const long direction = universalInteger(universalField(line, from + 20, 4)).value_or(0);
  if (node != 0) point += (point.empty() ? "" : " ") + std::to_string(node);
  if (direction != 0 && direction >= -6 && direction <= 6)
    point += std::string(point.empty() ? "" : " ") + (direction > 0 ? "+" : "-") +
             directions[static_cast<std::size_t>(std::abs(direction))];
  return point;
}

// What the header says of the values that follow.
struct UffShape {
  bool isDouble = false;
  std::size_t count = 0, perPoint = 1;
};

// Nothing where the file ends inside the header.
std::optional<UffShape> uffHeader(UniversalCursor& cursor, UniversalFunction& function) {
  std::array<std::string_view, uffHeaderLines> lines;
  for (auto& line : lines) {
    if (!cursor.next(line)) return std::nullopt;
    if (isUniversalMark(line)) throw cursor.error("ends its dataset 58 before the header of 11 lines does");
    if (&line != &lines[6]) continue;
    const auto kind = universalInteger(universalField(line, 0, 10));
    if (!kind || (*kind != 2 && *kind != 4 && *kind != 5 && *kind != 6))
      throw cursor.error(
          "names the kind of ordinate " + text::shown(universalField(line, 0, 10)) + ", must be 2, 4, 5 or 6",
          "The sixth line after the ID lines is record 7 of dataset 58");
    const auto count = universalInteger(universalField(line, 10, 10));
    if (!count || *count < 0) throw cursor.error("states " + text::shown(universalField(line, 10, 10)) + " values");
  }
  function.title = uffLabel(lines[0]);
  function.type = universalInteger(universalField(lines[5], 0, 5)).value_or(0);
  function.response = uffPoint(lines[5], 31);
  function.reference = uffPoint(lines[5], 56);
  const long kind = *universalInteger(universalField(lines[6], 0, 10));
  function.even = universalInteger(universalField(lines[6], 20, 10)).value_or(1) != 0;
  function.isComplex = kind >= 5;
  function.start = universalNumber(universalField(lines[6], 30, 13)).value_or(0);
  function.stepText = std::string(universalField(lines[6], 43, 13));
  function.step = universalNumber(function.stepText).value_or(0);
  function.abscissa = uffQuantity(lines[7]);
  function.ordinate = uffQuantity(lines[8]);
  function.denominator = uffQuantity(lines[9]);
  UffShape shape;
  shape.isDouble = kind == 4 || kind == 6;
  shape.count = static_cast<std::size_t>(*universalInteger(universalField(lines[6], 10, 10)));
  shape.perPoint = (function.even ? 1U : 2U) + (function.isComplex ? 1U : 0U);
  return shape;
}

// Puts the numbers of all points, in their order in the file, where they belong.
void uffPart(const std::vector<double>& numbers, const UffShape& shape, UniversalFunction& function) {
  const std::size_t ordinate = function.even ? 0 : 1;
  for (std::size_t i = 0; i < shape.count; ++i) {
    const double* point = numbers.data() + i * shape.perPoint;
    if (!function.even) function.x.push_back(point[0]);
    function.real.push_back(point[ordinate]);
    if (function.isComplex) function.imaginary.push_back(point[ordinate + 1]);
  }
}

// False where the file ends too early.
bool uffText(UniversalCursor& cursor, const UffShape& shape, UniversalFunction& function,
             std::vector<std::string>& notes) {
  if (shape.count > cursor.rest().size() / shape.perPoint) return false;
  std::vector<std::size_t> widths{shape.isDouble ? 20U : 13U};
  // An uneven abscissa is of single precision whatever the ordinate is.
  if (!function.even && shape.isDouble)
    widths = function.isComplex ? std::vector<std::size_t>{13, 20, 20} : std::vector<std::size_t>{13, 20};
  std::vector<double> numbers;
  std::string_view line;
  const std::size_t wanted = shape.count * shape.perPoint;
  while (numbers.size() < wanted) {
    if (!cursor.next(line)) return false;
    if (isUniversalMark(line))
      throw cursor.error("ends its dataset after " + std::to_string(numbers.size()) + " of " + std::to_string(wanted) +
                         " numbers");
    if (!universalNumbers(line, widths, numbers))
      throw cursor.error("holds a field that is not a number: " + text::shown(text::trimmed(line)));
  }
  bool more = numbers.size() > wanted;
  uffPart(numbers, shape, function);
  cursor.close(&more);
  if (more)
    notes.push_back("dataset " + std::to_string(cursor.dataset()) +
                    " holds more values than it states: the rest is left out");
  return true;
}

double uffBinaryNumber(std::string_view bytes, std::size_t size, bool bigEndian) {
  std::uint64_t raw = 0;
  for (std::size_t i = 0; i < size; ++i)
    raw = raw << 8 | static_cast<unsigned char>(bytes[bigEndian ? i : size - 1 - i]);
  return size == 8 ? std::bit_cast<double>(raw)
                   : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
}

bool uffBinary(UniversalCursor& cursor, const UffName& name, const UffShape& shape, UniversalFunction& function) {
  const std::size_t ordinate = shape.isDouble ? 8 : 4, stated = static_cast<std::size_t>(name.bytes);
  const std::size_t ordinates = shape.perPoint - (function.even ? 0 : 1);
  std::size_t abscissa = function.even ? 0 : 4;
  if (shape.count > cursor.rest().size()) return false;
  // Some writers give an uneven abscissa the precision of the ordinate; the stated size tells.
  if (!function.even && shape.isDouble && stated == shape.count * 8 * shape.perPoint) abscissa = 8;
  const std::size_t point = abscissa + ordinates * ordinate, needed = shape.count * point;
  if (stated != 0 && stated < needed)
    throw cursor.error("states " + std::to_string(stated) + " bytes, but its " + std::to_string(shape.count) +
                       " values take " + std::to_string(needed));
  const std::string_view bytes = cursor.rest();
  if (needed > bytes.size()) return false;
  std::vector<double> numbers;
  numbers.reserve(shape.count * shape.perPoint);
  const bool bigEndian = name.order == 2;
  for (std::size_t at = 0; at < needed;) {
    if (abscissa > 0) numbers.push_back(uffBinaryNumber(bytes.substr(at), abscissa, bigEndian));
    at += abscissa;
    for (std::size_t i = 0; i < ordinates; ++i, at += ordinate)
      numbers.push_back(uffBinaryNumber(bytes.substr(at), ordinate, bigEndian));
  }
  uffPart(numbers, shape, function);
  // A stated size that goes beyond the closing line is wrong.
  const std::string_view behind = bytes.substr(needed, 16);
  const bool closes = isUniversalMark(behind.substr(0, behind.find_first_of("\r\n"))) ||
                      isUniversalMark(text::trimmed(behind, "\r\n").substr(0, 6));
  cursor.skipBytes(closes ? needed : std::max(needed, stated));
  cursor.close();
  return true;
}

UniversalUnits uffUnits(UniversalCursor& cursor) {
  std::string_view line;
  std::vector<double> factors;
  UniversalUnits units;
  if (!cursor.next(line) || isUniversalMark(line)) return units;  // the name of the units
  if (!cursor.next(line) || isUniversalMark(line)) return units;
  if (!universalNumbers(line, {25}, factors) || factors.size() < 2 || !(factors[0] > 0) || !(factors[1] > 0))
    throw cursor.error("states no factors of length and force, as record 2 of dataset 164 must");
  cursor.close();
  return {factors[0], factors[1]};
}

// Beyond a dataset that is not wanted, or is nothing but its name.
void uffSkip(UniversalCursor& cursor, const UffName& name) {
  std::string_view line;
  for (long i = 0; name.binary && i < name.lines; ++i)
    if (!cursor.next(line) || isUniversalMark(line)) return;
  if (name.binary) cursor.skipBytes(static_cast<std::size_t>(name.bytes));
  cursor.close();
}

void uffRequireReadable(const UniversalCursor& cursor, const UffName& name) {
  if (!name.binary) return;
  if (name.format != 2)
    throw cursor.error(std::string("holds ") +
                           (name.format == 1   ? "numbers of DEC's VMS"
                            : name.format == 3 ? "numbers of IBM's 5/370"
                                               : "numbers of an unknown format") +
                           ", which are not read",
                       "Write the file again with IEEE 754 numbers, or as text");
  if (name.order != 1 && name.order != 2) throw cursor.error("names no order of bytes, must be 1 or 2");
}

}  // namespace

std::vector<UniversalFunction> universalFunctions(std::string_view bytes, const std::string& path,
                                                  std::vector<std::string>& notes) {
  UniversalCursor cursor(bytes, path);
  std::vector<UniversalFunction> functions;
  UniversalUnits units;
  std::string_view line;
  bool open = false;  // the line before was a mark
  while (cursor.next(line)) {
    if (isUniversalMark(line)) {
      open = true;
      continue;
    }
    if (!std::exchange(open, false)) continue;
    cursor.openDataset();
    const UffName name = uffName(line);
    if (name.number == 164 && !name.binary) {
      units = uffUnits(cursor);
    } else if (name.number == 58) {
      uffRequireReadable(cursor, name);
      UniversalFunction function;
      function.units = units;
      const auto shape = uffHeader(cursor, function);
      bool whole = shape.has_value();
      for (long i = uffHeaderLines; whole && name.binary && i < name.lines; ++i) whole = cursor.next(line);
      whole =
          whole && (name.binary ? uffBinary(cursor, name, *shape, function) : uffText(cursor, *shape, function, notes));
      if (!whole && functions.empty())
        throw FileError(path, "dataset " + std::to_string(cursor.dataset()), "ends with the file before its values do",
                        "Copy or write the file again");
      if (!whole) {
        notes.push_back("dataset " + std::to_string(cursor.dataset()) +
                        " ends with the file before its values do: left out");
        break;
      }
      if (std::any_of(function.x.begin(), function.x.end(), [](double x) { return !std::isfinite(x); }) ||
          !std::isfinite(function.start) || !std::isfinite(function.step))
        throw cursor.error("ends a dataset with an abscissa that is not a number");
      functions.push_back(std::move(function));
    } else {
      uffSkip(cursor, name);
    }
  }
  return functions;
}

}  // namespace squat::loggers
