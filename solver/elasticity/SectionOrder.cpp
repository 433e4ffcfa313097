#include "elasticity/SectionOrder.h"

#include <algorithm>

#include "elasticity/SweptKernel.h"

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
  const int nodes = static_cast<int>(order.size());
  std::vector<int> place(nodes);
  for (int i = 0; i < nodes; ++i) place[order[i]] = i;
  SectionOrder result;
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
  for (int first = 0; first < nodes; first += rowBundle) {
    for (int i = first; i < std::min(first + rowBundle, nodes); ++i) upTo = std::max(upTo, newest[i] + 1);
    result.gatherUpTo.push_back(upTo);
    result.window = std::max(result.window, upTo - oldest[first]);
  }
  for (int& slot : result.slots) slot %= result.window;
  result.nodes = std::move(order);
  return result;
}

}  // namespace

SectionOrder sectionOrder(const std::vector<int>& rowStart, const std::vector<int>& columns) {
  SectionOrder best;
  for (int start = 0; start + 1 < static_cast<int>(rowStart.size()); ++start) {
    SectionOrder trial = follow(breadthFirst(rowStart, columns, start), rowStart, columns);
    if (best.nodes.empty() || trial.window < best.window) best = std::move(trial);
  }
  return best;
}

}  // namespace squat::elasticity
