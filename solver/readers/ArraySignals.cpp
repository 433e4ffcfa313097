#include "readers/ArraySignals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <type_traits>

#include "core/Errors.h"
#include "rcmdx/RecordColumns.h"
#include "readers/ArrayFile.h"
#include "readers/ArrayItems.h"
#include "readers/ColumnRoles.h"
#include "readers/TableRoles.h"
#include "results/ResultTree.h"
#include "signals/SignalCatalogue.h"
#include "text/Heading.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::readers {
namespace {

using results::Array;
using results::ArrayTree;

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

std::string listOf(const std::vector<ArrayItem>& items) {
  std::vector<std::string> paths;
  for (const auto& item : items)
    if (lengthOf(*item.array) > 1) paths.push_back(item.path);
  std::string text;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i == 15 && paths.size() > 17) return text + ", ...";
    text += (i ? ", " : "") + paths[i];
  }
  return text;
}

// A dataset as one column, or one column for each of its runs.
void addColumns(ArrayColumns& found, const ArrayItem& item) {
  const Array& array = *item.array;
  const std::size_t n = lengthOf(array);
  const auto values = numbersOf(array);
  std::size_t runs = n > 0 ? 1 : 0;
  for (const std::size_t extent : array.shape)
    if (n > 0) runs *= extent;
  if (n > 0 && !array.shape.empty()) runs /= n;
  const bool samplesFirst = array.shape.empty() || array.shape.front() == n;
  for (std::size_t run = 0; run < runs; ++run) {
    text::TableColumn column;
    const auto heading = item.unit.empty() ? text::headingOf(item.name) : text::Heading{item.name, item.unit};
    column.name = heading.name + (runs > 1 ? " " + std::to_string(run + 1) : "");
    column.unit = heading.unit;
    column.values.resize(values.empty() ? 0 : n);
    for (std::size_t i = 0; i < column.values.size(); ++i)
      column.values[i] = results::unpacked(samplesFirst ? values[i * runs + run] : values[run * n + i], item.packing);
    found.table.columns.push_back(std::move(column));
    found.places.push_back({array.path, run, runs, samplesFirst, item.packing});
  }
}

class Finder {
 public:
  Finder(const std::string& path, const ArrayTree& tree, const SignalFileOptions& options)
      : path_(path), tree_(tree), options_(options), items_(itemsOf(tree)) {
    if (!options.object.empty() && !choose()) items_ = itemsOf(tree, Channels::asTheyStand);
    if (std::none_of(items_.begin(), items_.end(), isLong))
      throw FileError(path, "", "contains no array of numbers",
                      "Objects (timeseries, tables, strings) are not read: export plain arrays or structures of them");
  }

  ArrayColumns columns() {
    if (options_.object.empty())
      chooseGroup();
    else if (!choose())
      throw FileError(path_, object(), "is neither a dataset nor a group of datasets", "Available: " + listOf(items_));
    ArrayColumns found;
    found.table.path = path_;
    found.table.rowWord = "sample";
    const std::size_t n = found.samples = chosenLength();
    for (const auto& item : items_) {
      if (!isLong(item) || item.group != group_) continue;
      if (lengthOf(*item.array) == n) {
        if (isNested(*item.array))
          throw FileError(path_, item.path, "has more than two dimensions",
                          "Store samples, or samples and runs: one or two dimensions");
        addColumns(found, item);
      } else if (roleOf(item.name, item.unit) != Role::signal || item.name == options_.timeColumn) {
        throw FileError(path_, item.path,
                        "has " + std::to_string(lengthOf(*item.array)) + " values, the signal " + std::to_string(n),
                        "All datasets of a group must be equally long");
      }
    }
    found.options = options(found.table);
    return found;
  }

 private:
  static bool isLong(const ArrayItem& item) { return lengthOf(*item.array) > 1; }

  // The options with what the file adds: the chosen dataset, sampling rate and speed.
  SignalFileOptions options(const text::DelimitedTable& table) const {
    SignalFileOptions result = options_;
    if (dataset_ && result.column.empty())
      for (const auto& column : table.columns)
        if (column.name == dataset_->name || column.name.rfind(dataset_->name + " ", 0) == 0)
          result.column += (result.column.empty() ? "" : ",") + column.name;
    const auto has = [&](Role role) {
      return std::any_of(table.columns.begin(), table.columns.end(),
                         [&](const auto& column) { return readers::roleOf(column.name, column.unit) == role; });
    };
    if (result.rate == 0 && !has(Role::time) && result.timeColumn.empty())
      result.rate = statedOnce({"fs", "rate", "sampling_rate", "sample_rate", "samplerate", "samplingrate",
                                "sampling_frequency", "samplingfrequency"});
    if (result.rate == 0 && !has(Role::time) && result.timeColumn.empty())
      if (const double step = statedOnce({"dt", "delta_t", "deltat", "wf_increment", "time_step", "timestep",
                                          "sampling_interval", "sample_interval", "sampling_period"});
          step > 0)
        result.rate = 1 / step;
    if (result.speed == 0 && !has(Role::speed)) result.speed = statedOnce({"speed", "v", "velocity"});
    return result;
  }

