#include "records/PandasFrames.h"

#include <algorithm>
#include <vector>

#include "text/Heading.h"

namespace squat::records {
namespace {

using results::Array;

std::size_t firstExtent(const Array& array) { return array.shape.empty() ? 0 : array.shape.front(); }

void addColumn(readers::ArrayColumns& found, const Array& array, const std::string& header, std::size_t run,
               std::size_t runs) {
  text::TableColumn column;
  const auto heading = text::headingOf(header);
  column.name = heading.name, column.unit = heading.unit;
  found.table.columns.push_back(std::move(column));
  found.places.push_back({array.path, run, runs, true});
}

// The index, as the time: dates are nanoseconds, counts are no time.
void addIndex(readers::ArrayColumns& found, const Array& index) {
  const std::string kind = results::textAttribute(index.attributes, "kind");
  if (kind.rfind("datetime64", 0) == 0) {
    addColumn(found, index, "time [ns]", 0, 1);
  } else if (std::holds_alternative<std::vector<double>>(index.values) ||
             std::holds_alternative<std::vector<float>>(index.values)) {
    const std::string name = results::textAttribute(index.attributes, "name");
    addColumn(found, index, name.empty() || name == "N." ? "time" : name, 0, 1);
  }
}

}  // namespace

std::vector<std::string> pandasGroups(const results::ArrayTree& tree) {
  std::vector<std::string> list;
  for (const auto& group : tree.groups)
    if (results::textAttribute(group.attributes, "pandas_type") == "frame") list.push_back(group.path);
  return list;
}

std::optional<readers::ArrayColumns> pandasColumns(const std::string& path, const results::ArrayTree& tree,
                                                   const std::string& group) {
  const Array* index = tree.find(group + "/axis1");
  if (!index) return std::nullopt;
  readers::ArrayColumns found;
  found.table.path = path;
  found.table.rowWord = "sample";
  found.samples = firstExtent(*index);
  addIndex(found, *index);
  for (int block = 0;; ++block) {
    const std::string name = group + "/block" + std::to_string(block);
    const Array *values = tree.find(name + "_values"), *items = tree.find(name + "_items");
    if (!values || !items) break;
    const auto* names = std::get_if<std::vector<std::string>>(&items->values);
    if (!names || firstExtent(*values) != found.samples || values->shape.size() != 2 ||
        values->shape[1] != names->size() || std::holds_alternative<std::vector<std::string>>(values->values))
      continue;
    for (std::size_t run = 0; run < names->size(); ++run) addColumn(found, *values, (*names)[run], run, names->size());
  }
  return found.table.columns.empty() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace squat::records
