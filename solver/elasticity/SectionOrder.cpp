#include "elasticity/SectionOrder.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace squat::elasticity {

namespace {

// Nodes in the order of their distance from `start`, those with few neighbours first; parts that do not touch follow.
std::vector<int> breadthFirst(const std::vector<int>& rowStart, const std::vector<int>& columns, int start) {
  const int nodes = static_cast<int>(rowStart.size()) - 1;
  const auto degree = [&](int n) { return rowStart[n + 1] - rowStart[n]; };
  std::vector<int> order;
  std::vector<unsigned char> seen(nodes, 0);
  const auto visit = [&](int n) {
    if (!seen[n]) order.push_back(n), seen[n] = 1;
  };
  visit(start);
  for (int rest = 0, next = 0; next < nodes; ++next) {
    while (next == static_cast<int>(order.size())) visit(rest++);
    const auto from = static_cast<std::ptrdiff_t>(order.size());
    const int n = order[next];
    for (int p = rowStart[n]; p < rowStart[n + 1]; ++p) visit(columns[p]);
    std::stable_sort(order.begin() + from, order.end(), [&](int a, int b) { return degree(a) < degree(b); });
  }
  return order;
}

struct Item {
  std::vector<int> nodes;
  bool isCluster = false;
};

// Clusters and nodes that stand alone.
std::vector<Item> itemsOf(std::size_t nodes, const std::vector<std::vector<int>>& clusters) {
  std::vector<Item> items;
  std::vector<unsigned char> taken(nodes, 0);
  for (const auto& cluster : clusters) {
    items.push_back({cluster, true});
    for (const int n : cluster) taken[static_cast<std::size_t>(n)] = 1;
  }
  for (std::size_t n = 0; n < nodes; ++n)
    if (!taken[n]) items.push_back({{static_cast<int>(n)}, false});
  return items;
}

// Pairs of items that hold a pair of nodes: row starts and columns.
void pairsOfItems(const std::vector<Item>& items, const std::vector<int>& rowStart, const std::vector<int>& columns,
                  std::vector<int>& itemStart, std::vector<int>& itemColumns) {
  std::vector<int> itemOf(rowStart.size() - 1);
  for (std::size_t i = 0; i < items.size(); ++i)
    for (const int n : items[i].nodes) itemOf[n] = static_cast<int>(i);
  itemStart.assign(1, 0);
  for (const auto& item : items) {
    std::set<int> others;
    for (const int n : item.nodes)
      for (int p = rowStart[n]; p < rowStart[n + 1]; ++p) others.insert(itemOf[columns[p]]);
    itemColumns.insert(itemColumns.end(), others.begin(), others.end());
    itemStart.push_back(static_cast<int>(itemColumns.size()));
  }
}

SectionOrder follow(const std::vector<Item>& items, const std::vector<int>& rowStart, const std::vector<int>& columns) {
  SectionOrder result;
  auto& order = result.nodes;
  result.bundleStart.push_back(0);
  for (const auto& item : items) {
    const int at = static_cast<int>(order.size()), end = at + static_cast<int>(item.nodes.size());
    if (at > result.bundleStart.back() && end - result.bundleStart.back() > rowBundle) result.bundleStart.push_back(at);
    if (item.isCluster) result.clusters.push_back({at, end});
    order.insert(order.end(), item.nodes.begin(), item.nodes.end());
  }
  const int nodes = static_cast<int>(order.size());
  result.bundleStart.push_back(nodes);
  std::vector<int> place(nodes);
  for (int i = 0; i < nodes; ++i) place[order[i]] = i;
  result.rowStart.push_back(0);
  std::vector<int> oldest(nodes), newest(nodes);
  for (int i = 0; i < nodes; ++i) {
    oldest[i] = newest[i] = i;
    for (int p = rowStart[order[i]]; p < rowStart[order[i] + 1]; ++p) {
      const int at = place[columns[p]];
      oldest[i] = std::min(oldest[i], at), newest[i] = std::max(newest[i], at);
      result.pairs.push_back(p), result.slots.push_back(at);
    }
    result.rowStart.push_back(static_cast<int>(result.pairs.size()));
  }
  for (int i = nodes - 2; i >= 0; --i) oldest[i] = std::min(oldest[i], oldest[i + 1]);
  int upTo = 0;
  for (std::size_t b = 0; b + 1 < result.bundleStart.size(); ++b) {
    const int first = result.bundleStart[b];
    for (int i = first; i < result.bundleStart[b + 1]; ++i)
      result.gatherUpTo.push_back(upTo = std::max(upTo, newest[i] + 1));
    result.window = std::max(result.window, upTo - oldest[first]);
  }
  for (int& slot : result.slots) slot %= result.window;
  return result;
}

}  // namespace

SectionOrder sectionOrder(const std::vector<int>& rowStart, const std::vector<int>& columns,
                          const std::vector<std::vector<int>>& clusters) {
  for (const auto& cluster : clusters)
    if (cluster.size() > mostRows) throw std::invalid_argument("a cluster of section nodes has too many of them");
  const auto items = itemsOf(rowStart.size() - 1, clusters);
  std::vector<int> itemStart, itemColumns;
  pairsOfItems(items, rowStart, columns, itemStart, itemColumns);
  SectionOrder best;
  for (int start = 0; start < static_cast<int>(items.size()); ++start) {
    std::vector<Item> visited;
    for (const int i : breadthFirst(itemStart, itemColumns, start))
      visited.push_back(items[static_cast<std::size_t>(i)]);
    SectionOrder trial = follow(visited, rowStart, columns);
    if (best.nodes.empty() || trial.window < best.window) best = std::move(trial);
  }
  return best;
}

}  // namespace squat::elasticity