  // Without the slash that may end it.
  std::string object() const {
    std::string object = options_.object.front() == '/' ? options_.object : "/" + options_.object;
    while (object.size() > 1 && object.back() == '/') object.pop_back();
    return object;
  }

  // What `options.object` names; false: nothing.
  bool choose() {
    dataset_ = nullptr;
    const std::string wanted = object();
    for (const auto& item : items_) {
      if (!isLong(item)) continue;
      if (item.path == wanted) {
        dataset_ = &item;
        group_ = item.group;
        return true;
      }
    }
    group_ = wanted == "/" ? "" : wanted;
    return std::any_of(items_.begin(), items_.end(),
                       [&](const auto& item) { return isLong(item) && item.group == group_; });
  }

  void chooseGroup() {
    std::set<std::string> groups;
    for (const auto& item : items_) {
      if (!isLong(item)) continue;
      groups.insert(item.group);
      if (text::lowerCase(item.name) == signals::names::axleBox) {
        group_ = item.group;
        return;
      }
    }
    if (groups.size() != 1)
      throw FileError(path_, "", "has datasets in several groups",
                      "Name the object to read; available: " + listOf(items_));
    group_ = *groups.begin();
  }

  std::size_t chosenLength() const {
    if (dataset_) return lengthOf(*dataset_->array);
    std::size_t longest = 0;
    for (const auto& item : items_) {
      if (!isLong(item) || item.group != group_) continue;
      const std::string name = text::lowerCase(item.name);
      if (name == (options_.column.empty() ? signals::names::axleBox : text::lowerCase(options_.column)))
        return lengthOf(*item.array);
      if (roleOf(item.name, item.unit) == Role::signal) longest = std::max(longest, lengthOf(*item.array));
    }
    return longest;
  }

  // A single number or an attribute by one of these names, at the signals or their groups, else at the root; 0: none.
  // Channels that state different ones cannot be read together.
  double statedOnce(const std::vector<std::string>& names) const {
    const auto near = statedNear(names);
    for (const auto& [where, value] : near)
      if (std::abs(value - near.front().second) > 1e-9 * near.front().second)
        throw FileError(path_, where,
                        "states " + text::roundedText(value) + ", " + near.front().first + " " +
                            text::roundedText(near.front().second),
                        "Name the object to read; available: " + listOf(items_));
    if (!near.empty()) return near.front().second;
    for (const auto& item : items_)
      if (item.group.empty())
        if (const double value = numberOf(item, names); value > 0) return value;
    return std::max(0.0, attributeOf(tree_.attributes, names));
  }

  std::vector<std::pair<std::string, double>> statedNear(const std::vector<std::string>& names) const {
    std::vector<std::pair<std::string, double>> stated;
    const auto add = [&](const std::string& where, double value) {
      if (value > 0) stated.emplace_back(where, value);
    };
    std::set<std::string> groups{group_};
    for (const auto& item : items_) {
      if (item.group != group_) continue;
      const std::string beside = parentOf(item.path);  // not those of the other channels of the group
      if (!dataset_ || beside == parentOf(dataset_->path) || beside == group_) add(item.path, numberOf(item, names));
      if (!isLong(item) || (dataset_ && &item != dataset_)) continue;
      add(item.path, attributeOf(item.array->attributes, names));
      groups.insert(parentOf(item.array->path));
    }
    for (const auto& group : groups)
      if (const auto* found = tree_.findGroup(group)) add(group, attributeOf(found->attributes, names));
    return stated;
  }

  static bool isOneOf(const std::string& name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), text::lowerCase(name)) != names.end();
  }

  // In SI units; 0: the item is no such number.
  double numberOf(const ArrayItem& item, const std::vector<std::string>& names) const {
    if (lengthOf(*item.array) != 1 || !isOneOf(item.name, names)) return 0;
    const auto values = numbersOf(*item.array);
    if (values.size() != 1 || !(values[0] > 0)) return 0;
    if (!item.unit.empty() && !text::isUnit(item.unit))
      throw FileError(path_, item.path, "has the unit '" + item.unit + "', which is not known",
                      "Give the value in the call");
    return values[0] * scaleOf(item.unit, item.name, Role::signal).factor;
  }

  static double attributeOf(const std::vector<results::Attribute>& attributes, const std::vector<std::string>& names) {
    for (const auto& attribute : attributes)
      if (isOneOf(attribute.name, names))
        if (const double number = results::numberAttribute(attributes, attribute.name); number > 0) return number;
    return 0;
  }

  const std::string& path_;
  const ArrayTree& tree_;
  const SignalFileOptions& options_;
  std::vector<ArrayItem> items_;
  const ArrayItem* dataset_ = nullptr;
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
