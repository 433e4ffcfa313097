#include "loggers/UniversalFile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>

#include "core/DurableFile.h"
#include "loggers/UniversalFunction.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::loggers {
namespace {

using UffFunctions = std::vector<const UniversalFunction*>;

bool uffIsTime(const UniversalFunction& function) {
  constexpr long frequency = 18;
  return !function.isComplex && (function.type == 1 || (function.type == 0 && function.abscissa.code != frequency));
}

bool uffIsResponse(const UniversalFunction& function) { return function.type == 4; }

struct UffByAbscissa {
  bool operator()(const UniversalFunction* a, const UniversalFunction* b) const {
    const auto key = [](const UniversalFunction& f) {
      return std::tuple(f.even, f.size(), f.even ? f.start : 0.0, f.even ? f.step : 0.0);
    };
    if (key(*a) != key(*b)) return key(*a) < key(*b);
    return std::tie(a->abscissa.unit, a->x) < std::tie(b->abscissa.unit, b->x);
  }
};

// The functions over the abscissa that most have; of equally many the first in the file.
UffFunctions uffLargestGroup(const UffFunctions& functions) {
  std::map<const UniversalFunction*, std::size_t, UffByAbscissa> counts;
  for (const auto* function : functions) ++counts[function];
  const auto* best = functions[0];
  for (const auto* function : functions)
    if (counts[function] > counts[best]) best = function;
  const UffByAbscissa less;
  UffFunctions group;
  for (const auto* function : functions)
    if (!less(function, best) && !less(best, function)) group.push_back(function);
  return group;
}

// Titles where they tell the functions apart, else points, else numbers behind them.
std::vector<std::string> uffNames(const UffFunctions& functions, bool withReference) {
  const auto allDiffer = [](const std::vector<std::string>& names) {
    const std::set<std::string> different(names.begin(), names.end());
    return different.size() == names.size() && different.count("") == 0;
  };
  std::vector<std::string> titles, points;
  for (const auto* function : functions) {
    titles.push_back(function->title);
    const bool both = withReference && !function->response.empty() && !function->reference.empty();
    points.push_back(function->response + (both ? " by " + function->reference : ""));
  }
  if (allDiffer(titles)) return titles;
  if (allDiffer(points)) return points;
  std::set<std::string> used;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const std::string name = !points[i].empty() ? points[i] : !titles[i].empty() ? titles[i] : "function";
    names.push_back(used.count(name) > 0 ? name + " (" + std::to_string(i + 1) + ")" : name);
    used.insert(names.back());
  }
  return names;
}

// A unit, and what takes the file's values to it.
struct UffScale {
  std::string unit;
  double factor = 1;
};

UffScale uffScale(const UniversalQuantity& quantity, const UniversalUnits& units) {
  // The label stands above the code and the file's system of units: so the format says.
  if (!quantity.unit.empty()) return {quantity.unit, 1};
  switch (quantity.code) {
    case 8:
      return {"m", 1 / units.length};
    case 11:
      return {"m/s", 1 / units.length};
    case 12:
      return {"m/s2", 1 / units.length};
    case 9:
    case 13:
      return {"N", 1 / units.force};
    default:
      return {};
  }
}

// "m/s^2" as "m/s2", since a unit of a response is not looked up by all its spellings.
std::string uffPlainUnit(const std::string& label) {
  const auto* known = text::findUnit(text::bareUnit(label));
  return known && known->factor == 1 ? std::string(known->si) : text::bareUnit(label);
}

UffScale uffResponseScale(const UniversalFunction& function) {
  const UffScale above = uffScale(function.ordinate, function.units);
  const UffScale below = uffScale(function.denominator, function.units);
  UffScale scale{uffPlainUnit(above.unit), above.factor / below.factor};
  if (below.unit.empty()) return scale;
  scale.unit = (scale.unit.empty() ? "1" : scale.unit) + "/" + uffPlainUnit(below.unit);
  return scale;
}

text::TableColumn uffColumn(std::string name, const UffScale& scale, const std::vector<double>& values) {
  text::TableColumn column;
  column.name = std::move(name);
  column.unit = scale.unit;
  column.values.reserve(values.size());
  for (const double value : values) {
    const double scaled = scale.factor * value;
    if (!std::isfinite(scaled) && column.badText.empty()) {
      column.badRow = column.values.size();
      column.badText = std::isinf(scaled) ? "infinity" : "no number";
    }
    column.values.push_back(std::isinf(scaled) ? std::nan("") : scaled);
  }
  return column;
}

