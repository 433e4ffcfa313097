#include "readers/ArraySignals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <type_traits>

#include "core/Errors.h"
#include "rcmdx/RecordColumns.h"
#include "readers/ArrayFile.h"
#include "readers/ColumnRoles.h"
#include "readers/TableRoles.h"
#include "results/ResultTree.h"
#include "signals/SignalCatalogue.h"
#include "text/Heading.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::readers {
namespace {

using results::Array;
using results::ArrayTree;

std::string parentOf(const std::string& path) { return path.substr(0, path.rfind('/')); }
std::string nameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

bool isNumeric(const Array& array) { return !std::holds_alternative<std::vector<std::string>>(array.values); }

// The longest axis counts the samples; MATLAB writes a row vector as n x 1.
std::size_t lengthOf(const Array& array) {
  std::size_t length = 0;
  for (const std::size_t extent : array.shape) length = std::max(length, extent);
  return array.shape.empty() ? 1 : length;
}

std::vector<double> numbersOf(const Array& array) {
  return std::visit(
      [](const auto& values) -> std::vector<double> {
        using Element = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Element, std::string>)
          return {};
        else
          return {values.begin(), values.end()};
      },
      array.values);
}

std::string unitOf(const Array& array) {
  for (const char* name : {"unit", "units", "Unit", "Units", "unit_string"})
    if (std::string unit = results::textAttribute(array.attributes, name); !unit.empty()) return unit;
  return {};
}

std::string listOf(const std::vector<const Array*>& arrays) {
  std::string text;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    if (i == 15 && arrays.size() > 17) return text + ", ...";
    text += (i ? ", " : "") + arrays[i]->path;
  }
  return text;
}

Role roleOf(const Array& array) { return readers::roleOf(nameOf(array.path), unitOf(array)); }

bool isNested(const Array& array) {
  return std::count_if(array.shape.begin(), array.shape.end(), [](auto extent) { return extent > 1; }) > 2;
}

// A dataset as one column, or one column for each of its runs.
void addColumns(ArrayColumns& found, const Array& array) {
  const std::size_t n = lengthOf(array);
  const auto values = numbersOf(array);
  std::size_t runs = n > 0 ? 1 : 0;
  for (const std::size_t extent : array.shape)
    if (n > 0) runs *= extent;
  if (n > 0 && !array.shape.empty()) runs /= n;
  const bool samplesFirst = array.shape.empty() || array.shape.front() == n;
  for (std::size_t run = 0; run < runs; ++run) {
    text::TableColumn column;
    const std::string stated = unitOf(array);
    const auto heading =
        stated.empty() ? text::headingOf(nameOf(array.path)) : text::Heading{nameOf(array.path), stated};
    column.name = heading.name + (runs > 1 ? " " + std::to_string(run + 1) : "");
    column.unit = heading.unit;
    column.values.resize(values.empty() ? 0 : n);
    for (std::size_t i = 0; i < column.values.size(); ++i)
      column.values[i] = samplesFirst ? values[i * runs + run] : values[run * n + i];
    found.table.columns.push_back(std::move(column));
    found.places.push_back({array.path, run, runs, samplesFirst});
  }
}

class Finder {
 public:
  Finder(const std::string& path, const ArrayTree& tree, const SignalFileOptions& options)
      : path_(path), tree_(tree), options_(options) {
    for (const auto& array : tree.arrays)
      if (isNumeric(array) && lengthOf(array) > 1) all_.push_back(&array);
    if (all_.empty()) throw FileError(path, "", "contains no numeric dataset");
  }

  ArrayColumns columns() {
    chooseGroup();
    ArrayColumns found;
    found.table.path = path_;
    found.table.rowWord = "sample";
    const std::size_t n = found.samples = chosenLength();
    for (const Array* array : all_) {
      if (parentOf(array->path) != group_) continue;
      if (lengthOf(*array) == n) {
        if (isNested(*array))
          throw FileError(path_, array->path, "has more than two dimensions",
                          "Store samples, or samples and runs: one or two dimensions");
        addColumns(found, *array);
      } else if (roleOf(*array) != Role::signal || nameOf(array->path) == options_.timeColumn) {
        throw FileError(path_, array->path,
                        "has " + std::to_string(lengthOf(*array)) + " values, the signal " + std::to_string(n),
                        "All datasets of a group must be equally long");
      }
    }
    found.options = options(found.table);
    return found;
  }

 private:
  // The options with what the file adds: the chosen dataset, sampling rate and speed.
  SignalFileOptions options(const text::DelimitedTable& table) const {
    SignalFileOptions result = options_;
    if (dataset_ && result.column.empty())
      for (const auto& column : table.columns)
        if (column.name == nameOf(dataset_->path) || column.name.rfind(nameOf(dataset_->path) + " ", 0) == 0)
          result.column += (result.column.empty() ? "" : ",") + column.name;
    const auto has = [&](Role role) {
      return std::any_of(table.columns.begin(), table.columns.end(),
                         [&](const auto& column) { return readers::roleOf(column.name, column.unit) == role; });
    };
    if (result.rate == 0 && !has(Role::time) && result.timeColumn.empty())
      result.rate = scalar({"fs", "rate", "sampling_rate", "sample_rate", "samplerate", "samplingrate",
                            "sampling_frequency", "samplingfrequency"});
    if (result.rate == 0 && !has(Role::time) && result.timeColumn.empty())
      if (const double step = scalar({"dt", "delta_t", "deltat", "wf_increment", "time_step", "timestep",
                                      "sampling_interval", "sample_interval", "sampling_period"});
          step > 0)
        result.rate = 1 / step;
    if (result.speed == 0 && !has(Role::speed)) result.speed = scalar({"speed", "v", "velocity"});
    return result;
  }

