#include "geometry/SectionMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ElementaryFunctions.h"

namespace squat::geometry {

namespace {

double cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

double distance(const Point2& a, const Point2& b) { return elementary::hypot(a[0] - b[0], a[1] - b[1]); }

}  // namespace

double scaledJacobian(const SectionMesh& mesh, int quad) {
  const auto& q = mesh.quads[quad];
  double worst = 1;
  for (int i = 0; i < 4; ++i) {
    const auto &o = mesh.nodes[q[i]], &next = mesh.nodes[q[(i + 1) % 4]], &last = mesh.nodes[q[(i + 3) % 4]];
    worst = std::min(worst, cross(o, next, last) / (distance(o, next) * distance(o, last)));
  }
  return worst;
}

double aspectRatio(const SectionMesh& mesh, int quad) {
  const auto& q = mesh.quads[quad];
  double shortest = std::numeric_limits<double>::max(), longest = 0;
  for (int i = 0; i < 4; ++i) {
    const double edge = distance(mesh.nodes[q[i]], mesh.nodes[q[(i + 1) % 4]]);
    shortest = std::min(shortest, edge);
    longest = std::max(longest, edge);
  }
  return longest / shortest;
}

std::vector<int> nodesWhere(const SectionMesh& mesh, const std::function<bool(const Point2&)>& predicate, int axis) {
  std::vector<int> found;
  for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
    if (predicate(mesh.nodes[n])) found.push_back(n);
  std::sort(found.begin(), found.end(), [&](int p, int q) { return mesh.nodes[p][axis] < mesh.nodes[q][axis]; });
  return found;
}

SectionIntegrals sectionIntegrals(const SectionMesh& mesh) {
  SectionIntegrals result;
  double firstB = 0, firstC = 0, secondB = 0, secondC = 0;
  const double gauss = 1 / std::sqrt(3.0);
  for (const auto& quad : mesh.quads) {
    for (int k = 0; k < 4; ++k) {
      const double xi = (k % 2 ? gauss : -gauss), eta = (k / 2 ? gauss : -gauss);
      const double shape[4] = {(1 - xi) * (1 - eta) / 4, (1 + xi) * (1 - eta) / 4, (1 + xi) * (1 + eta) / 4,
                               (1 - xi) * (1 + eta) / 4};
      const double dXi[4] = {-(1 - eta) / 4, (1 - eta) / 4, (1 + eta) / 4, -(1 + eta) / 4};
      const double dEta[4] = {-(1 - xi) / 4, -(1 + xi) / 4, (1 + xi) / 4, (1 - xi) / 4};
      double b = 0, c = 0, bXi = 0, cXi = 0, bEta = 0, cEta = 0;
      for (int i = 0; i < 4; ++i) {
        const auto& point = mesh.nodes[quad[i]];
        b += shape[i] * point[0], c += shape[i] * point[1];
        bXi += dXi[i] * point[0], cXi += dXi[i] * point[1];
        bEta += dEta[i] * point[0], cEta += dEta[i] * point[1];
      }
      const double area = bXi * cEta - bEta * cXi;
      result.area += area;
      firstB += area * b, firstC += area * c, secondB += area * b * b, secondC += area * c * c;
    }
  }
  result.centroidB = firstB / result.area, result.centroidC = firstC / result.area;
  result.momentBB = secondB - result.area * result.centroidB * result.centroidB;
  result.momentCC = secondC - result.area * result.centroidC * result.centroidC;
  return result;
}

int BlockMesher::node(const Point2& point) {
  for (int n = 0; n < static_cast<int>(mesh_.nodes.size()); ++n)
    if (distance(mesh_.nodes[n], point) < tolerance_) return n;
  mesh_.nodes.push_back(point);
  return static_cast<int>(mesh_.nodes.size()) - 1;
}

void BlockMesher::addBlock(const std::vector<Point2>& bottom, const std::vector<Point2>& top,
                           const std::vector<Point2>& left, const std::vector<Point2>& right, int coarseRows) {
  const int n = static_cast<int>(bottom.size()) - 1, m = static_cast<int>(left.size()) - 1;
  // Normalised positions along each edge steer the interpolation, so that gradings carry into the block.
  const auto lengths = [](const std::vector<Point2>& edge) {
    std::vector<double> s(edge.size(), 0);
    for (std::size_t i = 1; i < edge.size(); ++i) s[i] = s[i - 1] + distance(edge[i - 1], edge[i]);
    for (auto& value : s) value /= s.back();
    return s;
  };
  const auto sBottom = lengths(bottom), sTop = lengths(top), sLeft = lengths(left), sRight = lengths(right);
  std::vector<std::vector<int>> ids(m + 1);
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i <= n; i += j <= coarseRows && coarseRows > 0 ? 3 : 1) {
      // Parameters at the crossing of the two straight lines in the unit square.
      const double a = sBottom[i], da = sTop[i] - a, e = sLeft[j], de = sRight[j] - e;
      const double u = (a + da * e) / (1 - da * de), v = e + de * u;
      Point2 p;
      for (int k = 0; k < 2; ++k) {
        const double edges = (1 - v) * bottom[i][k] + v * top[i][k] + (1 - u) * left[j][k] + u * right[j][k];
        const double corners =
            (1 - u) * (1 - v) * bottom[0][k] + u * (1 - v) * bottom[n][k] + (1 - u) * v * top[0][k] + u * v * top[n][k];
        p[k] = edges - corners;
      }
      if (j == 0) p = bottom[i];
      if (j == m) p = top[i];
      if (i == 0) p = left[j];
      if (i == n) p = right[j];
      ids[j].push_back(node(p));
    }
  }
  for (int j = 0; j < m; ++j) {
    const auto &below = ids[j], &above = ids[j + 1];
    if (below.size() < above.size()) {
      addJoiningRow(below, above);
      continue;
    }
    for (std::size_t i = 0; i + 1 < below.size(); ++i)
      mesh_.quads.push_back({below[i], below[i + 1], above[i + 1], above[i]});
  }
}