// The values of the abscissa, and its unit: s and Hz, or what the label says where that is neither.
text::TableColumn uffAbscissa(const UniversalFunction& function, const std::string& name, const std::string& si) {
  UffScale scale{si, 1};
  const std::string label = text::bareUnit(function.abscissa.unit);
  if (const auto* known = text::findUnit(label); known && known->si == si)
    scale.factor = known->factor;
  else if (si == "Hz" && (text::lowerCase(label) == "rad/s" || text::lowerCase(label) == "rad/sec"))
    scale.factor = 1 / (2 * std::numbers::pi);
  else if (!label.empty() && (known || si == "Hz"))
    scale.unit = label;
  std::vector<double> values = function.x;
  if (function.even) {
    values.resize(function.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = function.start + static_cast<double>(i) * function.step;
  }
  return uffColumn(name, scale, values);
}

// The increment comes with few digits: 1.95313E-05 s may be 1/51200 s. The rate is the roundest number that they allow.
double uffRate(double step, const std::string& written, double toSeconds) {
  const double rate = 1 / (step * toSeconds);
  const std::size_t point = written.find('.'), end = written.find_first_of("EeDd");
  if (point == std::string::npos) return rate;
  const std::string_view power = end == std::string::npos ? "0" : std::string_view(written).substr(end + 1);
  const std::size_t decimals = std::min(end, written.size()) - std::min(point + 1, end);
  const double half =
      0.5 * std::pow(10, static_cast<double>(universalInteger(power).value_or(0)) - static_cast<double>(decimals));
  const double open = 1.01 * half / step;  // a tie is open as well
  if (!(open < 1e-4)) return rate;         // hardly any digits: there is nothing to be had from them
  for (const double grid : {1000.0, 100.0, 10.0, 1.0, 0.1})
    if (const double round = std::round(rate / grid) * grid; round > 0 && std::abs(round - rate) <= open * rate)
      return round;
  return rate;
}

void uffAddTime(const UffFunctions& functions, LoggerTable& result, const std::string& path) {
  const auto& first = *functions[0];
  if (first.even) {
    const auto* unit = text::findUnit(text::bareUnit(first.abscissa.unit));
    const double toSeconds = unit && unit->si == "s" ? unit->factor : 1;
    const double rate = first.step > 0 ? 1 / (first.step * toSeconds) : 0;
    if (!(rate > 0) || !std::isfinite(rate))
      throw FileError(path, "dataset 58", "states a time step of " + text::shown(first.stepText), "It must be above 0");
    result.rate = uffRate(first.step, first.stepText, toSeconds);
    if (std::abs(result.rate - rate) > 1e-9 * rate)
      result.notes.push_back("the time step " + first.stepText + " s is taken for a sampling rate of " +
                             text::numberText(result.rate) + " Hz");
    if (first.start != 0)
      result.notes.push_back("the time begins at " + text::numberText(first.start * toSeconds) + " s");
  } else {
    result.table.columns.push_back(uffAbscissa(first, "time", "s"));
  }
  const auto names = uffNames(functions, false);
  for (std::size_t i = 0; i < functions.size(); ++i)
    result.table.columns.push_back(
        uffColumn(names[i], uffScale(functions[i]->ordinate, functions[i]->units), functions[i]->real));
}

void uffAddResponses(const UffFunctions& functions, LoggerTable& result, const std::string& path) {
  if (functions[0]->even && !(functions[0]->step > 0))
    throw FileError(path, "dataset 58", "states a frequency step of " + text::shown(functions[0]->stepText),
                    "It must be above 0");
  result.table.columns.push_back(uffAbscissa(*functions[0], "f", "Hz"));
  const auto names = uffNames(functions, true);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const UffScale scale = uffResponseScale(*functions[i]);
    const std::string prefix = functions.size() > 1 ? names[i] + " " : "";
    if (functions[i]->isComplex) {
      result.table.columns.push_back(uffColumn(prefix + "Re", scale, functions[i]->real));
      result.table.columns.push_back(uffColumn(prefix + "Im", scale, functions[i]->imaginary));
    } else {
      result.table.columns.push_back(uffColumn(names[i], scale, functions[i]->real));
    }
  }
}

void uffNoteOut(std::size_t count, const std::string& why, LoggerTable& result) {
  if (count > 0)
    result.notes.push_back(std::to_string(count) + (count == 1 ? " function" : " functions") + " left out: " + why);
}

}  // namespace

bool isUniversalFile(std::string_view head) {
  UniversalCursor cursor(head, {});
  std::string_view line;
  do
    if (!cursor.next(line)) return false;
  while (text::trimmed(line).empty());
  if (!line.starts_with("    -1") || !isUniversalMark(line) || !cursor.next(line)) return false;
  const auto number = universalInteger(universalField(line, 0, 6));
  const std::string_view behind = line.substr(std::min<std::size_t>(line.size(), 6));
  return number && *number > 0 && (text::trimmed(behind).empty() || behind.front() == 'b' || behind.front() == 'B');
}

LoggerTable parseUniversalFile(std::string_view bytes, const std::string& path) {
  if (!isUniversalFile(bytes))
    throw FileError(path, "", "is not a universal file", "It must begin with a line -1 and the number of a dataset");
  LoggerTable result;
  const auto functions = universalFunctions(bytes, path, result.notes);
  UffFunctions times, responses;
  for (const auto& function : functions) {
    if (function.size() == 0) continue;
    if (uffIsTime(function)) times.push_back(&function);
    if (uffIsResponse(function)) responses.push_back(&function);
  }
  if (times.empty() && responses.empty())
    throw FileError(path, "", "holds no time history and no frequency response",
                    "They are datasets 58 of the function types 1 and 4");
  uffNoteOut(functions.size() - times.size() - responses.size(),
             "neither time histories nor frequency responses with values", result);
  if (!times.empty()) uffNoteOut(responses.size(), "frequency responses beside time histories", result);
  const auto& kind = times.empty() ? responses : times;
  const auto group = uffLargestGroup(kind);
  uffNoteOut(kind.size() - group.size(), "another length, beginning or step than most have", result);
  if (times.empty())
    uffAddResponses(group, result, path);
  else
    uffAddTime(group, result, path);
  result.table.path = path;
  result.table.rowWord = "sample";
  result.table.lines.resize(group[0]->size());
  std::iota(result.table.lines.begin(), result.table.lines.end(), 1U);
  return result;
}

LoggerTable readUniversalFile(const std::string& path) {
  return parseUniversalFile(readWholeFile(path, std::size_t{4} << 30), path);
}

}  // namespace squat::loggers