  void chooseGroup() {
    std::set<std::string> groups;
    for (const Array* array : all_) groups.insert(parentOf(array->path));
    if (!options_.object.empty()) {
      std::string object = options_.object.front() == '/' ? options_.object : "/" + options_.object;
      while (object.size() > 1 && object.back() == '/') object.pop_back();
      const auto found =
          std::find_if(all_.begin(), all_.end(), [&](const Array* array) { return array->path == object; });
      if (found != all_.end()) {
        dataset_ = *found;
        group_ = parentOf(object);
      } else if (groups.count(object == "/" ? "" : object)) {
        group_ = object == "/" ? "" : object;
      } else {
        throw FileError(path_, object, "is neither a dataset nor a group of datasets", "Available: " + listOf(all_));
      }
      return;
    }
    for (const Array* array : all_)
      if (text::lowerCase(nameOf(array->path)) == signals::names::axleBox) {
        group_ = parentOf(array->path);
        return;
      }
    if (groups.size() == 1) {
      group_ = *groups.begin();
      return;
    }
    throw FileError(path_, "", "has datasets in several groups", "Name the object to read; available: " + listOf(all_));
  }

  std::size_t chosenLength() const {
    if (dataset_) return lengthOf(*dataset_);
    std::size_t longest = 0;
    for (const Array* array : all_) {
      if (parentOf(array->path) != group_) continue;
      const std::string name = text::lowerCase(nameOf(array->path));
      if (name == (options_.column.empty() ? signals::names::axleBox : text::lowerCase(options_.column)))
        return lengthOf(*array);
      if (roleOf(*array) == Role::signal) longest = std::max(longest, lengthOf(*array));
    }
    return longest;
  }

  // A single number beside the signal, at the root, or an attribute of either; 0: none.
  double scalar(const std::vector<std::string>& names) const {
    const auto wanted = [&](const std::string& name) {
      return std::find(names.begin(), names.end(), text::lowerCase(name)) != names.end();
    };
    for (const auto& array : tree_.arrays) {
      const std::string parent = parentOf(array.path);
      if (!isNumeric(array) || lengthOf(array) != 1 || (parent != group_ && !parent.empty())) continue;
      const auto values = numbersOf(array);
      if (!wanted(nameOf(array.path)) || values.size() != 1 || !(values[0] > 0)) continue;
      const std::string unit = unitOf(array);
      if (!unit.empty() && !text::isUnit(unit))
        throw FileError(path_, array.path, "has the unit '" + unit + "', which is not known",
                        "Give the value in the call");
      return values[0] * scaleOf(unit, nameOf(array.path), Role::signal).factor;
    }
    const auto inAttributes = [&](const std::vector<results::Attribute>& attributes) {
      for (const auto& attribute : attributes)
        if (wanted(attribute.name)) {
          if (const auto* number = std::get_if<double>(&attribute.value)) return *number;
          if (const auto* whole = std::get_if<std::int64_t>(&attribute.value)) return static_cast<double>(*whole);
        }
      return 0.0;
    };
    for (const auto& array : tree_.arrays)
      if (parentOf(array.path) == group_)
        if (const double found = inAttributes(array.attributes); found > 0) return found;
    if (const auto* group = tree_.findGroup(group_))
      if (const double found = inAttributes(group->attributes); found > 0) return found;
    return std::max(0.0, inAttributes(tree_.attributes));
  }

  const std::string& path_;
  const ArrayTree& tree_;
  const SignalFileOptions& options_;
  std::vector<const Array*> all_;
  const Array* dataset_ = nullptr;
  std::string group_;
};

}  // namespace

ArrayColumns columnsOf(const std::string& path, const results::ArrayTree& tree, const SignalFileOptions& options) {
  return Finder(path, tree, options).columns();
}

std::vector<signals::Record> readArraySignals(const std::string& path, const SignalFileOptions& options) {
  if (const auto listed = listArrays(path); rcmdx::isRcmDx(listed)) {
    const auto session = rcmdx::recordColumns(path, listed, {options.object, options.positionColumn});
    auto recorded = session.read();
    setUnits(recorded, options);
    auto records = signalsOf(recorded, options);
    for (auto& record : records)
      record.notes.insert(record.notes.end(), session.notes().begin(), session.notes().end());
    return records;
  }
  const ArrayTree tree = readArrays(path);
  auto [table, places, samples, found] = columnsOf(path, tree, options);
  table.lines.resize(samples);
  std::iota(table.lines.begin(), table.lines.end(), 0u);
  setUnits(table, found);
  auto signals = signalsOf(table, found);
  if (results::textAttribute(tree.attributes, "schema") == results::kResultSchema &&
      results::numberAttribute(tree.attributes, "complete", 1) != 1)
    for (auto& signal : signals)
      signal.notes.push_back("the run is not complete (" + results::textAttribute(tree.attributes, "stop_reason") +
                             "): what came later is missing");
  return signals;
}

}  // namespace squat::readers