// Three quads above, one below: two nodes within make a trapezoid on the coarse edge and three quads on it. They stand
// a quarter higher than a fine quad is wide: corners of 39 degrees where the row is a rectangle.
void BlockMesher::addJoiningRow(const std::vector<int>& below, const std::vector<int>& above) {
  for (std::size_t k = 0; k + 1 < below.size(); ++k) {
    const int left = below[k], right = below[k + 1];
    const int* top = above.data() + 3 * k;
    const auto inner = [&](int column) {
      const auto &a = mesh_.nodes[left], &b = mesh_.nodes[right], &up = mesh_.nodes[top[column]];
      const Point2 foot{a[0] + column / 3.0 * (b[0] - a[0]), a[1] + column / 3.0 * (b[1] - a[1])};
      const double part = std::min(0.5, 1.25 / 3 * distance(a, b) / distance(foot, up));
      return node({foot[0] + part * (up[0] - foot[0]), foot[1] + part * (up[1] - foot[1])});
    };
    const int first = inner(1), second = inner(2);
    mesh_.quads.push_back({left, right, second, first});
    mesh_.quads.push_back({left, first, top[1], top[0]});
    mesh_.quads.push_back({first, second, top[2], top[1]});
    mesh_.quads.push_back({second, right, top[3], top[2]});
  }
}

void BlockMesher::addStrip(const std::vector<Point2>& inner, const std::vector<Point2>& outer, int rows) {
  std::vector<int> before, here;
  for (int row = 0; row <= rows; ++row, before.swap(here)) {
    const double share = static_cast<double>(row) / rows;
    here.clear();
    for (std::size_t j = 0; j < inner.size(); ++j) {
      const auto &a = inner[j], &b = outer[j];
      here.push_back(node(row == rows ? b : Point2{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])}));
    }
    for (std::size_t j = 0; row > 0 && j + 1 < here.size(); ++j)
      mesh_.quads.push_back({before[j], here[j], here[j + 1], before[j + 1]});
  }
}

void BlockMesher::mirror() {
  const auto quads = mesh_.quads;
  for (const auto& quad : quads) {
    std::array<int, 4> mirrored;
    for (int i = 0; i < 4; ++i) {
      const Point2 p = mesh_.nodes[quad[3 - i]];
      mirrored[i] = node({-p[0], p[1]});
    }
    mesh_.quads.push_back(mirrored);
  }
}

std::vector<double> gradedSpacing(int count, double first) {
  // Solve first * (1 + q + ... + q^(count-1)) = 1 for the growth q by bisection.
  double low = 1e-3, high = 1e3;
  const auto total = [&](double q) {
    double sum = 0, power = first;
    for (int i = 0; i < count; ++i, power *= q) sum += power;
    return sum;
  };
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(low * high);
    (total(middle) < 1 ? low : high) = middle;
  }
  const double q = std::sqrt(low * high);
  std::vector<double> s(count + 1, 0);
  double power = first;
  for (int i = 1; i <= count; ++i, power *= q) s[i] = s[i - 1] + power;
  for (auto& value : s) value /= s.back();
  return s;
}

int intervalsFor(double length, double first, double growth, double largest) {
  double covered = 0, size = first;
  int count = 0;
  while (covered < length * (1 - 1e-9) && count < 100000) {
    covered += size;
    size = std::min(size * growth, largest);
    ++count;
  }
  return std::max(count, 1);
}

}  // namespace squat::geometry
