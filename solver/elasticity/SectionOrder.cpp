#include "elasticity/SectionOrder.h"

#include <algorithm>
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

SectionOrder follow(std::vector<int> order, const std::vector<int>& rowStart, const std::vector<int>& columns) {
  SectionOrder result;
  const int nodes = static_cast<int>(order.size());
  result.nodes = std::move(order);
  for (int first = 0; first < nodes; first += rowBundle) result.bundleStart.push_back(first);
  result.bundleStart.push_back(nodes);
  std::vector<int> row(nodes);
  for (int i = 0; i < nodes; ++i) row[result.nodes[i]] = i;
  result.rowStart.push_back(0);
  std::vector<int> oldest(nodes), newest(nodes);
  for (int i = 0; i < nodes; ++i) {
    oldest[i] = newest[i] = i;
    for (int p = rowStart[result.nodes[i]]; p < rowStart[result.nodes[i] + 1]; ++p) {
      const int at = row[columns[p]];
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

// Nodes that wait for each other, and the row of the last.
struct Item {
  std::vector<int> nodes;
  int last = 0;
  bool isCluster = false;
};

// Clusters and nodes that stand alone, as they become ready.
std::vector<Item> itemsOf(const SectionOrder& order, const std::vector<std::vector<int>>& clusters) {
  std::vector<Item> items;
  std::vector<int> row(order.nodes.size());
  std::vector<unsigned char> taken(order.nodes.size(), 0);
  for (std::size_t i = 0; i < order.nodes.size(); ++i) row[order.nodes[i]] = static_cast<int>(i);
  for (const auto& cluster : clusters) {
    Item item{cluster, 0, true};
    for (const int n : cluster) taken[n] = 1, item.last = std::max(item.last, row[n]);
    items.push_back(std::move(item));
  }
  for (const int n : order.nodes)
    if (!taken[n]) items.push_back({{n}, row[n], false});
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.last < b.last; });
  return items;
}

// Slots that follow each other, the first that are free.
int takeSlots(std::vector<unsigned char>& taken, int count) {
  int from = 0;
  for (int i = 0; i < static_cast<int>(taken.size()) && i - from < count; ++i)
    if (taken[i]) from = i + 1;
  taken.resize(std::max(taken.size(), static_cast<std::size_t>(from + count)), 0);
  std::fill_n(taken.begin() + from, count, 1);
  return from;
}

// Goes through the rows as the kernels do (advanceGroup): slots are taken when the bundle of an item's first row begins
// and free again when the bundle ends in which its last node has been advanced.
void placeForces(const std::vector<Item>& items, SectionOrder& order) {
  const int nodes = static_cast<int>(order.nodes.size());
  std::vector<int> itemOf(nodes), slot(items.size(), -1), start;
  for (std::size_t k = 0; k < items.size(); ++k) {
    start.push_back(static_cast<int>(order.members.size()));
    for (const int n : items[k].nodes) itemOf[n] = static_cast<int>(k), order.members.push_back(n);
    if (items[k].isCluster) order.clusters.push_back({start.back(), static_cast<int>(order.members.size())});
  }
  start.push_back(nodes);
  std::vector<unsigned char> taken;
  std::size_t ready = 0, freed = 0;
  int advanced = 0;
  for (std::size_t b = 0; b + 1 < order.bundleStart.size(); ++b) {
    for (int i = order.bundleStart[b]; i < order.bundleStart[b + 1]; ++i)
      if (const int k = itemOf[order.nodes[i]]; slot[k] < 0)
        slot[k] = takeSlots(taken, static_cast<int>(items[k].nodes.size()));
    for (int i = order.bundleStart[b]; i < order.bundleStart[b + 1]; ++i) {
      while (ready < items.size() && items[ready].last <= i) ++ready;
      order.readyAfter.push_back(start[ready]);
      advanced = std::min(advanced + advancedPerRow, start[ready]);
    }
    for (; freed < ready && start[freed + 1] <= advanced; ++freed)
      std::fill_n(taken.begin() + slot[freed], items[freed].nodes.size(), 0);
  }
  order.forceSlots = static_cast<int>(taken.size());
  std::vector<int> slotOf(nodes);
  for (std::size_t k = 0; k < items.size(); ++k)
    for (int member = start[k]; member < start[k + 1]; ++member) {
      order.memberSlot.push_back(slot[k] + member - start[k]);
      slotOf[order.members[member]] = order.memberSlot.back();
    }
  for (const int n : order.nodes) order.rowSlot.push_back(slotOf[n]);
}

}  // namespace

SectionOrder sectionOrder(const std::vector<int>& rowStart, const std::vector<int>& columns,
                          const std::vector<std::vector<int>>& clusters) {
  for (const auto& cluster : clusters)
    if (cluster.size() > maximumRows) throw std::invalid_argument("a cluster of section nodes has too many of them");
  SectionOrder best;
  for (int start = 0; start + 1 < static_cast<int>(rowStart.size()); ++start) {
    SectionOrder trial = follow(breadthFirst(rowStart, columns, start), rowStart, columns);
    if (best.nodes.empty() || trial.window < best.window) best = std::move(trial);
  }
  placeForces(itemsOf(best, clusters), best);
  return best;
}

}  // namespace squat::elasticity
