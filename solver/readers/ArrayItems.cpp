#include "readers/ArrayItems.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "readers/ColumnRoles.h"
#include "results/Hdf5.h"
#include "text/Text.h"
#include "text/Units.h"
#include "text/Utf8Text.h"

namespace squat::readers {
namespace {

using results::Array;
using results::ArrayTree;

constexpr std::string_view referenced = "/#refs#/";  // what MATLAB 7.3 refers to
constexpr int deepest = 8;

template <std::size_t Count>
bool isOneOf(const std::string& name, const std::array<const char*, Count>& words) {
  return std::find(words.begin(), words.end(), text::lowerCase(name)) != words.end();
}
bool isWordOfUnit(const std::string& name) { return isOneOf(name, std::array{"unit", "units", "einheit"}); }
bool isWordOfName(const std::string& name) {
  return isOneOf(name, std::array{"name", "label", "title", "channel_name", "channelname"});
}
bool isWordOfValues(const std::string& name) {
  return isOneOf(name,
                 std::array{"values", "value", "data", "samples", "signal", "waveform", "y", "ydata", "y_values"});
}
bool isElement(const std::string& group) { return !group.empty() && (group.back() == ')' || group.back() == '}'); }

// The text of a MATLAB 7.3 text or of an array of one text; nothing for anything else.
std::optional<std::string> textIn(const Array& array) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&array.values))
    return texts->size() == 1 && results::numberAttribute(array.attributes, results::referencesAttribute) == 0
               ? std::optional(texts->front())
               : std::nullopt;
  if (results::textAttribute(array.attributes, "MATLAB_class") != "char") return std::nullopt;
  std::vector<std::uint16_t> letters;
  if (const auto* numbers = std::get_if<std::vector<std::int32_t>>(&array.values))
    for (const auto number : *numbers) letters.push_back(static_cast<std::uint16_t>(number));
  return text::utf8FromUtf16(letters);
}

// Beside a table of PyTables (pandas, format "table") stand the indices of its columns.
bool isIndexOfTable(const Array& array) { return array.path.find("/_i_table/") != std::string::npos; }

bool isNumeric(const Array& array) {
  return !std::holds_alternative<std::vector<std::string>>(array.values) &&
         results::textAttribute(array.attributes, "MATLAB_class") != "char" &&
         results::numberAttribute(array.attributes, "MATLAB_empty") == 0 && !isIndexOfTable(array) &&
         results::textAttribute(array.attributes, "NAME").rfind("This is a netCDF dimension but not", 0) != 0;
}

// The paths that users know of the objects that cells and arrays of structures refer to: of element 2 of the cell
// "/data" "/data{2}", of field "values" of the second of the structures "/signals" "/signals(2)/values".
class References {
 public:
  explicit References(const ArrayTree& tree) {
    for (const auto& array : tree.arrays) {
      if (results::numberAttribute(array.attributes, results::referencesAttribute) == 0) continue;
      const auto* targets = std::get_if<std::vector<std::string>>(&array.values);
      const bool isCell = results::textAttribute(array.attributes, "MATLAB_class") == "cell";
      for (std::size_t i = 0; targets && i < targets->size(); ++i) {
        const std::string number = std::to_string(i + 1);
        known_[(*targets)[i]] =
            isCell ? array.path + "{" + number + "}" : parentOf(array.path) + "(" + number + ")/" + nameOf(array.path);
      }
    }
  }

  // Empty: no user knows it.
  std::string knownPath(const std::string& path, int depth = 0) const {
    if (path.rfind(referenced, 0) != 0) return path;
    if (depth > deepest) return {};
    const std::size_t end = path.find_first_of("/{(", referenced.size());  // of the object's own name
    const auto found = known_.find(path.substr(0, end));
    if (found == known_.end()) return {};
    const std::string known = knownPath(found->second, depth + 1);
    return known.empty() || end == std::string::npos ? known : known + path.substr(end);
  }

 private:
  std::map<std::string, std::string> known_;
};

// "s" of "seconds since 2024-05-01": where times begin does not matter here.
std::string unitOf(const Array& array) {
  for (const char* name : {"unit", "units", "Unit", "Units", "unit_string"})
    if (std::string unit = results::textAttribute(array.attributes, name); !unit.empty()) {
      const std::size_t since = unit.find(" since ");
      return since != std::string::npos && text::isUnit(unit.substr(0, since)) ? unit.substr(0, since) : unit;
    }
  return {};
}

results::Packing packingOf(const Array& array) {
  const results::Packing none;
  const auto stated = [&](const char* name, double otherwise) {
    return results::numberAttribute(array.attributes, name, otherwise);
  };
  return {stated("scale_factor", 1), stated("add_offset", 0),
          stated("_FillValue", stated("missing_value", none.missing))};
}

