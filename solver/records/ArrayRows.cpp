#include "records/ArrayRows.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <utility>

#include "core/Errors.h"
#include "rcmdx/RecordColumns.h"
#include "readers/ArrayFile.h"
#include "readers/ArrayItems.h"
#include "readers/ArraySignals.h"
#include "records/PandasFrames.h"
#include "results/Hdf5.h"
#include "results/ResultTree.h"
#include "signals/SignalCatalogue.h"
#include "text/Text.h"

namespace squat::records {
namespace {

// The group whose longest dataset is the longest of all; empty where the file has an aba, or two are equally long.
std::string longestGroup(const results::ArrayTree& tree) {
  std::map<std::string, std::size_t> longest;
  for (const auto& item : readers::itemsOf(tree)) {
    if (text::lowerCase(item.name) == signals::names::axleBox) return {};
    auto& maximum = longest[item.group];
    maximum = std::max(maximum, readers::lengthOf(*item.array));
  }
  if (longest.empty()) return {};
  const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto maximum = std::max_element(longest.begin(), longest.end(), less);
  const auto as =
      std::count_if(longest.begin(), longest.end(), [&](const auto& g) { return g.second == maximum->second; });
  return as > 1 ? std::string() : maximum->first.empty() ? "/" : maximum->first;
}

std::string groupNamed(const std::string& object) {
  std::string group = object.empty() || object.front() == '/' ? object : "/" + object;
  while (group.size() > 1 && group.back() == '/') group.pop_back();
  return group;
}

}  // namespace

ArrayRows::~ArrayRows() = default;

ArrayRows::ArrayRows(std::string path, const readers::SignalFileOptions& options) : path_(std::move(path)) {
  const auto tree = readers::listArrays(path_);
  truncation_ = results::textAttribute(tree.attributes, results::truncationAttribute);
  if (rcmdx::isRcmDx(tree)) {
    takeSession(tree, options);
    readHead();
    return;
  }
  auto own = options;
  if (own.object.empty()) own.object = longestGroup(tree);
  object_ = own.object;
  auto frame = pandasColumns(path_, tree, groupNamed(own.object));
  auto found = frame ? std::move(*frame) : readers::columnsOf(path_, tree, own);
  head_ = std::move(found.table);
  places_ = std::move(found.places);
  samples_ = found.samples;
  rate = found.options.rate;
  speed = found.options.speed;
  signalColumn = found.options.column;
  if (results::textAttribute(tree.attributes, "schema") == results::kResultSchema &&
      results::numberAttribute(tree.attributes, "complete", 1) != 1)
    notes.push_back("the run is not complete: what came later is missing");
  readHead();
}

// A recording of RCM-DX: its times and positions stand apart from its channels, and are computed for each sample.
void ArrayRows::takeSession(const results::ArrayTree& tree, const readers::SignalFileOptions& options) {
  session_ = std::make_unique<rcmdx::RecordColumns>(
      rcmdx::recordColumns(path_, tree, {options.object, options.positionColumn}));
  object_ = session_->source().path;
  head_ = session_->table();
  samples_ = session_->samples();
  notes = session_->notes();
}

std::unique_ptr<results::ArrayStream> ArrayRows::open(const std::vector<std::size_t>& columns) const {
  if (session_) return session_->open(columns);
  std::vector<results::ArrayColumn> places;
  for (const std::size_t c : columns) places.push_back(places_[c]);
  return readers::streamArrays(path_, places, samples_);
}

// The first values of every column, for what depends on them.
void ArrayRows::readHead() {
  std::vector<std::size_t> all(head_.columns.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto stream = open(all);
  std::vector<std::vector<double>> columns;
  stream->next(columns);
  for (std::size_t c = 0; c < head_.columns.size() && c < columns.size(); ++c) {
    columns[c].resize(std::min(columns[c].size(), headRows));
    head_.columns[c].values = std::move(columns[c]);
  }
}

std::string ArrayRows::structure() const {
  return std::string(session_ ? "RCM-DX" : "arrays (HDF5 or MATLAB)") +
         (object_.empty() ? std::string() : ", in " + object_) + ", " + std::to_string(samples_) + " samples";
}

void ArrayRows::choose(std::vector<std::size_t> columns) { stream_ = open(columns); }

bool ArrayRows::next(std::size_t maximum, Rows& rows) {
  for (auto& column : rows.columns) column.clear();
  while (rows.size() < maximum && stream_->next(rows.columns)) continue;
  read_ += rows.size();
  return rows.size() > 0;
}

double ArrayRows::fraction() const {
  return samples_ ? static_cast<double>(read_) / static_cast<double>(samples_) : 1.0;
}

}  // namespace squat::records