// The index of a pandas table is its time where it is a number or a date (ns since 1970), else the number of the row.
// Returns false where it is to be left out.
bool nameIndex(ArrayItem& item) {
  const auto& attributes = item.array->attributes;
  if (item.name != "index" || results::textAttribute(attributes, "CLASS") != "TABLE") return true;
  const std::string kind = results::textAttribute(attributes, "index_kind");
  item.name = "time";
  if (kind.rfind("datetime64", 0) == 0) item.unit = "ns";
  return kind == "float" || kind.rfind("datetime64", 0) == 0;
}

struct Words {
  std::string name, unit;  // of the channel, as texts in its group say
};

bool isSignal(const ArrayItem& item) {
  return lengthOf(*item.array) > 1 && roleOf(item.name, item.unit) == Role::signal;
}
bool isAxis(const ArrayItem& item) { return lengthOf(*item.array) > 1 && roleOf(item.name, item.unit) != Role::signal; }

// A group with one signal, which has the name of values in general: a channel.
struct Channel {
  std::size_t signal = 0;
  int signals = 0, axes = 0;
};

class Joining {
 public:
  Joining(std::vector<ArrayItem>& items, const std::map<std::string, Words>& words) : items_(items) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      auto& channel = channels_[items[i].group];
      if (isSignal(items[i])) channel.signal = i, ++channel.signals;
      if (isAxis(items[i])) ++channel.axes;
    }
    std::erase_if(channels_, [&](const auto& entry) {
      return entry.first.empty() || entry.second.signals != 1 ||
             !(isWordOfValues(items_[entry.second.signal].name) || isElement(entry.first));
    });
    nameByWords(words);
  }

  // Channels of one group, or one beside its axes, stand there; channels with axes of their own stay apart.
  void join() {
    std::map<std::string, int> together, withAxes;
    for (const auto& [group, channel] : channels_) {
      ++together[parentOf(group)];
      if (channel.axes > 0) ++withAxes[parentOf(group)];
    }
    std::set<std::string> axesAbove;
    for (const auto& item : items_)
      if (isAxis(item)) axesAbove.insert(item.group);
    std::set<std::string> joined;
    for (const auto& [group, channel] : channels_) {
      const std::string above = parentOf(group);
      if (withAxes[above] > 0 || (together[above] < 2 && !axesAbove.count(above))) continue;
      joined.insert(group);
      if (!named_.count(group)) items_[channel.signal].name = nameOf(group);
    }
    for (auto& item : items_)
      if (joined.count(item.group)) item.group = parentOf(item.group);
  }

 private:
  void nameByWords(const std::map<std::string, Words>& words) {
    for (const auto& [group, channel] : channels_) {
      const auto found = words.find(group);
      if (found == words.end()) continue;
      auto& signal = items_[channel.signal];
      if (signal.unit.empty()) signal.unit = found->second.unit;
      if (!found->second.name.empty()) signal.name = found->second.name, named_.insert(group);
    }
  }

  std::vector<ArrayItem>& items_;
  std::map<std::string, Channel> channels_;  // by their group
  std::set<std::string> named_;
};

}  // namespace

std::string parentOf(const std::string& path) { return path.substr(0, path.rfind('/')); }
std::string nameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// MATLAB writes a row vector as n x 1.
std::size_t lengthOf(const Array& array) {
  std::size_t length = 0;
  for (const std::size_t extent : array.shape) length = std::max(length, extent);
  return array.shape.empty() ? 1 : length;
}

bool isNested(const Array& array) {
  return std::count_if(array.shape.begin(), array.shape.end(), [](auto extent) { return extent > 1; }) > 2;
}

std::vector<ArrayItem> itemsOf(const ArrayTree& tree, Channels channels) {
  const References references(tree);
  std::vector<ArrayItem> items;
  std::map<std::string, Words> words;
  for (const auto& array : tree.arrays) {
    const std::string path = references.knownPath(array.path);
    if (path.empty()) continue;
    if (const auto said = textIn(array)) {
      if (isWordOfUnit(nameOf(path))) words[parentOf(path)].unit = *said;
      if (isWordOfName(nameOf(path)) && words[parentOf(path)].name.empty()) words[parentOf(path)].name = *said;
    } else if (isNumeric(array)) {
      std::string name = nameOf(path);
      const std::string_view slash = results::slashInName;
      for (auto at = name.find(slash); at != std::string::npos; at = name.find(slash))
        name.replace(at, slash.size(), "/");
      ArrayItem item{&array, path, parentOf(path), std::move(name), unitOf(array), packingOf(array)};
      if (nameIndex(item)) items.push_back(std::move(item));
    }
  }
  Joining joining(items, words);
  if (channels == Channels::joined) joining.join();
  return items;
}

}  // namespace squat::readers
